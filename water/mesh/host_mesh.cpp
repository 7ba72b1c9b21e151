#include "water/mesh/host_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>

namespace seaglass {

namespace {

/// The edges of a mesh's triangles by vertex. Those that two triangles share are there twice, borders once.
struct Neighbours {
    std::vector<uint32_t> first; ///< of each vertex, and one past the last
    std::vector<uint32_t> other;

    explicit Neighbours(const ExtentDesc& desc) : first(size_t{desc.pointCount} + 2) {
        for (uint32_t i = 0; i < desc.indexCount; ++i) first[desc.indices[i] + 2] += 2;
        for (size_t i = 2; i < first.size(); ++i) first[i] += first[i - 1];
        other.resize(2 * size_t{desc.indexCount});
        for (uint32_t i = 0; i < desc.indexCount; ++i) {
            const uint32_t a = desc.indices[i], b = desc.indices[i % 3 == 2 ? i - 2 : i + 1];
            other[first[a + 1]++] = b;
            other[first[b + 1]++] = a;
        }
    }
};

/// Dijkstra's shortest ways from the border, over the mesh's edges.
class WaysFromBorder {
  public:
    WaysFromBorder(const Neighbours& neighbours, std::vector<HostVertex>& vertices)
        : neighbours_(neighbours), vertices_(vertices) {}

    void run() {
        for (uint32_t v = 0; v < vertices_.size(); ++v)
            if (isOnBorder(v)) reach(v, 0);
        while (!open_.empty()) {
            const auto [way, v] = open_.top();
            open_.pop();
            if (way > vertices_[v].fromEdge) continue;
            for (uint32_t i = neighbours_.first[v]; i < neighbours_.first[v + 1]; ++i)
                reach(neighbours_.other[i], way + length(v, neighbours_.other[i]));
        }
    }

  private:
    bool isOnBorder(uint32_t v) const {
        const auto begin = neighbours_.other.begin();
        const auto from = begin + neighbours_.first[v], to = begin + neighbours_.first[v + 1];
        return std::any_of(from, to, [&](uint32_t other) { return std::count(from, to, other) % 2 == 1; });
    }

    float length(uint32_t a, uint32_t b) const {
        const float *const p = vertices_[a].calm, *const q = vertices_[b].calm;
        return std::hypot(p[0] - q[0], p[1] - q[1]);
    }

    void reach(uint32_t v, float way) {
        if (!(way < vertices_[v].fromEdge)) return;
        vertices_[v].fromEdge = way;
        open_.push({way, v});
    }

    using Open = std::pair<float, uint32_t>;
    const Neighbours& neighbours_;
    std::vector<HostVertex>& vertices_;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

constexpr VkBufferUsageFlags vertexUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
constexpr VkBufferUsageFlags indexUsage = VK_BUFFER_USAGE_INDEX_BUFFER_BIT;

VkDeviceSize vertexBytes(const ExtentDesc& desc) {
    return size_t{desc.pointCount} * sizeof(HostVertex);
}

VkDeviceSize indexBytes(const ExtentDesc& desc) {
    return size_t{desc.indexCount} * sizeof(uint32_t);
}

} // namespace

std::vector<HostVertex> hostVertices(const ExtentDesc& desc, const glm::dvec2& origin) {
    std::vector<HostVertex> vertices(desc.pointCount);
    for (size_t i = 0; i < vertices.size(); ++i) {
        vertices[i].calm[0] = static_cast<float>(desc.points[2 * i] - origin.x);
        vertices[i].calm[1] = static_cast<float>(desc.points[2 * i + 1] - origin.y);
        vertices[i].fromEdge = std::numeric_limits<float>::max();
    }
    const Neighbours neighbours(desc);
    for (uint32_t v = 0; v < desc.pointCount; ++v) {
        const uint32_t first = neighbours.first[v], count = neighbours.first[v + 1] - first;
        double sum = 0;
        for (uint32_t i = first; i < first + count; ++i) {
            const float* const other = vertices[neighbours.other[i]].calm;
            sum += std::hypot(double{other[0]} - vertices[v].calm[0], double{other[1]} - vertices[v].calm[1]);
        }
        if (count > 0) vertices[v].cell = static_cast<float>(sum / count);
    }
    WaysFromBorder(neighbours, vertices).run();
    return vertices;
}

Status HostMesh::create(const gpu::Device& device, const ExtentDesc& desc, const Outline& outline) {
    origin = (outline.low + outline.high) / 2.0;
    indexCount = desc.indexCount;
    const std::vector<HostVertex> made = hostVertices(desc, origin);
    if (const Status s =
            vertices.createMapped(device, vertexBytes(desc), vertexUsage, "extent vertex buffer");
        s != Status::ok)
        return s;
    if (const Status s = indices.createMapped(device, indexBytes(desc), indexUsage, "extent index buffer");
        s != Status::ok)
        return s;
    std::memcpy(vertices.mapped(), made.data(), vertexBytes(desc));
    std::memcpy(indices.mapped(), desc.indices, indexBytes(desc));
    return Status::ok;
}

VkDeviceSize HostMesh::bytes(const gpu::Device& device, const ExtentDesc& desc) {
    if (desc.shape != ExtentShape::mesh) return 0;
    return gpu::heldBytes(device, vertexBytes(desc), vertexUsage) +
           gpu::heldBytes(device, indexBytes(desc), indexUsage);
}

} // namespace seaglass
