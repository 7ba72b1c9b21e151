// What is behind seaglass::Body: its place, its sea, and the parts that its description asked for.
#pragma once

#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/context.h"
#include "seaglass/water.h"
#include "water/body/body_frame.h"
#include "water/body/exclusion_volumes.h"
#include "water/body/part.h"
#include "water/mesh/placing.h"
#include "water/sea/sea.h"
#include "water/surface/last_views.h"
#include "water/surface/surface.h"

namespace seaglass {

struct SeaDeleter {
    void operator()(Sea* sea) const { destroySea(sea); }
};
using SeaPointer = std::unique_ptr<Sea, SeaDeleter>;

/// Of a usable description: null where it asks for none or for one that is flat, by branch.
Status seaOf(const gpu::Device& device, const BodyDesc& desc, SeaPointer& out);

/// One that a body has.
struct PartOfBody {
    const Part* part = nullptr;
    std::shared_ptr<void> state;
};

/// What is seen of a body's surface.
struct SeenSurface {
    BodyView view;
    SurfaceDraw drawn;
    PlacedMesh mesh; ///< no instance: nothing
    BodyBlock block; ///< where there is something
};

/// Whatever is not of a Reflector is in the body's own axes.
struct Body : Held {
    BodyFrame frame;
    glm::dvec4 plane{0};
    ShadingDesc shading;
    bool keepsMotion = false; ///< of its waves, where it has some
    SeaPointer sea;           ///< null when flat
    Placing placing;
    std::vector<ExclusionPlanes> exclusionVolumes;
    std::vector<PartOfBody> has; ///< in the order of parts()
    LastViews lastViews;
    uint64_t simulatedIn = 0, drawnIn = 0; ///< what frame, last; 0: none
    double simulatedTime = 0;              ///< of what the maps hold [s]
    bool warnedOfEye = false;              ///< that it is under water

    Status create(Context& owner, const BodyDesc& desc);
    Status simulate(VkCommandBuffer commands, double time);
    Status reflect(VkCommandBuffer commands, SceneOfCall& scene);
    /// Its surface.
    Status draw(const DrawCall& call, SurfaceOutput output);
    /// What else its parts draw over the view.
    Status drawParts(const DrawCall& call, DrawMoment moment);
    /// What draw() and its like would make for such a view and lighting, which may be null. Beside calls that
    /// record on another thread: reads nothing that they write.
    Status prepare(Target& target, const ViewDesc* view, const LightingDesc* lighting,
                   SurfaceOutput output) const;
    SurfaceVariant surfaceVariant(const SurfaceDraw& draw) const;

    /// Null where the body has no such part.
    template<typename T>
    T* find() {
        for (const PartOfBody& each : has)
            if (each.part->tag == &partTag<T>) return static_cast<T*>(each.state.get());
        return nullptr;
    }
    template<typename T>
    const T* find() const {
        return const_cast<Body*>(this)->find<T>();
    }

    /// Of a point above the calm surface [m].
    double heightOf(const glm::dvec3& point) const { return glm::dot(glm::dvec3(plane), point) + plane.w; }
    glm::dvec3 toSun(const LightingDesc& lighting) const {
        return frame.fromWorld(glm::dvec3(lighting.toSun[0], lighting.toSun[1], lighting.toSun[2]));
    }
    /// Of a view in the world. Says what is wrong with it.
    FieldError readTurned(const ViewDesc& view, bool seesScene, ViewGeometry& out) const;
    /// For draw() and its like, by name, which must have called before what they draw. The view may have no
    /// scene unless it is `wanted` by name.
    Status read(const char* call, const ViewDesc& view, const LightingDesc& lighting, const char* wanted,
                BodyView& out);
    /// The same of a view of the surface. `out` refers to `drawn`.
    Status readSurface(const char* call, const ViewDesc& view, const LightingDesc& lighting,
                       SurfaceOutput output, BodyView& out, SurfaceDraw& drawn);
    /// What that shows of the surface. `target`: that it is drawn into; null: images of the library's own.
    Status see(const char* call, const Target* target, SeenSurface& seen);
    /// That it runs the view's way.
    Status checkDepth(const Target& target, const ViewGeometry& geometry) const;
    SidesSeen sidesSeen(const ViewGeometry& geometry) const;
    /// Whether water may be where lines of sight begin.
    bool mayBeWet(const glm::dvec3& point) const;
    /// False: the view sees nothing of the body.
    bool maySee(const ViewGeometry& geometry);
    /// What of the body cannot do without the scene's images, by its field; null: nothing.
    const char* needsScene() const;

  private:
    /// An eye under water that the body is not made for: refused where the view must be another matrix than
    /// is asked for, else warned of once.
    Status checkEye(const char* call, const ViewDesc& view, const ViewGeometry& geometry);
};

} // namespace seaglass
