// What a bed makes of a sea, place by place: how much of each cascade is left, and of the long waves, which
// feel the bed first, wave trains that it guides. These are handed over to as the bed comes near: three
// trains, of the sea's own peak, direction and height, each a signal in time that arrives at a place when the
// eikonal equation says, so that its crests slow down, close up and turn towards the shore.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "water/interface/sea_contents.h"

namespace seaglass {

struct WaveSystem;

constexpr uint32_t shoreTrains = 3;
/// Of the waves' significant height to the depth, at the most; a regular wave breaks at 0.78 (McCowan 1894).
constexpr double breakingHeight = 0.6;

/// A place, as three texels hold it. Between places it is linear.
struct ShorePlace {
    float depth = 0;                          ///< of calm water, negative on land [m]
    std::array<float, shoreTrains> arrival{}; ///< after the crest entered the map [s]
    float height = 0;                         ///< standard deviation of the trains together [m]
    float breaking = 0;                       ///< 0: none, 1: all do
    float sideways = 0;                       ///< how far the trains move points horizontally, likewise [m]
    float swash = 0;                          ///< by how much the water's edge rises and falls, likewise [m]
    std::array<float, maxCascades> kept{};    ///< of each cascade's amplitude
};
constexpr uint32_t shoreLayers = 3;
/// The water's edge runs down no lower than so often ShorePlace::swash.
constexpr double lowestSwash = -1.2;

/// One train at one time, for places that its crest reaches at steps of that.
struct ShoreRow {
    float height = 0,
          sideways = 0; ///< of the surface, and of its points: of unit variance with the other trains
    float swash = 0;    ///< of the water's edge
    float wet = 0;      ///< up to where the edge has left the sand wet, in the same unit
};

struct ShoreSignal {
    float rowsPerSecond = 0;    ///< of arrival
    float offset = 0;           ///< row of what arrives now at the edge
    uint32_t count = 0;         ///< rows of a train, 2 at least
    float foamFades = 0;        ///< e-folds of what breakers leave, in a period of the peak
    std::vector<ShoreRow> rows; ///< train after train
};

/// The surface that the trains make.
struct ShoreWave {
    double height = 0, rise = 0; ///< [m], [m/s]
    double move[2] = {}, drift[2] = {};
    double slope[2] = {};
    double stretch[3] = {};  ///< dDx/du, dDz/dv, dDx/dv
    double swash = 0;        ///< how far the water's edge moves [m]
    double wetTo = -1e9;     ///< the height up to which sand is wet [m]
    double advected[2] = {}; ///< what the swash has carried foam to the side by [m]
    double rushes = 0;       ///< how fast the water's edge rises [m/s]
    double foam = 0;
    std::array<double, maxCascades> kept{};
    double depth = 0;
    double bedSlope[2] = {};

    /// Where the surface's point comes to lie [m].
    double bed() const { return bedSlope[0] * move[0] + bedSlope[1] * move[1] - depth; }
    /// Of a surface `lift` over wet sand, and elsewhere at `height`.
    double withFilm(double height, double lift) const {
        return wetTo > bed() ? std::max(height, bed() + lift) : height;
    }
};
constexpr double filmLift = 0.012; ///< so that no grain of the sand hides it [m]

class Shore {
  public:
    Shore(const ShoreDesc& desc, const SeaDesc& sea, const WaveSystem& system,
          std::span<const Cascade> cascades);

    ShorePlace at(double u, double v) const;
    /// As finite as its trains are told: 0 for none that is a number.
    static double heldTime(double time);
    /// At any time. Breakers' foam fades in `decayTime` seconds.
    ShoreSignal signalAt(double time, double decayTime) const;
    /// Seconds from a row to the next.
    double rowStep() const;
    uint32_t rowCount() const; ///< of a train
    /// Of a heldTime(): a train's rows that end with row 0, the last at or after `time`: from `oldest` before
    /// it, by visit(back, row).
    void follow(uint32_t train, double time, uint32_t oldest,
                const std::function<void(uint32_t, const ShoreRow&)>& visit) const;
    /// Without what is shorter than four `width`s.
    ShoreWave waveAt(const ShoreSignal& signal, double u, double v, double width) const;

    std::span<const ShorePlace> places() const { return places_; }
    /// Whether any train comes in.
    bool runs() const { return !trains_[0].empty(); }
    const uint32_t* samples() const { return samples_; }
    double spacing() const { return spacing_; }
    const double* origin() const { return origin_; }
    /// The most that trains move a point in any axis [m].
    double reach() const { return reach_; }
    double peak() const { return peak_; }   ///< [rad/s]
    double runUp() const { return runUp_; } ///< [m]
    double slope() const { return slope_; } ///< of the beach at the water's edge
    /// How far the swash carries foam to the side for each metre up; water starts later than the edge rises.
    double carried() const { return 0.2 / slope_; }

  private:
    struct Wave {
        double frequency, amplitude, phase;
    };
    /// Four places, and where between them.
    struct Cell {
        const ShorePlace *first, *second; ///< two along u each
        float u, v;                       ///< 0..1

        float depth() const;
        float arrival(size_t train) const;
        template<class Member>
        float mix(Member&& member) const {
            return std::lerp(std::lerp(member(first[0]), member(first[1]), u),
                             std::lerp(member(second[0]), member(second[1]), u), v);
        }
    };
    Cell cellAt(double u, double v) const;

    void findSlope(double height);
    bool findArrivals(double direction, uint32_t train, std::span<const double> speeds);
    void drawTrains(const SeaDesc& sea, const WaveSystem& system);
    ShorePlace& place(size_t i, size_t j) { return places_[j * samples_[0] + i]; }

    uint32_t samples_[2];
    double spacing_;
    double origin_[2];
    double peak_ = 0, runUp_ = 0, slope_ = 0, reach_ = 0, longest_ = 0;
    std::vector<ShorePlace> places_;
    std::array<std::vector<Wave>, shoreTrains> trains_;
};

} // namespace seaglass
