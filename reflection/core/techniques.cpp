// All techniques, by their names: each is defined in its own folder.
#include "reflection/core/technique.h"

namespace seaglass {

Technique ssprTechnique();
Technique ssrTechnique();
Technique hybridTechnique();
Technique planarTechnique();

const Technique& techniqueOf(ReflectionTechnique which) {
    static const Technique sky, sspr = ssprTechnique(), ssr = ssrTechnique(), hybrid = hybridTechnique(),
                                planar = planarTechnique();
    switch (which) {
    case ReflectionTechnique::sky:
        break;
    case ReflectionTechnique::sspr:
        return sspr;
    case ReflectionTechnique::ssr:
        return ssr;
    case ReflectionTechnique::hybrid:
        return hybrid;
    case ReflectionTechnique::planar:
        return planar;
    }
    return sky;
}

} // namespace seaglass
