#include "water/mesh/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "water/interface/checks.h"
#include "water/interface/fields/water.h"
#include "water/sea/sea.h"

namespace seaglass {

namespace {

constexpr uint32_t mostPolygonPoints = 1024, mostMeshPoints = 1u << 24;

glm::dvec2 pointOf(const ExtentDesc& desc, uint32_t i) {
    return {desc.points[2 * size_t{i}], desc.points[2 * size_t{i} + 1]};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Which side of a -> b a point lies on.
int sideOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& point) {
    const double area = cross(b - a, point - a);
    return (area > 0) - (area < 0);
}

/// Of a point on the line through a and b.
bool within(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& point) {
    return point.x >= std::min(a.x, b.x) && point.x <= std::max(a.x, b.x) && point.y >= std::min(a.y, b.y) &&
           point.y <= std::max(a.y, b.y);
}

bool touch(const OutlineEdge& e, const OutlineEdge& f) {
    const int a = sideOf(e.from, e.to, f.from), b = sideOf(e.from, e.to, f.to);
    const int c = sideOf(f.from, f.to, e.from), d = sideOf(f.from, f.to, e.to);
    if (a * b < 0 && c * d < 0) return true;
    return (a == 0 && within(e.from, e.to, f.from)) || (b == 0 && within(e.from, e.to, f.to)) ||
           (c == 0 && within(f.from, f.to, e.from)) || (d == 0 && within(f.from, f.to, e.to));
}

std::vector<OutlineEdge> closed(const std::vector<glm::dvec2>& corners) {
    std::vector<OutlineEdge> edges;
    for (size_t i = 0; i < corners.size(); ++i)
        edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return edges;
}

std::vector<glm::dvec2> cornersOf(const ExtentDesc& desc) {
    std::vector<glm::dvec2> corners;
    if (desc.shape == ExtentShape::polygon) {
        for (uint32_t i = 0; i < desc.pointCount; ++i) corners.push_back(pointOf(desc, i));
        return corners;
    }
    const glm::dvec2 along = glm::dvec2(std::cos(desc.yaw), std::sin(desc.yaw)) * (desc.size[0] / 2);
    const glm::dvec2 across = glm::dvec2(-std::sin(desc.yaw), std::cos(desc.yaw)) * (desc.size[1] / 2);
    const glm::dvec2 center(desc.center[0], desc.center[1]);
    return {center - along - across, center + along - across, center + along + across,
            center - along + across};
}

/// Edges that an odd number of a mesh's triangles have.
std::vector<OutlineEdge> borderOf(const ExtentDesc& desc) {
    std::map<std::pair<uint32_t, uint32_t>, bool> odd;
    for (uint32_t i = 0; i < desc.indexCount; ++i) {
        const uint32_t next = i % 3 == 2 ? i - 2 : i + 1;
        const auto [low, high] = std::minmax(desc.indices[i], desc.indices[next]);
        bool& single = odd[{low, high}];
        single = !single;
    }
    std::vector<OutlineEdge> edges;
    for (const auto& [ends, single] : odd)
        if (single) edges.push_back({pointOf(desc, ends.first), pointOf(desc, ends.second)});
    return edges;
}

const char* badPoints(const ExtentDesc& desc) {
    if (!desc.points) return "BodyDesc.extent.points is null";
    if (desc.pointCount < 3) return "BodyDesc.extent.pointCount is less than 3";
    const bool polygon = desc.shape == ExtentShape::polygon;
    if (polygon && desc.pointCount > mostPolygonPoints) return "BodyDesc.extent.pointCount is more than 1024";
    if (desc.pointCount > mostMeshPoints) return "BodyDesc.extent.pointCount is more than 2^24";
    for (size_t i = 0; i < 2 * size_t{desc.pointCount}; ++i)
        if (!std::isfinite(desc.points[i])) return "BodyDesc.extent.points are not finite";
    return nullptr;
}

const char* badPolygon(const ExtentDesc& desc) {
    if (const char* bad = badPoints(desc)) return bad;
    const std::vector<OutlineEdge> edges = closed(cornersOf(desc));
    for (const OutlineEdge& edge : edges)
        if (glm::distance(edge.from, edge.to) < 1e-6)
            return "BodyDesc.extent.points hold the same point twice in a row";
    for (size_t i = 0; i < edges.size(); ++i) {
        const OutlineEdge& next = edges[(i + 1) % edges.size()];
        if (sideOf(edges[i].from, edges[i].to, next.to) == 0 &&
            glm::dot(edges[i].to - edges[i].from, next.to - next.from) < 0)
            return "BodyDesc.extent.points are those of a polygon that crosses or touches itself";
        // Neighbours share a point, the first and the last too.
        for (size_t j = i + 2; j < edges.size() - (i == 0 ? 1 : 0); ++j)
            if (touch(edges[i], edges[j]))
                return "BodyDesc.extent.points are those of a polygon that crosses or touches itself";
    }
    return nullptr;
}

const char* badMesh(const ExtentDesc& desc) {
    if (const char* bad = badPoints(desc)) return bad;
    if (!desc.indices) return "BodyDesc.extent.indices is null";
    if (desc.indexCount == 0 || desc.indexCount % 3 != 0 || desc.indexCount > 6 * mostMeshPoints)
        return "BodyDesc.extent.indexCount is no number of triangles, expected 3 or more of them, by threes";
    double area = 0;
    for (uint32_t i = 0; i < desc.indexCount; i += 3) {
        for (uint32_t corner = 0; corner < 3; ++corner)
            if (desc.indices[i + corner] >= desc.pointCount)
                return "BodyDesc.extent.indices name a point that is not there";
        const glm::dvec2 a = pointOf(desc, desc.indices[i]);
        area +=
            std::abs(cross(pointOf(desc, desc.indices[i + 1]) - a, pointOf(desc, desc.indices[i + 2]) - a));
    }
    if (!(area > 1e-9)) return "BodyDesc.extent.indices make triangles without any area";
    return nullptr;
}

} // namespace

bool Outline::contains(const glm::dvec2& point) const {
    bool inside = false;
    for (const auto& [a, b] : edges)
        if ((a.y <= point.y) != (b.y <= point.y) &&
            a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) < point.x)
            inside = !inside;
    return inside;
}

double Outline::distanceTo(const glm::dvec2& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : edges) {
        const glm::dvec2 along = b - a;
        const double share = glm::clamp(glm::dot(point - a, along) / glm::dot(along, along), 0.0, 1.0);
        least = std::min(least, glm::distance(point, a + along * share));
    }
    return least;
}

bool meets(const OutlineEdge& edge, const glm::dvec2& low, const glm::dvec2& high) {
    double from = 0, to = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double start = edge.from[axis], step = edge.to[axis] - start;
        if (step == 0) {
            if (start < low[axis] || start > high[axis]) return false;
            continue;
        }
        const double a = (low[axis] - start) / step, b = (high[axis] - start) / step;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

FieldError badField(const ExtentDesc& desc) {
    const auto reads = [&](const Field& field) { return isRead(extentFields, field, &desc); };
    if (const FieldError bad = badField(extentFields, &desc, "BodyDesc.extent", reads)) return bad;
    if (desc.shape == ExtentShape::polygon) return badPolygon(desc);
    return desc.shape == ExtentShape::mesh ? badMesh(desc) : nullptr;
}

Outline outlineOf(const ExtentDesc& desc) {
    Outline outline;
    if (desc.shape == ExtentShape::unbounded) return outline;
    outline.edges = desc.shape == ExtentShape::mesh ? borderOf(desc) : closed(cornersOf(desc));
    outline.low = glm::dvec2(std::numeric_limits<double>::infinity());
    outline.high = -outline.low;
    const auto take = [&](const glm::dvec2& point) {
        outline.low = glm::min(outline.low, point);
        outline.high = glm::max(outline.high, point);
    };
    if (desc.shape == ExtentShape::mesh)
        for (uint32_t i = 0; i < desc.indexCount; ++i) take(pointOf(desc, desc.indices[i]));
    else
        for (const OutlineEdge& edge : outline.edges) take(edge.from);
    return outline;
}

double largestDisplacement(const Sea& sea) {
    // Heights pass 5 standard deviations once in a million; choppiness moves points sideways about as far.
    const double height = 1.25 * significantWaveHeight(sea);
    const double trains = sea.shore ? sea.shore->reach() : 0;
    return height * std::max(1.0, double{description(sea).choppiness}) + trains;
}

} // namespace seaglass
