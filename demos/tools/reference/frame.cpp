#include "reference/frame.h"

#include "host/water/afloat.h"
#include "host/water/exclusion_volumes.h"
#include "host/water/waves.h"
#include "scene/motion/motion.h"

namespace demos::reference {

namespace {

constexpr size_t mostVolumes = 8; ///< as seaglass::setExclusionVolumes() has it

/// Front faces counter-clockwise.
SurfaceMesh rectangleOf(const Floor& floor, const glm::dvec3& eye) {
    SurfaceMesh mesh;
    const glm::dvec3 across = floor.plane.across * (floor.desc.widthM / 2),
                     along = floor.plane.along * (floor.desc.lengthM / 2), middle = floor.plane.middle - eye;
    for (const glm::dvec2 at : {glm::dvec2(-1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1), glm::dvec2(1, -1)})
        mesh.positions.emplace_back(middle + at.x * across + at.y * along);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.oneSided = true;
    return mesh;
}

/// Into the water's axes.
void turn(Camera& camera, const LevelAxes& frame) {
    for (glm::dvec3* vector : {&camera.eye, &camera.right, &camera.up, &camera.forward})
        *vector = frame.fromWorld(*vector);
}

/// With what they keep dry, where there is water.
bool placeInstances(const World& world, double timeS, Frame& out, Error& error) {
    out.excludedVolumes = world.excludedVolumes;
    std::vector<seaglass::ExclusionVolume> carried;
    const WaterAt water(world.sea.get(), timeS);
    const glm::dmat4 bodyFromWorld(glm::transpose(world.frame.worldFromBody));
    for (const Instance& instance : world.instances) {
        glm::dmat4 worldFromMesh;
        if (!placement(instance.placed, timeS, water, worldFromMesh, error)) return false;
        out.geometry.add(*instance.model, bodyFromWorld * worldFromMesh, out.camera.eye);
        if (world.water) addCarried(instance.placed.desc, worldFromMesh, carried);
    }
    for (const seaglass::ExclusionVolume& volume : carried)
        out.excludedVolumes.push_back(excludedVolumeOf(volume, world.frame));
    if (out.excludedVolumes.size() <= mostVolumes) return true;
    error.text =
        "exclusion volumes are " + std::to_string(out.excludedVolumes.size()) + ", expected 8 at most";
    return false;
}

} // namespace

bool prepareFrame(const World& world, const FrameDesc& desc, Frame& out, Error& error) {
    out.world = &world;
    out.desc = desc;
    const double aspect = static_cast<double>(desc.width) / desc.height;
    if (!std::isfinite(desc.timeS)) {
        error.text = "the time of a frame must be finite";
        return false;
    }
    if (!makeCamera(cameraAt(desc.camera, desc.timeS), aspect, out.camera, error) ||
        !out.geometry.create(error))
        return false;
    turn(out.camera, world.frame);
    out.pixelAngle = static_cast<float>(2 * out.camera.tanHalfFovY / desc.height);
    if (out.camera.parallel()) {
        // So far that neighbours are as good as parallel, and so near that floats tell them apart.
        const double apex = 200 * out.camera.half.y;
        out.apexM = static_cast<float>(apex);
        out.pixelAngle = static_cast<float>(2 * out.camera.half.y / desc.height / apex);
    }
    if (!placeInstances(world, desc.timeS, out, error)) return false;
    if (world.floor) {
        out.mesh = rectangleOf(*world.floor, out.camera.eye);
        out.geometry.add(out.mesh);
    }
    if (world.water) {
        const auto& foam = world.water->foam;
        const seaglass::FoamDesc foamDesc = foam.value_or(seaglass::FoamDesc{});
        if (!out.surface.create(world.sea.get(), foam ? &foamDesc : nullptr, desc.timeS, error)) return false;
        SurfaceMeshDesc mesh;
        mesh.levelM = world.levelM;
        mesh.globe = world.globe;
        mesh.height = desc.height;
        if (world.outline) {
            mesh.outline = &*world.outline;
            if (world.sea) mesh.pinned = 2 * farthestMove(*world.sea);
        }
        out.mesh = meshOf(out.surface, out.camera, mesh);
        if (world.outline || !out.excludedVolumes.empty())
            out.mesh.covers = [&out](uint32_t triangle, const glm::vec3& weights) {
                return out.covers(triangle, weights);
            };
        out.geometry.add(out.mesh);
        if (out.excludedVolumes.empty()) out.mesh.positions = {};
        out.shore = wettedShore(world.sea.get(), desc.timeS, glm::dvec2(out.camera.eye.x, out.camera.eye.z));
        out.sky = skyBeams(world.light);
    }
    if (!out.geometry.build(error)) return false;
    if (world.water) out.caustics.create(out);
    return true;
}

Ray Frame::rayThrough(const glm::vec2& pixel, float width) const {
    const auto through = [&](double x, double y) {
        return camera.seenAt(2 * x / desc.width - 1, 1 - 2 * y / desc.height, camera.parallel() ? 0 : 1);
    };
    const double x = static_cast<double>(pixel.x), y = static_cast<double>(pixel.y);
    const double right = x + static_cast<double>(width), below = y + static_cast<double>(width);
    const float angle = width * pixelAngle;
    if (camera.parallel()) return parallelRay(through(x, y), through(right, y), through(x, below), angle);
    const glm::dvec3 towards = through(x, y);
    const double length = glm::length(towards);
    Ray ray;
    ray.direction = glm::vec3(towards / length);
    ray.nearest = static_cast<float>(camera.near * length);
    ray.footprint = {glm::vec3(0), glm::vec3(through(right, y)), glm::vec3(through(x, below)), angle};
    return ray;
}

Ray Frame::parallelRay(const glm::dvec3& from, const glm::dvec3& right, const glm::dvec3& below,
                       float angle) const {
    const glm::dvec3 along = static_cast<double>(apexM) * camera.forward;
    Ray ray;
    ray.origin = glm::vec3(from);
    ray.direction = glm::vec3(camera.forward);
    ray.nearest = static_cast<float>(camera.near);
    ray.footprint = {glm::vec3(from - along), glm::vec3(along + right - from),
                     glm::vec3(along + below - from), angle};
    return ray;
}

float Frame::distanceTo(const glm::vec3& position) const {
    return camera.parallel() ? glm::dot(position, glm::vec3(camera.forward)) : glm::length(position);
}

glm::dvec3 Frame::seenAt(const glm::vec3& position) const {
    const glm::dvec3 p(position);
    const double along = glm::dot(p, camera.forward);
    const double right = glm::dot(p, camera.right) / (along * camera.tanHalfFovX + camera.half.x);
    const double up = glm::dot(p, camera.up) / (along * camera.tanHalfFovY + camera.half.y);
    return {(right + 1) / 2 * desc.width, (1 - up) / 2 * desc.height, along};
}

bool Frame::covers(uint32_t triangle, const glm::vec3& weights) const {
    if (world->outline && !world->outline->contains(calmAt(triangle, weights))) return false;
    if (excludedVolumes.empty()) return true;
    const glm::uvec3 corners = mesh.triangles[triangle];
    glm::dvec3 at = camera.eye;
    for (glm::length_t i = 0; i < 3; ++i)
        at += static_cast<double>(weights[i]) * glm::dvec3(mesh.positions[corners[i]]);
    return !isExcluded(excludedVolumes, at);
}

glm::dvec2 Frame::calmAt(const Hit& waterHit) const {
    return calmAt(waterHit.triangle, waterHit.weights);
}

glm::dvec2 Frame::calmAt(uint32_t triangle, const glm::vec3& weights) const {
    const glm::uvec3 corners = mesh.triangles[triangle];
    glm::dvec2 calm(camera.eye.x, camera.eye.z);
    for (int i = 0; i < 3; ++i)
        calm +=
            static_cast<double>(weights[i]) * glm::dvec2(mesh.calm[corners[static_cast<glm::length_t>(i)]]);
    return calm;
}

float Frame::heightOf(const glm::vec3& position) const {
    const glm::dvec2 away(position.x, position.z);
    const double level = world->levelM - world->globe.dropAt(glm::dot(away, away));
    return static_cast<float>(static_cast<double>(position.y) + camera.eye.y - level);
}

glm::mat3 Frame::levelAt(const glm::vec3& position) const {
    const glm::dvec2 away = glm::dvec2(position.x, position.z) * world->globe.curvature;
    const double up = std::sqrt(std::max(1 - glm::dot(away, away), 0.0));
    return glm::mat3(LevelAxes::of({away.x, up, away.y}).worldFromBody);
}

glm::vec3 Frame::skyFrom(const glm::vec3& position, const glm::vec3& direction) const {
    return world->light.sky(world->globe.flat() ? direction : direction * levelAt(position));
}

} // namespace demos::reference
