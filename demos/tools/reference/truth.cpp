#include "reference/truth.h"

#include <cmath>

#include "reference/shade/shade_floor.h"
#include "reference/shade/shade_water.h"

namespace demos::reference {
namespace {

/// Cosine between facets of one rounded face; a stake of eight sides turns by 45 degrees.
constexpr float mostTurned = 0.7f;

bool within(const Frame& frame, const glm::dvec3& seen) {
    return seen.z >= frame.camera.near && seen.x >= 0 && seen.y >= 0 && seen.x < frame.desc.width &&
           seen.y < frame.desc.height;
}

/// Whether a pixel's centre next to a place in the picture shows the surface that a hit there is on: the same
/// face, for that beside it has another colour. What is thinner than a pixel, or seen edge on, is in sight
/// and yet in no pixel.
bool isSampled(const Frame& frame, const Hit& hit, const glm::dvec3& seen) {
    const float distance = frame.distanceTo(hit.position);
    const glm::vec2 corner = glm::floor(glm::vec2(seen) - 0.5f) + 0.5f;
    for (int i = 0; i < 4; ++i) {
        Ray ray = frame.rayThrough(corner + glm::vec2(i & 1, i >> 1));
        Hit there;
        if (!frame.geometry.trace(ray, Kind::opaque, there)) continue;
        const float off = std::abs(glm::dot(hit.geometricNormal, there.position - hit.position));
        const bool alike = glm::dot(hit.facing(), there.facing()) >= mostTurned;
        if (alike && off <= 0.01f + 2e-3f * distance &&
            std::abs(there.distance - distance) <= 0.25f * distance)
            return true;
    }
    return false;
}

TruthClass classOf(const Frame& frame, const Ray& mirrored, const Hit& hit, const glm::dvec3& seen) {
    if (!within(frame, seen)) return TruthClass::offScreen;
    const glm::vec3 side =
        glm::dot(hit.geometricNormal, mirrored.direction) < 0 ? hit.geometricNormal : -hit.geometricNormal;
    const glm::vec3 sight = frame.camera.parallel() ? glm::vec3(frame.camera.forward) : hit.position;
    if (glm::dot(side, sight) >= 0) return TruthClass::backFacing;
    Ray direct = frame.rayThrough(glm::vec2(seen));
    Hit first;
    const float distance = frame.distanceTo(hit.position);
    // The picture holds the opaque scene alone: water hides nothing.
    if (frame.geometry.trace(direct, Kind::opaque, first) &&
        first.distance < distance - (0.01f + 1e-3f * distance))
        return TruthClass::hidden;
    return isSampled(frame, hit, seen) ? TruthClass::recoverable : TruthClass::unsampled;
}

} // namespace

Truth truthAt(const Frame& frame, const glm::vec2& pixel) {
    Truth truth;
    const Ray ray = frame.rayThrough(pixel);
    Hit surface;
    if (!frame.geometry.trace(ray, Kind::everything, surface) || surface.kind != Kind::surface) return truth;
    const bool floor = frame.world->floor.has_value();
    const Ray mirrored = floor ? mirrorOfFloor(ray, surface) : mirrorOfMean(frame, ray, surface).ray;
    truth.radiance = radianceAlong(frame, mirrored, mostBounces - 1, nullptr);
    Hit hit;
    const bool found = frame.geometry.trace(mirrored, Kind::everything, hit);
    const glm::dvec3 seen = frame.seenAt(found ? hit.position : mirrored.direction);
    if (seen.z > 0) truth.pixel = glm::vec2(seen);
    if (!found) {
        truth.kind = TruthClass::sky;
        return truth;
    }
    truth.distance = hit.distance;
    truth.kind = hit.kind == Kind::surface ? TruthClass::water : classOf(frame, mirrored, hit, seen);
    return truth;
}

} // namespace demos::reference
