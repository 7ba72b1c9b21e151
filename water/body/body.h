// What is behind seaglass::Body: the parts that its description asked for, and nothing else.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/context.h"
#include "gpu/view/view.h"
#include "reflection/interface/body_reflector.h"
#include "seaglass/water.h"
#include "water/below/bed.h"
#include "water/below/caustics.h"
#include "water/below/underwater.h"
#include "water/body/body_frame.h"
#include "water/body/exclusion_volumes.h"
#include "water/foam/foam.h"
#include "water/foam/foam_pattern.h"
#include "water/mesh/extent.h"
#include "water/mesh/globe.h"
#include "water/mesh/host_mesh.h"
#include "water/mesh/mesh.h"
#include "water/shore/shore_map.h"
#include "water/surface/surface.h"
#include "water/waves/waves.h"

namespace seaglass {

struct SeaDeleter {
    void operator()(Sea* sea) const { destroySea(sea); }
};

/// The index buffer that every patch of every body is drawn with.
struct PatchIndices {
    gpu::Buffer buffer;
    Status create(Context& context);
};

/// Where the last frame's camera showed things.
struct LastView {
    glm::dmat4 pixelFromRelative{1};
    glm::dvec3 eye{0};
    glm::dvec2 jitter{0}; ///< [pixel]
};

/// In what frames a body was last recorded, so that what comes too late or twice is named.
struct RecordedIn {
    uint64_t simulated = 0, drawn = 0;
    std::array<uint64_t, maxViews> reflected{},
        mirroring{}; ///< by view; `mirroring`: drawn with what was reflected
};

/// What shaders read of a shore's trains, until the frame ends.
struct ShoreRows {
    gpu::Resource rows;
    uint64_t frame = 0;
    bool moves = false; ///< those of the last frame are there, too
};

/// What the pipeline of a surface depends on beside its body and lighting.
struct SurfaceDraw {
    SurfaceOutput output = SurfaceOutput::shaded;
    SidesSeen sides = SidesSeen::above;
    bool seesScene = true; ///< the view has the scene's images
    bool sceneIsEncoded = false;
    bool manySamples = false;         ///< of the scene
    uint32_t reflectionDownscale = 0; ///< of the reflection image; 0: there is none
};

/// Whatever is not of a Reflector is in the body's own axes.
struct Body : Held {
    BodyFrame frame;
    Globe globe;
    glm::dvec4 plane{0};
    MeshDesc mesh;
    ShadingDesc shading;
    std::optional<Outline> outline;       ///< none where the body is unbounded
    std::optional<HostMesh> hostMesh;     ///< the extent is a mesh
    std::unique_ptr<Sea, SeaDeleter> sea; ///< null when flat
    std::optional<Waves> waves;
    WaveDetail detail;
    bool warnedOfEye = false; ///< that it is under water
    bool simulated = false;   ///< the maps hold something
    std::optional<Foam> foam; ///< only where waves break
    std::optional<FoamPattern> foamPattern;
    std::optional<ShoreMap> shore; ///< only of a sea that has one
    ShoreRows shoreRows;
    double foamDecay = double{FoamDesc{}.decayTime};
    std::optional<RefractionDesc> refraction;
    std::optional<UnderwaterDesc> underwater;
    std::optional<Caustics> caustics;     ///< only over waves
    std::optional<Bed> bed;               ///< what refraction looks at from above in the place of the scene
    std::shared_ptr<Reflector> reflector; ///< null without a screen-space technique
    ReflectionDesc reflection;            ///< the reflector's
    std::shared_ptr<SingleSamples> singleSamples; ///< null until refraction sees through a view with many
    float reflectionDistortion = 0;
    std::vector<ExclusionPlanes> exclusionVolumes;
    bool keepsMotion = false;
    std::map<uint32_t, LastView> lastViews; ///< by index, of those that motion was drawn of
    std::shared_ptr<PatchIndices> indices;
    RecordedIn recorded;
    std::vector<MeshPatch> patches; ///< scratch, kept for its capacity
    OutlinedPatches outlined;       ///< likewise

    Status create(Context& owner, const BodyDesc& desc);
    Status simulate(VkCommandBuffer commands, double time);
    Status bedView(const ViewDesc& view, PlanarView& out);
    Status reflect(VkCommandBuffer commands, SceneOfCall& scene);
    Status draw(VkCommandBuffer commands, Target& target, const ViewDesc& view, const LightingDesc& lighting,
                SurfaceOutput output);
    /// What draw() and its like would make for such a view and lighting, which may be null. Beside calls that
    /// record on another thread: reads nothing that they write.
    Status prepare(Target& target, const ViewDesc* view, const LightingDesc* lighting,
                   SurfaceOutput output) const;
    Status castCaustics(VkCommandBuffer commands, const ViewDesc& view, const LightingDesc& lighting);
    Status drawCaustics(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                        const LightingDesc& lighting);
    SurfaceVariant surfaceVariant(const SurfaceDraw& draw, const LightingDesc& lighting) const;
    /// Of an eye in the water: before the surfaces of all bodies, or after. Records nothing for other eyes.
    Status drawUnderwater(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                          const LightingDesc& lighting, UnderwaterPass pass);
    /// Of a point above the calm surface [m].
    double heightOf(const glm::dvec3& point) const { return glm::dot(glm::dvec3(plane), point) + plane.w; }
    /// Edge of the cells that a view's near plane cuts [m].
    double cellNearEye(const ViewGeometry& geometry) const {
        const double asked{mesh.cellSize};
        return hostMesh || geometry.parallel ? asked : seaglass::cellNearEye(displacement(), asked);
    }
    glm::dvec3 toSun(const LightingDesc& lighting) const {
        return frame.fromWorld(glm::dvec3(lighting.toSun[0], lighting.toSun[1], lighting.toSun[2]));
    }

  private:
    /// Of a view in the body's axes. Null, or what is wrong with it.
    FieldError readTurned(const ViewDesc& turned, bool seesScene, ViewGeometry& out) const;
    /// `read`: the view with a scene that shaders sample; it may have none unless it is `wanted` by name.
    Status readForDraw(const ViewDesc& view, const LightingDesc& lighting, ViewGeometry& out, ViewDesc& read,
                       const char* wanted);
    /// An eye under water that the body is not made for: refused where the view must be another matrix than
    /// is asked for, else warned of once.
    Status checkEye(const ViewDesc& view, const ViewGeometry& geometry);
    /// What of the body cannot do without the scene's images, by its field; null: nothing.
    const char* needsScene() const;
    Status prepareSurface(Target& target, const ViewDesc* view, const LightingDesc& lighting,
                          SurfaceOutput output) const;
    Status prepareOverView(Target& target, const ViewDesc* view) const;
    Status prepareKernels(Target& target, const ViewDesc* view, const LightingDesc& lighting) const;
    /// Where refraction sees a multisampled scene, which draw() cannot make single-sampled inside a pass.
    Status takeScene(VkCommandBuffer commands, SceneOfCall& scene);
    /// What a shore's shaders read: nothing without one. `moves`: of the last frame, too.
    Status shoreInputs(bool moves, VkImageView& map, gpu::Resource& rows);
    Status recordOverView(VkCommandBuffer commands, Target& target, const ViewDesc& view,
                          const LightingDesc& lighting, const ViewGeometry& geometry,
                          const UnderwaterVariant& variant);
    SidesSeen sidesSeen(const ViewGeometry& geometry) const;
    /// False: the view sees nothing of the body.
    bool mayShow(const ViewGeometry& geometry);
    Status createWaves(const BodyDesc& desc);
    Status createFoam(const FoamDesc& desc);
    Status createReflector(const BodyDesc& desc);
    /// The last frame's pixels of points relative to this frame's eye; this frame is the next one's last.
    glm::mat4 lastPixelFromRelative(const ViewDesc& view, const ViewGeometry& geometry);
    /// The most that waves move a point in any axis [m].
    double displacement() const { return sea ? largestDisplacement(*sea) : 0; }
    MeshView meshView(const ViewGeometry& geometry) const;
    void placeCells(uint32_t across, SurfaceInputs& inputs) const;
    /// What is to be drawn: no instance when the view sees nothing of the body.
    Status place(const MeshView& view, SurfaceInputs& inputs);
    Status placePatches(const MeshView& view, SurfaceInputs& inputs);
    Status placeOutlined(const MeshView& view, SurfaceInputs& inputs);
    Status placeHostMesh(const MeshView& view, SurfaceInputs& inputs);
};

} // namespace seaglass
