#include "host/shadow.h"

#include <algorithm>
#include <limits>

#include "host/pipeline.h"
#include "host/rendering.h"
#include "spirv/shadow.frag.h"
#include "spirv/shadow.vert.h"

namespace demos {
namespace {

/// How far beyond the nearest opaque thing shadows are drawn [m].
constexpr double reachM = 300;

struct Range {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

/// Distance along the view axis up to which shadows matter.
double shadowDistance(const std::vector<Box>& boxes, const Camera& camera) {
    double farthest = 0, nearest = std::numeric_limits<double>::infinity();
    for (const Box& box : boxes) {
        glm::dvec3 centre(0);
        for (const glm::dvec3& corner : box.corners) {
            farthest = std::max(farthest, glm::dot(corner - camera.eye, camera.forward));
            centre += corner / 8.0;
        }
        const double radius = glm::length(box.corners[0] - centre);
        nearest = std::min(nearest, std::max(0.0, glm::length(centre - camera.eye) - radius));
    }
    return std::min(farthest, nearest + reachM);
}

} // namespace

ShadowFit fitShadow(const std::vector<Box>& boxes, const Camera& camera, const glm::dvec3& toSun) {
    ShadowFit fit;
    const double distance = shadowDistance(boxes, camera);
    if (!(distance > 0) || toSun.y <= 0) return fit;
    const glm::dvec3 right = glm::normalize(
        glm::cross(std::abs(toSun.y) > 0.99 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), toSun));
    const glm::dvec3 up = glm::cross(toSun, right);
    const auto toLight = [&](const glm::dvec3& p) {
        return glm::dvec3(glm::dot(p, right), glm::dot(p, up), glm::dot(p, toSun));
    };
    Range bounds, seen;
    for (const Box& box : boxes)
        for (const glm::dvec3& corner : box.corners) bounds.add(toLight(corner - camera.eye));
    seen.add(glm::dvec3(0));
    for (int i = 0; i < 4; ++i)
        seen.add(
            toLight(distance * (camera.forward + (i & 1 ? 1.0 : -1.0) * camera.tanHalfFovX * camera.right +
                                (i & 2 ? 1.0 : -1.0) * camera.tanHalfFovY * camera.up)));
    glm::dvec3 low = glm::max(bounds.low, seen.low), high = glm::min(bounds.high, seen.high);
    if (!(high.x > low.x && high.y > low.y)) return fit;
    // Every caster counts, however far towards the sun; the margin keeps the filter inside the map.
    low.z = bounds.low.z - 1;
    high.z = bounds.high.z + 1;
    const glm::dvec2 margin = (glm::dvec2(high) - glm::dvec2(low)) * (4.0 / ShadowPass::size) + 1e-3;
    low -= glm::dvec3(margin, 0);
    high += glm::dvec3(margin, 0);
    const glm::dvec3 extent = high - low;
    fit.enabled = true;
    fit.texelM = std::max(extent.x, extent.y) / ShadowPass::size;
    const glm::dmat4 rows(glm::dvec4(2 / extent.x * right, -(low.x + high.x) / extent.x),
                          glm::dvec4(2 / extent.y * up, -(low.y + high.y) / extent.y),
                          glm::dvec4(-1 / extent.z * toSun, high.z / extent.z), glm::dvec4(0, 0, 0, 1));
    fit.clipFromEye = glm::mat4(glm::transpose(rows));
    return fit;
}

bool ShadowPass::create(const Device& device, const Layouts& layouts, Error& error) {
    ImageDesc image;
    image.format = VK_FORMAT_D32_SFLOAT;
    image.extent = {size, size};
    image.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    SamplerDesc sampler;
    sampler.compare = true;
    PipelineDesc desc;
    desc.vertex = shadow_vert;
    desc.depthFormat = image.format;
    desc.depthCompare = VK_COMPARE_OP_LESS_OR_EQUAL;
    desc.slopeBias = 0.75f;
    PipelineDesc masked = desc;
    masked.fragment = shadow_frag;
    return createImage(device, image, map_, error) && createSampler(device, sampler, sampler_, error) &&
           createPipeline(device, layouts.pipeline.get(), desc, opaque_, error) &&
           createPipeline(device, layouts.pipeline.get(), masked, masked_, error);
}

void ShadowPass::record(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                        const glm::dvec3& eye, const ShadowFit& fit) const {
    constexpr VkPipelineStageFlags2 tests =
        VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    imageBarrier(commands, map_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                 VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, 0, tests,
                 VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                     VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT);
    beginRendering(commands, {size, size}, nullptr, VK_ATTACHMENT_LOAD_OP_DONT_CARE, map_,
                   VK_ATTACHMENT_LOAD_OP_CLEAR, 1);
    if (fit.enabled) drawMeshes(commands, layouts, meshes, eye, {opaque_.get(), masked_.get(), false});
    vkCmdEndRendering(commands);
    imageBarrier(commands, map_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, tests,
                 VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
                 VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

void setShadowUniforms(const ShadowFit& fit, FrameUniforms& uniforms) {
    uniforms.shadowFromEye = fit.clipFromEye;
    uniforms.shadow = glm::vec4(fit.texelM, 1.0 / ShadowPass::size, fit.enabled ? 1 : 0, 0);
}

} // namespace demos
