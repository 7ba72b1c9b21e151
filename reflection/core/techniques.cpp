// All techniques, by their names: each is defined in its own folder.
#include <iterator>

#include "reflection/core/technique.h"

namespace seaglass {

Technique ssprTechnique();
Technique ssrTechnique();
Technique hybridTechnique();
Technique planarTechnique();

const Technique& techniqueOf(ReflectionTechnique which) {
    // In the order of ReflectionTechnique.
    static const Technique all[] = {
        {}, // sky
        ssprTechnique(),
        ssrTechnique(),
        hybridTechnique(),
        planarTechnique(),
    };
    static_assert(std::size(all) == std::size(reflectionTechniques));
    return all[static_cast<uint32_t>(which)];
}

} // namespace seaglass
