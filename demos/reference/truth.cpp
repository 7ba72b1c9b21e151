#include "reference/truth.h"

#include "reference/shade_water.h"

namespace demos::reference {
namespace {

bool within(const Frame& frame, const glm::dvec3& seen) {
    return seen.z >= frame.camera.near && seen.x >= 0 && seen.y >= 0 && seen.x < frame.desc.width &&
           seen.y < frame.desc.height;
}

TruthClass classOf(const Frame& frame, const Ray& mirrored, const Hit& hit, const glm::dvec3& seen) {
    if (!within(frame, seen)) return TruthClass::offScreen;
    const glm::vec3 side =
        glm::dot(hit.geometricNormal, mirrored.direction) < 0 ? hit.geometricNormal : -hit.geometricNormal;
    if (glm::dot(side, hit.position) >= 0) return TruthClass::backFacing;
    Ray direct = frame.rayThrough(glm::vec2(seen));
    Hit first;
    const float distance = glm::length(hit.position);
    // The picture holds the opaque scene alone: water hides nothing.
    if (!frame.geometry.trace(direct, Kind::opaque, first))
        return TruthClass::recoverable; // an edge seen end on
    return first.distance < distance - (0.01f + 1e-3f * distance) ? TruthClass::hidden
                                                                  : TruthClass::recoverable;
}

} // namespace

Truth truthAt(const Frame& frame, const glm::vec2& pixel) {
    Truth truth;
    const Ray ray = frame.rayThrough(pixel);
    Hit surface;
    if (!frame.geometry.trace(ray, Kind::everything, surface) || surface.kind != Kind::water) return truth;
    const Ray mirrored = mirrorOfMean(frame, ray, surface).ray;
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
    truth.kind = hit.kind == Kind::water ? TruthClass::water : classOf(frame, mirrored, hit, seen);
    return truth;
}

} // namespace demos::reference
