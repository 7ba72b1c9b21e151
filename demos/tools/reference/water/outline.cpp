#include "reference/water/outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace demos::reference {

namespace {

using Ends = std::pair<uint32_t, uint32_t>;

/// The edges that only one of a mesh's triangles has, or an odd number of them.
std::vector<Ends> borderOf(const seaglass::ExtentDesc& mesh) {
    std::vector<Ends> all;
    for (uint32_t corner = 0; corner < mesh.indexCount; ++corner) {
        const uint32_t first = corner / 3 * 3, next = first + (corner + 1) % 3;
        all.push_back(std::minmax({mesh.indices[corner], mesh.indices[next]}));
    }
    std::ranges::sort(all);
    std::vector<Ends> border;
    for (const Ends& edge : all)
        if (!border.empty() && border.back() == edge)
            border.pop_back();
        else
            border.push_back(edge);
    return border;
}

std::vector<glm::dvec2> cornersOf(const seaglass::ExtentDesc& desc) {
    std::vector<glm::dvec2> corners;
    if (desc.shape != seaglass::ExtentShape::rectangle) {
        for (uint32_t i = 0; i < desc.pointCount; ++i)
            corners.emplace_back(desc.points[2 * size_t{i}], desc.points[2 * size_t{i} + 1]);
        return corners;
    }
    const double c = std::cos(desc.yaw), s = std::sin(desc.yaw);
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        const double x = u * desc.size[0], y = v * desc.size[1];
        corners.emplace_back(desc.center[0] + c * x - s * y, desc.center[1] + s * x + c * y);
    }
    return corners;
}

} // namespace

Outline outlineOf(const seaglass::ExtentDesc& desc) {
    const std::vector<glm::dvec2> corners = cornersOf(desc);
    Outline outline;
    if (desc.shape == seaglass::ExtentShape::mesh)
        for (const auto& [a, b] : borderOf(desc)) outline.edges.push_back({corners[a], corners[b]});
    else
        for (size_t i = 0; i < corners.size(); ++i)
            outline.edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    for (const Outline::Edge& edge : outline.edges) {
        outline.low = glm::min(outline.low, glm::min(edge.from, edge.to));
        outline.high = glm::max(outline.high, glm::max(edge.from, edge.to));
    }
    return outline;
}

bool Outline::contains(const glm::dvec2& point) const {
    const auto crosses = [&](const Edge& edge) {
        const glm::dvec2 from = edge.from - point, to = edge.to - point;
        if ((from.y <= 0) == (to.y <= 0)) return false;
        return from.x - from.y / (to.y - from.y) * (to.x - from.x) < 0; // on the point's own row
    };
    return std::ranges::count_if(edges, crosses) % 2 == 1;
}

double Outline::distanceTo(const glm::dvec2& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : edges) {
        const glm::dvec2 along = to - from;
        const double share = glm::dot(point - from, along) / glm::dot(along, along);
        least = std::min(least, glm::distance(point, from + along * std::clamp(share, 0.0, 1.0)));
    }
    return least;
}

} // namespace demos::reference
