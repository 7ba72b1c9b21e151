#include "host/passes/fog.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace demos {

bool fogOf(const FogDesc& desc, seaglass::FogDesc& out, Error& error) {
    using seaglass::FogShape;
    using Named = std::pair<std::string_view, FogShape>;
    constexpr Named shapes[] = {{"linear", FogShape::linear},
                                {"exponential", FogShape::exponential},
                                {"exponential-squared", FogShape::exponentialSquared},
                                {"height", FogShape::height}};
    const auto* const named = std::ranges::find(shapes, desc.shape, &Named::first);
    if (named == std::end(shapes)) {
        error.text = "fog.shape is \"" + desc.shape +
                     "\", expected linear, exponential, exponential-squared or height";
        return false;
    }
    out.shape = named->second;
    out.density = static_cast<float>(desc.densityPerM);
    out.start = static_cast<float>(desc.startM);
    out.end = static_cast<float>(desc.endM);
    out.falloff = static_cast<float>(desc.falloffPerM);
    out.baseHeight = desc.baseHeightM;
    for (size_t i = 0; i < 3; ++i) out.color[i] = static_cast<float>(desc.color[i]);
    out.fromSky = static_cast<float>(desc.fromSky);
    out.most = static_cast<float>(desc.most);
    out.overSky = desc.overSky;
    return true;
}

} // namespace demos
