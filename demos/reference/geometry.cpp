#include "reference/geometry.h"

#include <algorithm>
#include <cmath>

namespace demos::reference {
namespace {

struct Context {
    RTCIntersectContext embree;
    const Footprint* footprint;
    bool shadow;
};

struct Corners {
    uint32_t index[3];
};

Corners cornersOf(const OpaquePart& part, uint32_t triangle) {
    const uint32_t* const indices = &part.model->mesh.indices[size_t(triangle) * 3];
    return {{indices[0], indices[1], indices[2]}};
}

glm::vec3 crossOf(const glm::vec3* positions, uint32_t a, uint32_t b, uint32_t c) {
    return glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
}

struct Uv {
    glm::vec2 at, right, below;
};

/// Texture coordinates, and what they change by to where the neighbouring pixels meet the triangle's plane.
Uv uvAt(const OpaquePart& part, uint32_t triangle, const glm::vec3& weights, const glm::vec3& position,
        const Footprint& footprint) {
    const Corners c = cornersOf(part, triangle);
    const MeshVertex* const v = part.model->mesh.vertices.data();
    const glm::vec3* const p = part.positions;
    const glm::vec2 uv0 = v[c.index[0]].uv, uv1 = v[c.index[1]].uv, uv2 = v[c.index[2]].uv;
    const glm::vec3 e1 = p[c.index[1]] - p[c.index[0]], e2 = p[c.index[2]] - p[c.index[0]];
    const glm::vec3 n = glm::cross(e1, e2);
    const float squared = std::max(glm::dot(n, n), 1e-30f);
    const Spread spread = spreadOn(footprint, position, n / std::sqrt(squared));
    const auto change = [&](const glm::vec3& w) {
        const float b1 = glm::dot(glm::cross(w, e2), n) / squared,
                    b2 = glm::dot(glm::cross(e1, w), n) / squared;
        return b1 * (uv1 - uv0) + b2 * (uv2 - uv0);
    };
    return {weights.x * uv0 + weights.y * uv1 + weights.z * uv2, change(spread.right), change(spread.below)};
}

glm::vec4 textureAt(const OpaquePart& part, const std::optional<uint32_t>& texture, uint32_t triangle,
                    const glm::vec3& weights, const glm::vec3& position, const Footprint& footprint) {
    if (!texture) return glm::vec4(1);
    const Uv uv = uvAt(part, triangle, weights, position, footprint);
    return part.model->textures[*texture].sample(uv.at, uv.right, uv.below);
}

/// Takes hits on back faces and in cut-outs back. Embree asks for every hit on the way.
void filter(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] != -1) return;
    const auto& part = *static_cast<const OpaquePart*>(args->geometryUserPtr);
    const auto& context = *reinterpret_cast<const Context*>(args->context);
    const uint32_t triangle = RTCHitN_primID(args->hit, args->N, 0);
    const MeshMaterial& material = part.model->mesh.materials[part.materials[triangle]];
    if (!context.shadow && !material.doubleSided) {
        const Corners c = cornersOf(part, triangle);
        const glm::vec3 n = crossOf(part.positions, c.index[0], c.index[1], c.index[2]);
        const glm::vec3 d(RTCRayN_dir_x(args->ray, args->N, 0), RTCRayN_dir_y(args->ray, args->N, 0),
                          RTCRayN_dir_z(args->ray, args->N, 0));
        if (glm::dot(n, d) >= 0) {
            args->valid[0] = 0;
            return;
        }
    }
    if (material.alphaCutoff <= 0) return;
    const float u = RTCHitN_u(args->hit, args->N, 0), v = RTCHitN_v(args->hit, args->N, 0);
    const glm::vec3 weights(1 - u - v, u, v);
    const Corners c = cornersOf(part, triangle);
    const glm::vec3 position = weights.x * part.positions[c.index[0]] +
                               weights.y * part.positions[c.index[1]] +
                               weights.z * part.positions[c.index[2]];
    if (baseColorAt(part, triangle, weights, position, *context.footprint).a < material.alphaCutoff)
        args->valid[0] = 0;
}

/// Takes hits on the back of the surface back.
void filterBack(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] != -1) return;
    const glm::vec3 d(RTCRayN_dir_x(args->ray, args->N, 0), RTCRayN_dir_y(args->ray, args->N, 0),
                      RTCRayN_dir_z(args->ray, args->N, 0));
    const glm::vec3 n(RTCHitN_Ng_x(args->hit, args->N, 0), RTCHitN_Ng_y(args->hit, args->N, 0),
                      RTCHitN_Ng_z(args->hit, args->N, 0));
    if (glm::dot(n, d) >= 0) args->valid[0] = 0;
}

/// Takes hits beside what the surface covers back.
void filterBeside(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] != -1) return;
    using Covers = std::function<bool(uint32_t, const glm::vec3&)>;
    const float u = RTCHitN_u(args->hit, args->N, 0), v = RTCHitN_v(args->hit, args->N, 0);
    const auto& covers = *static_cast<const Covers*>(args->geometryUserPtr);
    if (!covers(RTCHitN_primID(args->hit, args->N, 0), {1 - u - v, u, v})) args->valid[0] = 0;
}

template<class T>
T* newBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, size_t count) {
    return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), count));
}

} // namespace

Model::Model(Mesh source) : mesh(std::move(source)) {
    textures.reserve(mesh.textures.size());
    for (const MeshTexture& texture : mesh.textures) textures.emplace_back(texture);
}

Geometry::~Geometry() {
    if (scene_) rtcReleaseScene(scene_);
    if (device_) rtcReleaseDevice(device_);
}

bool Geometry::create(Error& error) {
    // One thread builds: where triangles meet, which of them a ray hits depends on the tree.
    device_ = rtcNewDevice("threads=1");
    if (!device_) {
        error.text = "Embree cannot start";
        return false;
    }
    scene_ = rtcNewScene(device_);
    // Without it, rays may pass between triangles that share an edge.
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    return true;
}

void Geometry::add(const Instance& instance, const glm::dvec3& eye) {
    const Mesh& mesh = instance.model->mesh;
    auto part = std::make_unique<OpaquePart>();
    part->model = instance.model;
    part->eyeFromMesh = glm::mat3(glm::dmat3(instance.worldFromMesh));
    part->materials.resize(mesh.indices.size() / 3);
    for (const MeshPart& range : mesh.parts)
        std::fill_n(part->materials.begin() + range.firstIndex / 3, range.indexCount / 3, range.material);

    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const positions =
        newBuffer<glm::vec3>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices.size());
    for (size_t i = 0; i < mesh.vertices.size(); ++i)
        positions[i] =
            glm::vec3(glm::dvec3(instance.worldFromMesh * glm::dvec4(mesh.vertices[i].position, 1)) - eye);
    part->positions = positions;
    auto* const triangles =
        newBuffer<glm::uvec3>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.indices.size() / 3);
    for (size_t i = 0; i < mesh.indices.size() / 3; ++i)
        triangles[i] = {mesh.indices[3 * i], mesh.indices[3 * i + 1], mesh.indices[3 * i + 2]};
    rtcSetGeometryMask(geometry, Kind::opaque);
    rtcSetGeometryUserData(geometry, part.get());
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
    rtcCommitGeometry(geometry);
    const unsigned id = rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    if (parts_.size() <= id) parts_.resize(id + 1);
    parts_[id] = std::move(part);
}

void Geometry::add(const SurfaceMesh& surface) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const positions =
        newBuffer<glm::vec3>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, surface.positions.size());
    std::copy(surface.positions.begin(), surface.positions.end(), positions);
    auto* const triangles =
        newBuffer<glm::uvec3>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, surface.triangles.size());
    std::copy(surface.triangles.begin(), surface.triangles.end(), triangles);
    rtcSetGeometryMask(geometry, Kind::surface);
    if (surface.oneSided) rtcSetGeometryIntersectFilterFunction(geometry, filterBack);
    if (surface.covers) {
        surfaceCovers_ = surface.covers;
        rtcSetGeometryUserData(geometry, &surfaceCovers_);
        rtcSetGeometryIntersectFilterFunction(geometry, filterBeside);
        rtcSetGeometryOccludedFilterFunction(geometry, filterBeside);
    }
    rtcCommitGeometry(geometry);
    surfaceGeometry_ = rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    surfacePositions_ = positions;
    surfaceTriangles_ = triangles;
}

bool Geometry::build(Error& error) {
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) == RTC_ERROR_NONE) return true;
    error.text = "Embree cannot build the scene, is there enough memory?";
    return false;
}

bool Geometry::meets(const Ray& ray, Kind kinds, bool light, Hit& hit) const {
    Context context{{}, &ray.footprint, light};
    rtcInitIntersectContext(&context.embree);
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x;
    query.ray.org_y = ray.origin.y;
    query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction.x;
    query.ray.dir_y = ray.direction.y;
    query.ray.dir_z = ray.direction.z;
    query.ray.tnear = ray.nearest;
    query.ray.tfar = INFINITY;
    query.ray.mask = kinds;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context.embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;

    const bool isSurface = query.hit.geomID == surfaceGeometry_;
    hit.kind = isSurface ? Kind::surface : Kind::opaque;
    hit.distance = query.ray.tfar;
    hit.triangle = query.hit.primID;
    hit.weights = {1 - query.hit.u - query.hit.v, query.hit.u, query.hit.v};
    hit.part = isSurface ? nullptr : parts_[query.hit.geomID].get();
    const glm::vec3* const p = isSurface ? surfacePositions_ : hit.part->positions;
    glm::uvec3 corners;
    if (isSurface) {
        corners = surfaceTriangles_[hit.triangle];
    } else {
        const Corners c = cornersOf(*hit.part, hit.triangle);
        corners = {c.index[0], c.index[1], c.index[2]};
    }
    // More exact than origin + distance * direction.
    hit.position = hit.weights.x * p[corners.x] + hit.weights.y * p[corners.y] + hit.weights.z * p[corners.z];
    hit.geometricNormal = glm::normalize(crossOf(p, corners.x, corners.y, corners.z));
    hit.frontFacing = glm::dot(hit.geometricNormal, ray.direction) < 0;
    return true;
}

bool Geometry::occluded(const glm::vec3& from, const glm::vec3& direction, Kind kinds,
                        const Footprint& footprint, float distance) const {
    Context context{{}, &footprint, true};
    rtcInitIntersectContext(&context.embree);
    RTCRay query{};
    query.org_x = from.x;
    query.org_y = from.y;
    query.org_z = from.z;
    query.dir_x = direction.x;
    query.dir_y = direction.y;
    query.dir_z = direction.z;
    query.tfar = distance;
    query.mask = kinds;
    rtcOccluded1(scene_, &context.embree, &query);
    return query.tfar < 0;
}

glm::vec4 baseColorAt(const OpaquePart& part, uint32_t triangle, const glm::vec3& weights,
                      const glm::vec3& position, const Footprint& footprint) {
    const MeshMaterial& material = part.model->mesh.materials[part.materials[triangle]];
    const Corners c = cornersOf(part, triangle);
    glm::vec4 vertexColor(0);
    for (int corner = 0; corner < 3; ++corner) {
        const MeshVertex& vertex = part.model->mesh.vertices[c.index[corner]];
        for (int i = 0; i < 4; ++i)
            vertexColor[i] += weights[corner] * static_cast<float>(vertex.color[i]) / 65535;
    }
    return material.baseColor * vertexColor *
           textureAt(part, material.baseTexture, triangle, weights, position, footprint);
}

glm::vec4 metallicRoughnessAt(const OpaquePart& part, uint32_t triangle, const glm::vec3& weights,
                              const glm::vec3& position, const Footprint& footprint) {
    const MeshMaterial& material = part.model->mesh.materials[part.materials[triangle]];
    return textureAt(part, material.metallicRoughnessTexture, triangle, weights, position, footprint);
}

float clearanceAt(const glm::vec3& position) {
    return 1e-4f + 2e-5f * glm::length(position);
}

} // namespace demos::reference
