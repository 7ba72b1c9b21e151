#include "host/passes/shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/vulkan/pipeline.h"
#include "host/vulkan/rendering.h"
#include "spirv/shadow.frag.h"
#include "spirv/shadow.vert.h"

namespace demos {
namespace {

/// How far beyond the nearest opaque thing the first cascade reaches [m]; each of the others by a factor
/// more.
constexpr double firstReachM = 14, leastFactor = 2.9;
/// Cascades end there: farther shadows are left out, so that near ones are sharp [m].
constexpr double farthestShadowM = 6500;
/// Plains are lower, beside how wide they are: they shade nothing that cascades would have to reach for.
constexpr double riseOfPlains = 0.01;
constexpr VkExtent2D mapExtent = {2 * ShadowPass::cascadeSize, 2 * ShadowPass::cascadeSize};
constexpr VkFormat mapFormat = VK_FORMAT_D32_SFLOAT;

struct Range {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

/// Axes of the sun's view: right, up and towards the sun.
struct LightAxes {
    glm::dvec3 right, up, toSun;
    glm::dvec3 of(const glm::dvec3& p) const {
        return {glm::dot(p, right), glm::dot(p, up), glm::dot(p, toSun)};
    }
};

/// Turned so that the view runs along one side of the map, which wastes the least of it.
LightAxes lightAxes(const glm::dvec3& toSun, const Camera& camera) {
    LightAxes axes;
    axes.toSun = toSun;
    glm::dvec3 right = glm::cross(camera.forward, toSun);
    if (glm::length(right) < 1e-3) right = glm::cross(camera.up, toSun);
    axes.right = glm::normalize(right);
    axes.up = glm::cross(toSun, axes.right);
    return axes;
}

double distanceTo(const glm::dvec3& point, const Camera& camera) {
    const glm::dvec3 p = point - camera.eye;
    return camera.parallel() ? glm::dot(p, camera.forward) : glm::length(p);
}

/// From the eye to what is opaque [m].
struct Distances {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
};

bool isPlain(const Box& box) {
    Range range;
    for (const glm::dvec3& corner : box.corners) range.add(corner);
    const glm::dvec3 size = range.high - range.low;
    return size.y < riseOfPlains * std::max(size.x, size.z);
}

Distances distancesTo(const std::vector<Box>& boxes, const Camera& camera) {
    Distances found;
    for (const Box& box : boxes) {
        const bool counts = !isPlain(box);
        glm::dvec3 centre(0);
        for (const glm::dvec3& corner : box.corners) {
            centre += corner / 8.0;
            if (counts) found.farthest = std::max(found.farthest, distanceTo(corner, camera));
        }
        const double radius = glm::length(box.corners[0] - centre);
        found.nearest = std::min(found.nearest, std::max(0.0, distanceTo(centre, camera) - radius));
    }
    return found;
}

/// Of what the camera sees at a distance, from the eye.
std::array<glm::dvec3, 4> cornersAt(double distance, const Camera& camera) {
    std::array<glm::dvec3, 4> corners;
    for (size_t i = 0; i < 4; ++i) corners[i] = camera.seenAt(i & 1 ? 1 : -1, i & 2 ? 1 : -1, distance);
    return corners;
}

/// What the camera sees between two distances, in the sun's axes.
Range seenBetween(double from, double to, const Camera& camera, const LightAxes& axes) {
    Range seen;
    for (const double distance : {from, to})
        for (const glm::dvec3& corner : cornersAt(distance, camera)) seen.add(axes.of(corner));
    return seen;
}

/// What is opaque, and where the shear puts what of it is under water, down to `deepest` [m].
struct Casters {
    Range bounds;
    double deepest = 0;
};

Casters castersAmong(const std::vector<Box>& boxes, const Camera& camera, const LightAxes& axes,
                     const BentSun& bent) {
    Casters casters;
    for (const Box& box : boxes) {
        const bool some = shareOf(bent, box.corners).some;
        for (const glm::dvec3& corner : box.corners) {
            const double depth = some ? std::max(bent.depthOf(corner), 0.0) : 0;
            casters.bounds.add(axes.of(corner - camera.eye));
            casters.bounds.add(axes.of(corner - camera.eye + depth * bent.shear));
            casters.deepest = std::max(casters.deepest, depth);
        }
    }
    return casters;
}

/// Widens what is seen between two distances by where the shear puts it: moved as a whole, by the most that
/// any of it is.
Range withSheared(const Range& seen, double from, double to, const Casters& casters, const Camera& camera,
                  const LightAxes& axes, const BentSun& bent) {
    double deepest = 0;
    for (const double distance : {from, to})
        for (const glm::dvec3& corner : cornersAt(distance, camera))
            deepest = std::max(deepest, bent.depthOf(camera.eye + corner));
    const glm::dvec3 shift = axes.of(std::min(casters.deepest, deepest) * bent.shear);
    return {glm::min(seen.low, seen.low + shift), glm::max(seen.high, seen.high + shift)};
}

ShadowFit fitCascade(const Range& bounds, const Range& seen, const LightAxes& axes) {
    ShadowFit fit;
    glm::dvec3 low = glm::max(bounds.low, seen.low), high = glm::min(bounds.high, seen.high);
    if (!(high.x > low.x && high.y > low.y)) return fit;
    // Every caster counts, however far towards the sun; the margin keeps the filter inside the map.
    low.z = bounds.low.z - 1;
    high.z = bounds.high.z + 1;
    const glm::dvec2 margin = (glm::dvec2(high) - glm::dvec2(low)) * (8.0 / ShadowPass::cascadeSize) + 1e-3;
    low -= glm::dvec3(margin, 0);
    high += glm::dvec3(margin, 0);
    const glm::dvec3 extent = high - low;
    fit.enabled = true;
    fit.texelM = std::max(extent.x, extent.y) / ShadowPass::cascadeSize;
    const glm::dmat4 rows(glm::dvec4(2 / extent.x * axes.right, -(low.x + high.x) / extent.x),
                          glm::dvec4(2 / extent.y * axes.up, -(low.y + high.y) / extent.y),
                          glm::dvec4(-1 / extent.z * axes.toSun, high.z / extent.z), glm::dvec4(0, 0, 0, 1));
    fit.clipFromEye = glm::mat4(glm::transpose(rows));
    return fit;
}

void setTile(VkCommandBuffer commands, uint32_t cascade) {
    constexpr uint32_t size = ShadowPass::cascadeSize;
    const VkOffset2D corner = {static_cast<int32_t>((cascade & 1) * size),
                               static_cast<int32_t>((cascade >> 1) * size)};
    const VkViewport viewport = {
        static_cast<float>(corner.x), static_cast<float>(corner.y), size, size, 0, 1};
    const VkRect2D scissor = {corner, {size, size}};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

PipelineDesc shadowPipeline() {
    PipelineDesc desc;
    desc.vertex = shadow_vert;
    desc.depthFormat = mapFormat;
    desc.depthCompare = VK_COMPARE_OP_LESS_OR_EQUAL;
    desc.slopeBias = 1.25f;
    return desc;
}

} // namespace

ShadowFits fitShadows(const std::vector<Box>& boxes, const Camera& camera, const glm::dvec3& toSun,
                      const BentSun& bent) {
    ShadowFits fits;
    if (boxes.empty() || toSun.y <= 0) return fits;
    const LightAxes axes = lightAxes(toSun, camera);
    const Distances distances = distancesTo(boxes, camera);
    const Casters casters = castersAmong(boxes, camera, axes, bent);
    // Mountains are in shadow, too: the last cascade reaches the farthest of them.
    const double farthest = std::max(distances.nearest, std::min(distances.farthest, farthestShadowM));
    const double factor = std::max(
        leastFactor, std::pow((farthest - distances.nearest) / firstReachM, 1.0 / (shadowCascades - 1)));
    double from = distances.nearest, reach = firstReachM;
    for (uint32_t i = 0; i < shadowCascades; ++i, reach *= factor) {
        const double to = distances.nearest + reach;
        Range seen = seenBetween(from, to, camera, axes);
        if (bent.bends) seen = withSheared(seen, from, to, casters, camera, axes, bent);
        fits[i] = fitCascade(casters.bounds, seen, axes);
        from = to;
    }
    return fits;
}

bool ShadowPass::create(const Device& device, const Layouts& layouts, Error& error) {
    ImageDesc image;
    image.format = mapFormat;
    image.extent = mapExtent;
    image.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    SamplerDesc sampler;
    sampler.compare = true;
    PipelineDesc cut = shadowPipeline();
    cut.fragment = shadow_frag;
    return createImage(device, image, map_, error) && createArrayView(device, map_, arrayView_, error) &&
           createSampler(device, sampler, sampler_, error) &&
           createPipeline(device, layouts.pipeline.get(), cut, cut_, error);
}

bool ShadowPass::prepare(const Device& device, const Layouts& layouts, const MeshSet& meshes, Error& error) {
    const PipelineDesc whole = shadowPipeline();
    PipelineDesc pierced = whole;
    pierced.fragment = shadow_frag;
    return pipelines_.make(device, layouts.pipeline.get(), whole, {0}, error) &&
           pipelines_.make(device, layouts.pipeline.get(), pierced, featuresOf(meshes), error);
}

void ShadowPass::record(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                        const glm::dvec3& eye, const ShadowFits& fits, const BentSun& bent) const {
    constexpr VkPipelineStageFlags2 tests =
        VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkPipelineStageFlags2 readers =
        VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT; // castCaustics()
    imageBarrier(commands, map_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, readers,
                 0, tests,
                 VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                     VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT);
    beginRendering(commands, mapExtent, nullptr, VK_ATTACHMENT_LOAD_OP_DONT_CARE, map_,
                   VK_ATTACHMENT_LOAD_OP_CLEAR, 1);
    for (uint32_t i = 0; i < shadowCascades; ++i) {
        if (!fits[i].enabled) continue;
        setTile(commands, i);
        MeshPipelines pipelines = {&pipelines_, false, i, glm::dmat4(fits[i].clipFromEye)};
        if (bent.bends) {
            pipelines.cut = cut_.get();
            pipelines.sun = &bent;
            pipelines.casts = Casts::straight;
        }
        drawMeshes(commands, layouts, meshes, eye, pipelines);
        if (!bent.bends) continue;
        pipelines.casts = Casts::bent;
        pipelines.clipFromEye *= shearFromEye(bent, eye);
        drawMeshes(commands, layouts, meshes, eye, pipelines);
    }
    vkCmdEndRendering(commands);
    imageBarrier(
        commands, map_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
        tests, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, readers, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

void setShadowUniforms(const ShadowFits& fits, FrameUniforms& uniforms) {
    for (uint32_t i = 0; i < shadowCascades; ++i) {
        uniforms.shadowFromEye[i] = fits[i].clipFromEye;
        uniforms.shadowTexelM[static_cast<int>(i)] =
            fits[i].enabled ? static_cast<float>(fits[i].texelM) : 0.0f;
    }
    uniforms.shadow = glm::vec4(1.0f / ShadowPass::cascadeSize, 0, 0, 0);
}

} // namespace demos
