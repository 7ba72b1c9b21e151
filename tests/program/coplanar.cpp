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

/// A box around items `first` to `end`, and which two parts of it have a half of them each.
struct Node {
    size_t first, end;
    Box box;
    size_t halves[2] = {0, 0}; ///< none where there are few

    bool isLeaf() const { return !halves[1]; }
};

/// A tree of boxes over the faces: what is apart is told so whatever its size, a leaf or a hill on the
/// horizon.
struct Search {
    double gap, area;
    std::vector<Item> items;
    std::vector<Node> nodes;
    std::vector<Overlap> found;

    static constexpr size_t few = 8; ///< items that are compared with each other one by one

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

    size_t addNode(size_t first, size_t end) {
        const size_t index = nodes.size();
        Box box = items[first].box;
        for (size_t i = first + 1; i < end; ++i)
            box = {glm::min(box.low, items[i].box.low), glm::max(box.high, items[i].box.high)};
        nodes.push_back({first, end, box});
        if (end - first <= few) return index;
        const glm::dvec3 size = box.high - box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const size_t middle = (first + end) / 2;
        const auto at = [&](size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(first), at(middle), at(end), [&](const Item& a, const Item& b) {
            return a.box.low[axis] + a.box.high[axis] < b.box.low[axis] + b.box.high[axis];
        });
        const size_t low = addNode(first, middle), high = addNode(middle, end);
        nodes[index].halves[0] = low, nodes[index].halves[1] = high;
        return index;
    }

    void within(const Node& node) {
        if (node.isLeaf()) {
            for (size_t i = node.first; i < node.end; ++i)
                for (size_t j = node.first; j < i; ++j) compare(items[i], items[j]);
            return;
        }
        for (const size_t half : node.halves) within(nodes[half]);
        between(nodes[node.halves[0]], nodes[node.halves[1]]);
    }

    void between(const Node& a, const Node& b) {
        if (!a.box.meets(b.box, gap)) return;
        if (a.isLeaf() && b.isLeaf()) {
            for (size_t i = a.first; i < a.end; ++i)
                for (size_t j = b.first; j < b.end; ++j) compare(items[i], items[j]);
            return;
        }
        const bool splitA = a.end - a.first > b.end - b.first;
        const Node &whole = splitA ? a : b, &other = splitA ? b : a;
        for (const size_t half : whole.halves) between(nodes[half], other);
    }
};

} // namespace

std::vector<Overlap> coplanarOverlaps(const std::vector<Face>& faces, double gap, double area) {
    Search search{gap, area, {}, {}, {}};
    for (const Face& face : faces) {
        const auto& [a, b, c] = face.corners;
        const glm::dvec3 twice = glm::cross(b - a, c - a);
        const double length = glm::length(twice);
        if (0.5 * length <= area) continue;
        const Box box = {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
        search.items.push_back({&face, twice / length, box});
    }
    if (search.items.empty()) return {};
    search.addNode(0, search.items.size());
    search.within(search.nodes[0]);
    return search.found;
}

} // namespace tests
