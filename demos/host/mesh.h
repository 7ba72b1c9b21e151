// The opaque things of a scene on the device, and how they are drawn: relative to the eye, so that a float
// suffices at any distance from the origin.
#pragma once

#include <map>
#include <set>

#include "host/files/mesh_file.h"
#include "host/vulkan/layouts.h"
#include "host/vulkan/pipeline.h"
#include "host/water/bent_sun.h"
#include "host/water/placement.h"

namespace demos {

/// A box in the world.
struct Box {
    glm::dvec3 corners[8];
};

struct GpuMaterial {
    DrawConstants constants; ///< the transform is filled in when drawing
    uint32_t features = 0;   ///< MaterialFeature
    bool doubleSided = false;
    VkDescriptorSet textures = VK_NULL_HANDLE;
};

struct GpuMesh {
    Buffer vertices, otherUvs, indices;
    std::vector<Image> images;
    std::vector<UniqueSampler> samplers;
    std::vector<GpuMaterial> materials;
    std::vector<MeshPart> parts;
    UniqueDescriptorPool pool;
    glm::vec3 low{0}, high{0};
};

struct MeshInstance {
    const GpuMesh* mesh = nullptr;
    Placed placed;
    glm::dmat4 worldFromMesh{1}; ///< as placeMeshes() last set it
};

struct MeshSet {
    Image white;
    UniqueSampler whiteSampler;
    std::map<std::filesystem::path, GpuMesh> meshes; ///< each file once
    std::vector<MeshInstance> instances;
    std::vector<std::string> leftOut; ///< Mesh::leftOut, behind the file's name
};

/// For water that lies at `levelM` where it is calm.
bool loadMeshes(Device& device, const Layouts& layouts, const std::vector<MeshDesc>& descs, double levelM,
                MeshSet& out, Error& error);

/// Where they are at a time, when the water is so.
bool placeMeshes(MeshSet& meshes, double timeS, const WaterAt& water, Error& error);

/// Of all materials that are drawn.
std::set<uint32_t> featuresOf(const MeshSet& meshes);

std::vector<Box> worldBounds(const MeshSet& meshes);

/// What of a mesh casts a shadow, as in shaders/draw.glsl.
enum class Casts { all, straight, bent };

/// One pipeline for each combination of features that a pass tells apart.
struct FeaturePipelines {
    uint32_t toldApart = 0; ///< MaterialFeature
    std::map<uint32_t, UniquePipeline> byFeatures;

    VkPipeline of(uint32_t features) const { return byFeatures.at(features & toldApart).get(); }
    /// Makes those that are missing.
    bool make(const Device& device, VkPipelineLayout layout, const PipelineDesc& desc,
              const std::set<uint32_t>& features, Error& error);
};

struct MeshPipelines {
    const FeaturePipelines* pipelines = nullptr;
    bool cullBack = true;      ///< back faces of materials that have none
    uint32_t cascade = 0;      ///< of the shadow map
    glm::dmat4 clipFromEye{1}; ///< parts outside its clip volume, depth aside, are not drawn
    bool mirrored = false;     ///< front faces are wound the other way round
    Casts casts = Casts::all;  ///< of what `sun` tells apart
    const BentSun* sun = nullptr;
    VkPipeline cut = VK_NULL_HANDLE; ///< for parts of which some is left out
};

/// Needs set 0 bound.
void drawMeshes(VkCommandBuffer commands, const Layouts& layouts, const MeshSet& meshes,
                const glm::dvec3& eye, const MeshPipelines& pipelines);

} // namespace demos
