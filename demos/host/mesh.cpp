#include "host/mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/gtc/matrix_transform.hpp>

#include "host/water/afloat.h"

namespace demos {
namespace {

VkSamplerAddressMode addressMode(Wrap wrap) {
    switch (wrap) {
    case Wrap::mirror:
        return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case Wrap::clamp:
        return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    default:
        return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    }
}

bool uploadTexture(Device& device, const MeshTexture& texture, GpuMesh& mesh, Error& error) {
    ImageDesc desc;
    desc.format = texture.srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
    desc.extent = {texture.width, texture.height};
    desc.mips = fullMipCount(desc.extent);
    const std::span<const std::byte> level = std::as_bytes(std::span(texture.rgba));
    SamplerDesc sampler;
    sampler.u = addressMode(texture.wrapU);
    sampler.v = addressMode(texture.wrapV);
    const auto filter = [](Filter f) { return f == Filter::nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR; };
    sampler.larger = filter(texture.larger);
    sampler.smaller = filter(texture.smaller);
    if (texture.mips != Mips::linear) sampler.mips = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    sampler.largestMipAlone = texture.mips == Mips::none;
    // On a CPU it costs more than all other shading together, for a barely sharper ground.
    sampler.anisotropic =
        device.info().type != "cpu" && texture.smaller == Filter::linear && texture.larger == Filter::linear;
    return createSampledImage(device, desc, {&level, 1}, mesh.images.emplace_back(), error) &&
           createSampler(device, sampler, mesh.samplers.emplace_back(), error);
}

bool createMaterials(const Device& device, const Layouts& layouts, const Mesh& source, const MeshSet& set,
                     GpuMesh& mesh, Error& error) {
    const auto count = static_cast<uint32_t>(source.materials.size());
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, textureSlots * count};
    VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = count;
    poolInfo.poolSizeCount = 1;
    poolInfo.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    if (!succeeded(vkCreateDescriptorPool(device.handle(), &poolInfo, nullptr, &pool),
                   "vkCreateDescriptorPool", error))
        return false;
    mesh.pool = UniqueDescriptorPool(device.handle(), pool);
    for (const MeshMaterial& material : source.materials) {
        GpuMaterial made;
        made.constants.baseColor = material.baseColor;
        made.constants.emissive = glm::vec4(material.emissive, material.alphaCutoff);
        made.constants.surface = glm::vec4(material.metallic, material.roughness, 0, 0);
        made.constants.specular = glm::vec4(material.specular.value_or(glm::vec3(0)), 0);
        made.constants.maps = glm::vec4(material.normalScale, material.occlusion, 0, 0);
        made.features = material.features();
        made.doubleSided = material.doubleSided;
        VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
        info.descriptorPool = pool;
        info.descriptorSetCount = 1;
        info.pSetLayouts = &layouts.material.get();
        if (!succeeded(vkAllocateDescriptorSets(device.handle(), &info, &made.textures),
                       "vkAllocateDescriptorSets", error))
            return false;
        const auto point = [&](uint32_t binding, const std::optional<uint32_t>& texture) {
            if (texture)
                writeTexture(device, made.textures, binding, mesh.images[*texture].view.get(),
                             mesh.samplers[*texture].get());
            else
                writeTexture(device, made.textures, binding, set.white.view.get(), set.whiteSampler.get());
        };
        for (uint32_t slot = 0; slot < textureSlots; ++slot) point(slot, material.textures[slot]);
        mesh.materials.push_back(made);
    }
    return true;
}

bool uploadMesh(Device& device, const Layouts& layouts, const Mesh& source, const MeshSet& set, GpuMesh& mesh,
                Error& error) {
    for (const MeshTexture& texture : source.textures)
        if (!uploadTexture(device, texture, mesh, error)) return false;
    mesh.parts = source.parts;
    mesh.low = source.low;
    mesh.high = source.high;
    const bool others = !source.otherUvs.empty();
    return createMaterials(device, layouts, source, set, mesh, error) &&
           (!others || createFilledBuffer(device, std::as_bytes(std::span(source.otherUvs)),
                                          VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, mesh.otherUvs, error)) &&
           createFilledBuffer(device, std::as_bytes(std::span(source.vertices)),
                              VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, mesh.vertices, error) &&
           createFilledBuffer(device, std::as_bytes(std::span(source.indices)),
                              VK_BUFFER_USAGE_INDEX_BUFFER_BIT, mesh.indices, error);
}

bool createWhite(Device& device, MeshSet& set, Error& error) {
    const uint8_t pixel[4] = {255, 255, 255, 255};
    const std::span<const std::byte> level = std::as_bytes(std::span(pixel));
    ImageDesc desc;
    desc.format = VK_FORMAT_R8G8B8A8_UNORM;
    return createSampledImage(device, desc, {&level, 1}, set.white, error) &&
           createSampler(device, {}, set.whiteSampler, error);
}

Box boxIn(const glm::dmat4& worldFromMesh, const glm::vec3& low, const glm::vec3& high) {
    Box box;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
        box.corners[i] = glm::dvec3(worldFromMesh * glm::dvec4(corner, 1));
    }
    return box;
}

/// What to draw of a part, and whether the rest of it is to be cut off.
struct Cast {
    bool drawn = true, cut = false;
    Casts casts = Casts::all;
};

Cast castBy(const MeshPart& part, const glm::dmat4& worldFromMesh, const MeshPipelines& pipelines) {
    if (!pipelines.sun) return {};
    const BentShare share = shareOf(*pipelines.sun, boxIn(worldFromMesh, part.low, part.high).corners);
    const bool bent = pipelines.casts == Casts::bent;
    return {bent ? share.some : !share.all, share.some && !share.all,
            share.some ? pipelines.casts : Casts::all};
}

/// Whether a part lies wholly beyond one side of the picture, or behind the eye.
bool outside(const MeshPart& part, const glm::dmat4& clipFromMesh) {
    bool beyond[5] = {true, true, true, true, true};
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 p =
            clipFromMesh * glm::dvec4(i & 1 ? part.high.x : part.low.x, i & 2 ? part.high.y : part.low.y,
                                      i & 4 ? part.high.z : part.low.z, 1);
        const bool past[5] = {p.x<-p.w, p.x> p.w, p.y<-p.w, p.y> p.w, p.w <= 0};
        for (int side = 0; side < 5; ++side) beyond[side] = beyond[side] && past[side];
    }
    return std::any_of(std::begin(beyond), std::end(beyond), [](bool b) { return b; });
}

} // namespace

bool loadMeshes(Device& device, const Layouts& layouts, const std::vector<MeshDesc>& descs, double levelM,
                MeshSet& out, Error& error) {
    if (!createWhite(device, out, error)) return false;
    PlacedTriangles triangles;
    for (const MeshDesc& desc : descs) {
        const auto [entry, fresh] = out.meshes.try_emplace(desc.file);
        std::optional<Mesh> mesh;
        if ((fresh || desc.floats) && !(mesh = readMesh(desc.file, error))) return false;
        if (fresh) {
            triangles.readFile(mesh->fileBytes);
            for (const std::string& line : mesh->leftOut)
                out.leftOut.push_back(desc.file.string() + ": " + line);
            if (!uploadMesh(device, layouts, *mesh, out, entry->second, error)) {
                error.text = desc.file.string() + ": " + error.text;
                return false;
            }
        }
        uint64_t count = 0;
        for (const MeshPart& part : entry->second.parts) count += part.indexCount / 3;
        if (!triangles.place(count, desc.file, error)) return false;
        MeshInstance& instance = out.instances.emplace_back();
        instance.mesh = &entry->second;
        if (!placedOf(desc, mesh ? *mesh : Mesh{}, levelM, instance.placed, error)) return false;
    }
    return placeMeshes(out, 0, {nullptr, 0}, error);
}

bool placeMeshes(MeshSet& meshes, double timeS, const WaterAt& water, Error& error) {
    return std::ranges::all_of(meshes.instances, [&](MeshInstance& instance) {
        return placement(instance.placed, timeS, water, instance.worldFromMesh, error);
    });
}

bool FeaturePipelines::make(const Device& device, VkPipelineLayout layout, const PipelineDesc& desc,
                            const std::set<uint32_t>& features, Error& error) {
    for (const uint32_t all : features) {
        const uint32_t own = all & toldApart;
        if (byFeatures.contains(own)) continue;
        PipelineDesc special = desc;
        uint32_t constants[materialFeatures];
        for (uint32_t i = 0; i < materialFeatures; ++i) constants[i] = own >> i & 1;
        special.constants = constants;
        special.otherUvs = (own & otherUvsFeature) != 0;
        if (!createPipeline(device, layout, special, byFeatures[own], error)) {
            byFeatures.erase(own);
            return false;
        }
    }
    return true;
}

std::set<uint32_t> featuresOf(const MeshSet& meshes) {
    std::set<uint32_t> features;
    for (const auto& [file, mesh] : meshes.meshes)
        for (const MeshPart& part : mesh.parts) features.insert(mesh.materials[part.material].features);
    return features;
}

std::vector<Box> worldBounds(const MeshSet& meshes) {
    std::vector<Box> boxes;
    for (const MeshInstance& instance : meshes.instances)
        boxes.push_back(boxIn(instance.worldFromMesh, instance.mesh->low, instance.mesh->high));
    return boxes;
}

void drawMeshes(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                const glm::dvec3& eye, const MeshPipelines& pipelines) {
    vkCmdSetFrontFace(commands,
                      pipelines.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    VkPipeline bound = VK_NULL_HANDLE;
    for (const MeshInstance& instance : meshes.instances) {
        const GpuMesh& mesh = *instance.mesh;
        const glm::dmat4 eyeFromMesh = glm::translate(glm::dmat4(1), -eye) * instance.worldFromMesh;
        const VkDeviceSize offset = 0;
        vkCmdBindVertexBuffers(commands, 0, 1, &mesh.vertices.buffer.get(), &offset);
        if (const VkBuffer others = mesh.otherUvs.buffer.get())
            vkCmdBindVertexBuffers(commands, 1, 1, &others, &offset);
        vkCmdBindIndexBuffer(commands, mesh.indices.buffer.get(), 0, VK_INDEX_TYPE_UINT32);
        for (const MeshPart& part : mesh.parts) {
            const Cast cast = castBy(part, instance.worldFromMesh, pipelines);
            if (!cast.drawn || outside(part, pipelines.clipFromEye * eyeFromMesh)) continue;
            const GpuMaterial& material = mesh.materials[part.material];
            const bool whole = (material.features & (maskedFeature | ditheredFeature)) == 0;
            const VkPipeline wanted =
                whole && cast.cut ? pipelines.cut : pipelines.pipelines->of(material.features);
            if (wanted != bound) vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, wanted);
            bound = wanted;
            vkCmdSetCullMode(commands, pipelines.cullBack && !material.doubleSided ? VK_CULL_MODE_BACK_BIT
                                                                                   : VK_CULL_MODE_NONE);
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layouts.pipeline.get(), 1, 1,
                                    &material.textures, 0, nullptr);
            DrawConstants constants = material.constants;
            if (material.features & ditheredFeature)
                constants.emissive.w = static_cast<float>((&part - mesh.parts.data()) % 64);
            constants.surface.z = static_cast<float>(pipelines.cascade);
            constants.surface.w = static_cast<float>(cast.casts);
            for (int row = 0; row < 3; ++row)
                constants.eyeFromMesh[row] = glm::vec4(glm::transpose(eyeFromMesh)[row]);
            vkCmdPushConstants(commands, layouts.pipeline.get(), drawStages, 0, sizeof(constants),
                               &constants);
            vkCmdDrawIndexed(commands, part.indexCount, 1, part.firstIndex, 0, 0);
        }
    }
}

} // namespace demos
