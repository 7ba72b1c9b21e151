// What rays can hit: the opaque meshes and the surface that mirrors, water or floor, in one Embree scene
// relative to the eye.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <embree3/rtcore.h>

#include "host/files/mesh_file.h"
#include "host/water/placement.h"
#include "reference/ray.h"
#include "reference/texture.h"

namespace demos::reference {

/// A mesh as it was read, and its textures ready to be looked at.
struct Model {
    Mesh mesh;
    std::vector<Texture> textures;
    explicit Model(Mesh source);
};

struct Instance {
    const Model* model = nullptr;
    Placed placed;
};

/// Bits that say what a ray may hit.
enum Kind : unsigned { opaque = 1, surface = 2, everything = 3 };

/// One instance as Embree holds it.
struct OpaquePart {
    const Model* model = nullptr;
    glm::mat3 eyeFromMesh{1};             ///< of directions
    const glm::vec3* positions = nullptr; ///< relative to the eye
    std::vector<uint32_t> materials;      ///< of each triangle
};

struct Hit {
    Kind kind = Kind::opaque;
    float distance = 0;
    glm::vec3 position{0};
    glm::vec3 geometricNormal{0, 1, 0}; ///< unit, by the corners' order
    glm::vec3 weights{1, 0, 0};         ///< of the corners
    uint32_t triangle = 0;
    const OpaquePart* part = nullptr; ///< null for the surface
    bool frontFacing = true;

    /// Unit, towards where the ray came from.
    glm::vec3 facing() const { return frontFacing ? geometricNormal : -geometricNormal; }
};

/// Triangles of the surface that mirrors, relative to the eye.
struct SurfaceMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> calm; ///< of water: (u, v) before displacement
    std::vector<glm::uvec3> triangles;
    bool oneSided = false; ///< rays pass through its back
    /// Whether a point of a triangle, given by its corners' weights, is there at all; null: all are.
    std::function<bool(uint32_t triangle, const glm::vec3& weights)> covers;
};

/// Immutable once built; tracing may go on in several threads at once.
class Geometry {
  public:
    Geometry() = default;
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;
    ~Geometry();

    bool create(Error& error);
    void add(const Model& model, const glm::dmat4& worldFromMesh, const glm::dvec3& eye);
    void add(const SurfaceMesh& surface);
    /// After the last add(), before the first ray.
    bool build(Error& error);

    /// The nearest hit, back faces and cut-outs left out as the host leaves them out.
    bool trace(const Ray& ray, Kind kinds, Hit& hit) const { return meets(ray, kinds, false, hit); }
    /// The nearest that light is stopped by: both faces of everything cast shadows, as in the host.
    bool traceLight(const Ray& ray, Kind kinds, Hit& hit) const { return meets(ray, kinds, true, hit); }
    /// Whether anything that stops light lies between.
    bool occluded(const glm::vec3& from, const glm::vec3& direction, Kind kinds, const Footprint& footprint,
                  float distance = INFINITY) const;

  private:
    bool meets(const Ray& ray, Kind kinds, bool light, Hit& hit) const;

    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::vector<std::unique_ptr<OpaquePart>> parts_; ///< by Embree's geometry
    std::function<bool(uint32_t, const glm::vec3&)> surfaceCovers_;
    unsigned surfaceGeometry_ = RTC_INVALID_GEOMETRY_ID;
    const glm::vec3* surfacePositions_ = nullptr;
    const glm::uvec3* surfaceTriangles_ = nullptr;
};

/// Colour and alpha of an opaque surface before light, with what `footprint` blurs in its texture.
glm::vec4 baseColorAt(const OpaquePart& part, uint32_t triangle, const glm::vec3& weights,
                      const glm::vec3& position, const Footprint& footprint);
/// What a surface makes of light.
struct Look {
    glm::vec3 base{1};         ///< what would scatter, were it no metal
    glm::vec3 diffuse{1};      ///< share of the light that it scatters
    glm::vec3 mirrored{0.04f}; ///< and mirrors, seen straight on
    float roughness = 1;
    glm::vec3 emissive{0};
    float open = 1;     ///< share of the surroundings that its occlusion map leaves
    bool unlit = false; ///< only `emissive` leaves it
};
Look lookAt(const Hit& hit, const Footprint& footprint);
/// A unit normal as the material's normal map turns it, as opaque.frag does.
glm::vec3 mappedNormal(const Hit& hit, const glm::vec3& normal, const Footprint& footprint);
/// How far to step off a surface so that a ray does not meet it again [m].
float clearanceAt(const glm::vec3& position);

} // namespace demos::reference
