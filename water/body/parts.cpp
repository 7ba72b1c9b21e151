// All parts of a body: each is defined in its own folder.
#include "water/body/part.h"

namespace seaglass {

Part extentPart();
Part exclusionVolumesPart();
Part skyPart();
Part fogPart();
Part sunShadowPart();
Part shorePart();
Part foamPart();
Part wavesPart();
Part bedPart();
Part refractionPart();
Part reflectionPart();
Part causticsPart();
Part underwaterPart();
Part shadingPart();
Part glitterPart();
Part gustsPart();
Part sprayPart();

std::span<const Part> parts() {
    // Foam steps with the waves' maps, which are to end at the time asked for.
    static const Part all[] = {
        extentPart(),     exclusionVolumesPart(),
        skyPart(),        fogPart(),
        sunShadowPart(),  shorePart(),
        foamPart(),       wavesPart(),
        bedPart(),        refractionPart(),
        reflectionPart(), causticsPart(),
        underwaterPart(), shadingPart(),
        glitterPart(),    gustsPart(),
        sprayPart(),
    };
    return all;
}

} // namespace seaglass
