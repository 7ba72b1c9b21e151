// The sea's displaced surface: the maps that the GPU is given, looked up as it does, and a mesh fine enough
// to trace.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host/camera.h"
#include "reference/geometry.h"
#include "reference/water/globe.h"
#include "reference/water/outline.h"
#include "reference/water/shore_wave.h"
#include "seaglass/sea.h"

// Not public: of the sea itself.
#include "water/interface/foam_gate.h"
#include "water/interface/foam_layers.h"
#include "water/interface/warp.h"
#include "water/interface/whitecaps.h"

namespace demos::reference {

struct SeaDeleter {
    void operator()(seaglass::Sea* sea) const { seaglass::destroySea(sea); }
};
using SeaPointer = std::unique_ptr<seaglass::Sea, SeaDeleter>;

/// The most that waves are taken to move a point in any axis [m].
double farthestMove(const seaglass::Sea& sea);

/// Positions on the calm plane are (u, v) = world (x, z) in metres. A footprint is the width [m] over which a
/// value is a mean; 0 gives the maps' own samples. Reading is for any number of threads.
class WaterSurface {
  public:
    /// Evaluates the waves, and their foam if there is any. Flat without a sea, or when the sea is calm.
    bool create(const seaglass::Sea* sea, const seaglass::FoamDesc* foam, double timeS, Error& error);
    bool flat() const { return cascades_.empty(); }

    /// Dx, h, Dz.
    glm::vec3 displacement(const glm::dvec2& calm, double footprint) const;

    struct Slopes {
        glm::vec2 mean{0};
        glm::vec3 covariance{0}; ///< uu, vv, uv of what the footprint hides, unresolved waves included
    };
    Slopes slopes(const glm::dvec2& calm, double footprint) const;
    /// Covariance uu, vv, uv of slopes of waves too short for any map.
    const glm::vec3& roughness() const { return roughness_; }

    /// Share of the footprint that is white, and bubbles below: foamCover() of
    /// shaders/water/foam/foam_cover.glsl.
    struct FoamCover {
        float white = 0, plume = 0;
    };
    FoamCover foamCover(const glm::dvec2& calm, const glm::dvec2& bend, double footprint) const;
    /// Where a place lies in the pattern's lace, and in its windrows [m].
    glm::dvec2 onLace(const glm::dvec2& place) const { return onLayer(lace_, place); }
    glm::dvec2 onWindrows(const glm::dvec2& place) const { return onLayer(windrows_, place); }
    /// `place` shifted as the waves of `calm` are.
    glm::dvec2 onWaves(const glm::dvec2& place, const glm::dvec2& calm) const {
        const seaglass::WarpShift shift = seaglass::warpAt(warp_, calm.x, calm.y);
        return place + glm::dvec2(shift.u, shift.v);
    }
    static constexpr double laceRepeatM = 16 * 24, windrowTileM = 160;

    /// The water's edge on a shore: as shaders/water/surface/surface_point.glsl has it.
    struct Edge {
        double presence = 1;    ///< share of the surface that is to be seen
        double onSand = 0;      ///< 1 where it is but a film
        glm::dvec2 advected{0}; ///< what the swash has carried foam by [m]
        glm::dvec2 bedSlope{0};
    };
    Edge edge(const glm::dvec2& calm, double footprint) const;

  private:
    using Level = std::vector<glm::vec4>;
    struct Cascade {
        double patch = 0;
        uint32_t samples = 0;
        std::vector<Level> displacement, derivatives, moments; ///< by mip
        std::vector<Level> foam; ///< in x, plume in y; none where the cascade never breaks
        seaglass::FoamDrift drift;
        double texel() const { return patch / samples; }
    };
    void addFoam(const seaglass::Sea& sea, const seaglass::FoamDesc& foam,
                 const seaglass::WavesBackend& backend, void* state, double timeS);
    static glm::vec4 bilinear(const Cascade& cascade, const std::vector<Level>& map, size_t mip,
                              const glm::dvec2& calm);
    static glm::vec4 trilinear(const Cascade& cascade, const std::vector<Level>& map, double mip,
                               const glm::dvec2& calm);

    ShoreWave shoreAt(const glm::dvec2& calm, double footprint) const {
        return shore_ ? shore_->at(calm, footprint) : ShoreWave{};
    }
    float kept(const ShoreWave& shore, size_t cascade) const {
        return shore_ ? static_cast<float>(shore.kept[cascade]) : 1.0f;
    }
    glm::vec3 displacement(const glm::dvec2& calm, double footprint, const ShoreWave& shore) const;
    Edge edge(const ShoreWave& shore) const;
    /// shoreFoam() of shaders/water/foam/foam_cover.glsl.
    static double edgeFoam(const ShoreWave& shore, double bend);

    /// foamGate() of shaders/water/foam/foam_gate.glsl, of a place on the first cascade's plane.
    float foamGate(const glm::dvec2& place, double footprint) const;

    std::vector<Cascade> cascades_;
    seaglass::Warp warp_;
    std::optional<ShoreWaves> shore_;
    glm::vec3 roughness_{0};
    float breakingNow(const glm::dvec2& place, const ShoreWave& shore, double footprint) const;
    static glm::dvec2 onLayer(const seaglass::FoamLayer& layer, glm::dvec2 place) {
        layer.apply(place.x, place.y);
        return place;
    }

    seaglass::FoamLayer lace_, windrows_;
    seaglass::Breaking breaking_;
    seaglass::FoamGate foamGate_;
};

struct SurfaceMeshDesc {
    double levelM = 0;
    Globe globe; ///< that it lies on
    double aspect = 1;
    uint32_t height = 1;              ///< pixels
    double pixelsACell = 1.5;         ///< edge of a cell as it is seen across the line of sight
    double mostVertices = 3e6;        ///< about; beyond, all cells grow alike
    const Outline* outline = nullptr; ///< at which waves do not move points to the side
    double pinned = 0;                ///< how near to it they begin to do so less [m]
};

/// Rings around the eye's foot, close where it looks and wide elsewhere: one grid bent round, so that no
/// crack opens. Cells grow with distance and what they cannot carry is filtered out of their displacement;
/// the slopes at a hit do not come from the mesh. It ends where the horizon is less than a pixel away.
SurfaceMesh meshOf(const WaterSurface& surface, const Camera& camera, const SurfaceMeshDesc& desc);

} // namespace demos::reference
