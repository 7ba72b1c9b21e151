#include "seaglass/water.h"

#include <algorithm>

namespace seaglass {

namespace {

/// A row of the dial.
struct Step {
    uint32_t cellsPerLevel;
    ShadingDesc shading;
    bool hybrid;
    uint32_t downscale, marchSteps, roofLooks;
    bool bed; ///< is left, where there is one
};

constexpr Step steps[] = {
    {128, {1, 2, 4, 4, 1, 0, false}, false, 2, 32, 0, false},
    {128, {2, 3, 4, 2, 1, 0, false}, false, 2, 64, 6, true},
    {192, {2, 6, 1, 1, 2, 8, true}, true, 1, 64, 6, true},
    {256, {4, 8, 1, 1, 4, 16, true}, true, 1, 128, 6, true},
};

void set(const Step& step, ReflectionDesc& reflection) {
    reflection.downscale = step.downscale;
    reflection.marchSteps = step.marchSteps;
    reflection.roofLooks = step.roofLooks;
    reflection.marchCells = true;
    reflection.coarseKeys = false;
    const bool readsThePicture = reflection.technique != ReflectionTechnique::sky &&
                                 reflection.technique != ReflectionTechnique::planar;
    if (readsThePicture)
        reflection.technique = step.hybrid ? ReflectionTechnique::hybrid : ReflectionTechnique::sspr;
}

} // namespace

void setQuality(Quality quality, BodyDesc* body, ReflectionDesc* reflection) {
    const Step& step = steps[static_cast<size_t>(std::min(quality, Quality::highest))];
    if (body) {
        body->mesh.cellsPerLevel = step.cellsPerLevel;
        const Fresnel fresnel = body->shading.fresnel;
        body->shading = step.shading;
        body->shading.fresnel = fresnel;
        if (!step.bed) body->bed = nullptr;
    }
    if (reflection) set(step, *reflection);
}

} // namespace seaglass
