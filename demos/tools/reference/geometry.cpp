#include "reference/geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "reference/random.h"

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

/// Where the texture of a slot lies at a corner of a triangle.
glm::vec2 cornerUv(const OpaquePart& part, TextureSlot slot, uint32_t triangle, uint32_t corner) {
    const Mesh& mesh = part.model->mesh;
    const bool other = slot != baseSlot && mesh.materials[part.materials[triangle]].otherUvs;
    return other ? mesh.otherUvs[corner][slot - 1] : mesh.vertices[corner].uv;
}

struct Uv {
    glm::vec2 at, right, below;
};

/// Texture coordinates, and what they change by to where the neighbouring pixels meet the triangle's plane.
Uv uvAt(const OpaquePart& part, TextureSlot slot, uint32_t triangle, const glm::vec3& weights,
        const glm::vec3& position, const Footprint& footprint) {
    const Corners c = cornersOf(part, triangle);
    const glm::vec3* const p = part.positions;
    const glm::vec2 uv0 = cornerUv(part, slot, triangle, c.index[0]),
                    uv1 = cornerUv(part, slot, triangle, c.index[1]),
                    uv2 = cornerUv(part, slot, triangle, c.index[2]);
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

/// White where there is none.
glm::vec4 textureAt(const OpaquePart& part, TextureSlot slot, uint32_t triangle, const glm::vec3& weights,
                    const glm::vec3& position, const Footprint& footprint) {
    const MeshMaterial& material = part.model->mesh.materials[part.materials[triangle]];
    const std::optional<uint32_t>& texture = material.textures[slot];
    if (!texture) return glm::vec4(1);
    const Uv uv = uvAt(part, slot, triangle, weights, position, footprint);
    return part.model->textures[*texture].sample(uv.at, uv.right, uv.below);
}

/// A number of 0 to 1 that is a ray's and a triangle's own: in the mean of many rays what blends is as clear
/// as it is said to be.
float chanceOf(const RTCFilterFunctionNArguments* args, uint32_t triangle) {
    uint32_t bits = hash(triangle);
    for (const float value : {RTCRayN_dir_x(args->ray, args->N, 0), RTCRayN_dir_y(args->ray, args->N, 0),
                              RTCRayN_dir_z(args->ray, args->N, 0), RTCRayN_org_x(args->ray, args->N, 0),
                              RTCRayN_org_y(args->ray, args->N, 0), RTCRayN_org_z(args->ray, args->N, 0)})
        bits = hash(bits + std::bit_cast<uint32_t>(value));
    return unitOf(bits);
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
    if (material.alphaCutoff <= 0 && !material.blends) return;
    const float u = RTCHitN_u(args->hit, args->N, 0), v = RTCHitN_v(args->hit, args->N, 0);
    const glm::vec3 weights(1 - u - v, u, v);
    const Corners c = cornersOf(part, triangle);
    const glm::vec3 position = weights.x * part.positions[c.index[0]] +
                               weights.y * part.positions[c.index[1]] +
                               weights.z * part.positions[c.index[2]];
    const float least = material.blends ? chanceOf(args, triangle) : material.alphaCutoff;
    if (baseColorAt(part, triangle, weights, position, *context.footprint).a < least) args->valid[0] = 0;
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

void Geometry::add(const Model& model, const glm::dmat4& worldFromMesh, const glm::dvec3& eye) {
    const Mesh& mesh = model.mesh;
    auto part = std::make_unique<OpaquePart>();
    part->model = &model;
    part->eyeFromMesh = glm::mat3(glm::dmat3(worldFromMesh));
    part->materials.resize(mesh.indices.size() / 3);
    for (const MeshPart& range : mesh.parts)
        std::fill_n(part->materials.begin() + range.firstIndex / 3, range.indexCount / 3, range.material);

    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const positions =
        newBuffer<glm::vec3>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices.size());
    for (size_t i = 0; i < mesh.vertices.size(); ++i)
        positions[i] = glm::vec3(glm::dvec3(worldFromMesh * glm::dvec4(mesh.vertices[i].position, 1)) - eye);
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
           textureAt(part, baseSlot, triangle, weights, position, footprint);
}

Look lookAt(const Hit& hit, const Footprint& footprint) {
    const OpaquePart& part = *hit.part;
    const MeshMaterial& material = part.model->mesh.materials[part.materials[hit.triangle]];
    const auto map = [&](TextureSlot slot) {
        return textureAt(part, slot, hit.triangle, hit.weights, hit.position, footprint);
    };
    const glm::vec3 base(baseColorAt(part, hit.triangle, hit.weights, hit.position, footprint));
    Look look;
    look.unlit = material.unlit;
    look.base = look.diffuse = base;
    if (material.unlit) {
        look.emissive = base;
        return look;
    }
    look.emissive = material.emissive * glm::vec3(map(emissiveSlot));
    look.open = glm::mix(1.0f, map(occlusionSlot).r, material.occlusion);
    const glm::vec4 surface = map(surfaceSlot);
    if (material.specular) {
        look.mirrored = *material.specular * glm::vec3(surface);
        look.roughness = glm::clamp(1 - (1 - material.roughness) * surface.a, 0.06f, 1.0f);
        look.base = look.diffuse = base * (1 - std::max({look.mirrored.r, look.mirrored.g, look.mirrored.b}));
        return look;
    }
    const float metallic = material.metallic * surface.b;
    look.roughness = glm::clamp(material.roughness * surface.g, 0.06f, 1.0f);
    look.mirrored = glm::mix(glm::vec3(0.04f), base, metallic);
    look.diffuse = base * (1 - metallic);
    return look;
}

glm::vec3 mappedNormal(const Hit& hit, const glm::vec3& normal, const Footprint& footprint) {
    const OpaquePart& part = *hit.part;
    const MeshMaterial& material = part.model->mesh.materials[part.materials[hit.triangle]];
    if (!material.textures[normalSlot]) return normal;
    const Corners c = cornersOf(part, hit.triangle);
    const glm::vec3* const p = part.positions;
    const auto uv = [&](int corner) { return cornerUv(part, normalSlot, hit.triangle, c.index[corner]); };
    const glm::vec3 first = p[c.index[1]] - p[c.index[0]], second = p[c.index[2]] - p[c.index[0]];
    const glm::vec2 firstUv = uv(1) - uv(0), secondUv = uv(2) - uv(0);
    const glm::vec3 fromFirst = glm::cross(second, normal), fromSecond = glm::cross(normal, first);
    const float side = glm::dot(glm::cross(first, second), normal) < 0 ? -1.0f : 1.0f;
    const glm::vec3 alongU = side * (fromFirst * firstUv.x + fromSecond * secondUv.x);
    const glm::vec3 alongV = side * (fromFirst * firstUv.y + fromSecond * secondUv.y);
    const float longest = std::max(glm::dot(alongU, alongU), glm::dot(alongV, alongV));
    if (longest <= 0) return normal;
    const glm::vec4 texel = textureAt(part, normalSlot, hit.triangle, hit.weights, hit.position, footprint);
    const glm::vec3 lean = 2.0f * glm::vec3(texel) - 1.0f;
    const float scale = material.normalScale / std::sqrt(longest);
    return glm::normalize(scale * (lean.x * alongU - lean.y * alongV) + std::max(lean.z, 0.05f) * normal);
}

float clearanceAt(const glm::vec3& position) {
    return 1e-4f + 2e-5f * glm::length(position);
}

} // namespace demos::reference
