#include "host/water/waves.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <utility>

#include "host/files/spectrum_file.h"
#include "seaglass/sea.h"

#ifdef DEMOS_WAVES_FFTW
#include "seaglass/waves_fftw.h"
#endif

namespace demos {

namespace {

using seaglass::SpectrumModel;
using seaglass::WaterType;

constexpr std::array<std::pair<std::string_view, WaterType>, 4> waterTypes = {{
    {"pool", WaterType::pool},
    {"clear-ocean", WaterType::clearOcean},
    {"coastal", WaterType::coastal},
    {"turbid", WaterType::turbid},
}};

/// The value of an enum whose names these are.
template<class Model, class Names>
bool choose(const char* field, const std::string& name, const Names& names, Model& model, Error& error) {
    const auto* const named = std::ranges::find(names, std::string_view(name));
    if (named != std::end(names)) {
        model = static_cast<Model>(named - std::begin(names));
        return true;
    }
    error.text = "water.waves.";
    error.text.append(field).append(" is \"").append(name).append("\", expected one of");
    for (const char* const known : names) error.text.append(&known == names ? " " : ", ").append(known);
    return false;
}

float radians(double degrees) {
    return static_cast<float>(degrees * std::numbers::pi / 180);
}

seaglass::SwellDesc swellOf(const SwellDesc& swell) {
    return {.height = static_cast<float>(swell.heightM),
            .peakPeriod = static_cast<float>(swell.periodS),
            .direction = radians(swell.towardsDeg),
            .bandwidth = static_cast<float>(swell.bandwidth),
            .spreading = static_cast<float>(swell.spreading)};
}

void setWind(const WavesDesc& waves, seaglass::SeaDesc& sea) {
    const float direction = radians(waves.windTowardsDeg);
    size_t next = 0;
    if (waves.beaufort != WavesDesc::noForce) {
        sea = seaglass::beaufortSea(waves.beaufort, direction);
        if (sea.swells[0].height > 0) next = 1;
    } else {
        sea.windSpeed = static_cast<float>(waves.windMps);
        sea.windDirection = direction;
        sea.fetch = static_cast<float>(waves.fetchM);
    }
    for (size_t i = 0; i < waves.swells.size() && next < seaglass::maxSwells; ++i, ++next)
        sea.swells[next] = swellOf(waves.swells[i]);
}

/// Scenes hold no tint that tintedWater() refuses, but for what is too little for a float.
seaglass::WaterCoefficients tinted(const RefractionDesc& refraction) {
    float tint[3];
    std::ranges::transform(refraction.tint, tint, [](double c) {
        return std::max(static_cast<float>(c), std::numeric_limits<float>::min());
    });
    seaglass::WaterCoefficients water{};
    seaglass::tintedWater(tint, static_cast<float>(refraction.visibilityM), &water, nullptr);
    return water;
}

} // namespace

const seaglass::WavesBackend* wavesBackend() {
#ifdef DEMOS_WAVES_FFTW
    return seaglass::fftwWaves(2);
#else
    return nullptr;
#endif
}

bool wavesOnOf(const WavesDesc& waves, seaglass::WavesOn& on, Error& error) {
    if (waves.backend == "automatic") {
        on = seaglass::WavesOn::automatic;
    } else if (waves.backend == "gpu") {
        on = seaglass::WavesOn::gpu;
    } else if (waves.backend != "fftw") {
        error.text = "water.waves.backend is \"" + waves.backend + "\", expected automatic, gpu or fftw";
        return false;
    } else if (!wavesBackend()) {
        error.text = "water.waves.backend is \"fftw\", which this program was built without (SEAGLASS_FFTW)";
        return false;
    } else {
        on = seaglass::WavesOn::cpu;
    }
    return true;
}

bool seaOf(const WavesDesc& waves, SceneSea& out, Error& error) {
    seaglass::SeaDesc& sea = out.desc;
    setWind(waves, sea);
    if (!choose("spectrum", waves.spectrum, seaglass::spectrumModels, sea.spectrum, error) ||
        !choose("spreading", waves.spreading, seaglass::spreadingModels, sea.spreading, error))
        return false;
    if (sea.spectrum == SpectrumModel::table) {
        if (!readSpectrum(waves.spectrumTable, out.table, error)) return false;
        sea.spectrumTable = out.table.data();
        sea.spectrumTableCount = static_cast<uint32_t>(out.table.size());
    }
    sea.capFetch = waves.capFetch;
    sea.depth = static_cast<float>(waves.depthM);
    sea.peakEnhancement = static_cast<float>(waves.peakEnhancement);
    sea.spreadingShape = static_cast<float>(waves.spreadingShape);
    sea.swell = static_cast<float>(waves.swell);
    sea.amplitude = static_cast<float>(waves.amplitude);
    sea.choppiness = static_cast<float>(waves.choppiness);
    sea.samples = waves.samples;
    sea.cascades = waves.cascades;
    sea.largestPatch = static_cast<float>(waves.largestPatchM);
    sea.warp = static_cast<float>(waves.warp);
    sea.seed = waves.seed;
    return true;
}

seaglass::WaterCoefficients coefficientsOf(const RefractionDesc& refraction) {
    for (const auto& [name, type] : waterTypes)
        if (name == refraction.type) return seaglass::waterCoefficients(type);
    if (refraction.visibilityM > 0) return tinted(refraction);
    seaglass::WaterCoefficients given{};
    for (size_t i = 0; i < 3; ++i) {
        given.absorption[i] = static_cast<float>(refraction.absorptionPerM[i]);
        given.backscatter[i] = static_cast<float>(refraction.backscatterPerM[i]);
    }
    return given;
}

} // namespace demos
