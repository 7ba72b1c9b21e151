#include "tests/program/coplanar.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace tests {

namespace {

struct Box {
    glm::dvec3 low, high;

    bool meets(const Box& other, double gap) const {
        return glm::all(glm::lessThanEqual(low, other.high + gap)) &&
               glm::all(glm::lessThanEqual(other.low, high + gap));
    }
};

struct Item {
    const Face* face;
    glm::dvec3 normal;
    double area;
    Box box;
};

using Polygon = std::vector<glm::dvec3>;

/// Of a flat one, as a vector along its normal.
glm::dvec3 areaOf(const Polygon& polygon) {
    glm::dvec3 twice(0);
    for (size_t i = 2; i < polygon.size(); ++i)
        twice += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * twice;
}

/// The side of the plane through `from` on which `inwards` points (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, const glm::dvec3& from, const glm::dvec3& inwards) {
    Polygon kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double inA = glm::dot(a - from, inwards), inB = glm::dot(b - from, inwards);
        if (inA >= 0) kept.push_back(a);
        if ((inA >= 0) != (inB >= 0)) kept.push_back(a + (b - a) * (inA / (inA - inB)));
    }
    return kept;
}

/// What of `b` lies over `a`, along a's normal.
Polygon over(const Item& a, const Item& b) {
    Polygon left(std::begin(b.face->corners), std::end(b.face->corners));
    for (int i = 0; i < 3 && !left.empty(); ++i) {
        const glm::dvec3& corner = a.face->corners[i];
        left = clipped(left, corner, glm::cross(a.normal, a.face->corners[(i + 1) % 3] - corner));
    }
    return left;
}

struct Search {
    double gap, area;
    std::vector<Overlap> found;

    void compare(const Item& a, const Item& b) {
        if (glm::dot(a.normal, b.normal) < 0.9 || !a.box.meets(b.box, gap)) return;
        const Polygon shared = over(a, b);
        const double covered = glm::length(areaOf(shared));
        const bool together = std::ranges::all_of(shared, [&](const glm::dvec3& p) {
            return std::abs(glm::dot(p - a.face->corners[0], a.normal)) <= gap;
        });
        if (together && covered > area)
            found.push_back({{a.face->source, b.face->source}, covered, shared.front(), a.normal});
    }

    /// Those that reach into `cell`; a pair belongs to the cell in which its common box begins.
    void within(const std::vector<Item>& items, const Box& cell, int depth) {
        if (items.size() > 24 && depth < 40) return split(items, cell, depth);
        for (size_t i = 0; i < items.size(); ++i)
            for (size_t j = 0; j < i; ++j) {
                const glm::dvec3 begins = glm::max(items[i].box.low, items[j].box.low);
                if (glm::all(glm::greaterThanEqual(begins, cell.low)) &&
                    glm::all(glm::lessThan(begins, cell.high)))
                    compare(items[i], items[j]);
            }
    }

    void split(const std::vector<Item>& items, const Box& cell, int depth) {
        const glm::dvec3 size = cell.high - cell.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        Box halves[] = {cell, cell};
        halves[0].high[axis] = halves[1].low[axis] = cell.low[axis] + 0.5 * size[axis];
        for (const Box& half : halves) {
            std::vector<Item> reaching;
            std::ranges::copy_if(items, std::back_inserter(reaching),
                                 [&](const Item& item) { return item.box.meets(half, gap); });
            within(reaching, half, depth + 1);
        }
    }
};

} // namespace

std::vector<Overlap> coplanarOverlaps(const std::vector<Face>& faces, double gap, double area) {
    std::vector<Item> items;
    Box all = {glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const Face& face : faces) {
        const auto& [a, b, c] = face.corners;
        const glm::dvec3 twice = glm::cross(b - a, c - a);
        const double length = glm::length(twice);
        if (0.5 * length <= area) continue;
        const Box box = {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
        items.push_back({&face, twice / length, 0.5 * length, box});
        all = {glm::min(all.low, box.low), glm::max(all.high, box.high + 1.0)};
    }
    Search search{gap, area, {}};
    if (!items.empty()) search.within(items, all, 0);
    return search.found;
}

} // namespace tests
