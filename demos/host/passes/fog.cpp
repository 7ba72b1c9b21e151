#include "host/passes/fog.h"

#include <algorithm>
#include <string_view>

#include "seaglass/fog.h"

namespace demos {

bool fogOf(const FogDesc& desc, seaglass::FogDesc& out, Error& error) {
    using seaglass::FogShape;
    const auto* const named = std::ranges::find(seaglass::fogShapes, std::string_view(desc.shape));
    if (named == std::end(seaglass::fogShapes)) {
        error.text = "fog.shape is \"" + desc.shape +
                     "\", expected linear, exponential, exponential-squared or height";
        return false;
    }
    out.shape =
        static_cast<FogShape>(static_cast<uint32_t>(FogShape::linear) + (named - seaglass::fogShapes));
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
