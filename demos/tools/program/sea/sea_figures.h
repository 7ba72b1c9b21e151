// What a sea is, measured on its simulated surface, beside what its spectrum asks for.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "water/interface/sea_contents.h"

namespace demos {

/// Of the spectrum, over a band of frequencies.
struct SpectrumBin {
    double omega;     ///< its middle [rad/s]
    double asked;     ///< mean of S [m^2 s]
    double simulated; ///< the same of the surface
};

struct SeaFigures {
    double hsSpectrumM = 0;   ///< of the whole spectrum
    double resolvedShare = 1; ///< of the spectrum's variance, that the cascades carry
    double hsResolvedM = 0;   ///< of that part
    double hsSimulatedM = 0;  ///< of the surface, mean of the seeds
    double tpS = 0;           ///< period of the spectrum's peak; 0 when flat, as those below
    double tzS = 0;           ///< mean zero-crossing period of the whole spectrum
    double tzSimulatedS = 0;  ///< the same of the surface
    double slopesResolved = 0;
    double slopesRoughness = 0;
    double whitecaps = 0;                    ///< share of the surface that foam covers
    std::vector<seaglass::Cascade> cascades; ///< their variance as simulated
    std::vector<SpectrumBin> bins;           ///< where there is energy, from the lowest frequency
};

constexpr uint32_t seaSeeds = 16;

/// Simulates seaSeeds seas from desc.seed on. False with `error` set when the description is refused or
/// memory is short.
bool measureSea(const seaglass::SeaDesc& desc, const seaglass::WavesBackend& backend, SeaFigures& out,
                Error& error);

} // namespace demos
