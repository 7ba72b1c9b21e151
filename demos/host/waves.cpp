#include "host/waves.h"

#include <numbers>

#ifdef DEMOS_WAVES_FFTW
#include "seaglass/waves_fftw.h"
#endif

namespace demos {

const seaglass::WavesBackend* wavesBackend() {
#ifdef DEMOS_WAVES_FFTW
    return seaglass::fftwWaves();
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

bool seaOf(const WavesDesc& waves, seaglass::SeaDesc& sea, Error& error) {
    if (waves.spectrum == "jonswap") {
        sea.spectrum = seaglass::SpectrumModel::jonswap;
    } else if (waves.spectrum == "pierson-moskowitz") {
        sea.spectrum = seaglass::SpectrumModel::piersonMoskowitz;
    } else {
        error.text =
            "water.waves.spectrum is \"" + waves.spectrum + "\", expected jonswap or pierson-moskowitz";
        return false;
    }
    sea.windSpeed = static_cast<float>(waves.windMps);
    sea.windDirection = static_cast<float>(waves.windTowardsDeg * std::numbers::pi / 180);
    sea.fetch = static_cast<float>(waves.fetchM);
    sea.peakEnhancement = static_cast<float>(waves.peakEnhancement);
    sea.swell = static_cast<float>(waves.swell);
    sea.amplitude = static_cast<float>(waves.amplitude);
    sea.choppiness = static_cast<float>(waves.choppiness);
    sea.samples = waves.samples;
    sea.cascades = waves.cascades;
    sea.largestPatch = static_cast<float>(waves.largestPatchM);
    sea.seed = waves.seed;
    return true;
}

} // namespace demos
