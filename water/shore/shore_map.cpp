#include "water/shore/shore_map.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace seaglass {

namespace {

using Texel = std::array<float, 4>;

gpu::ImageDesc imageDesc(const Shore& shore) {
    gpu::ImageDesc desc;
    desc.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    desc.extent = {shore.samples()[0], shore.samples()[1]};
    desc.layers = shoreLayers;
    desc.arrayView = true;
    return desc;
}

/// In the order of shaders/water/shore/shore.glsl.
std::array<Texel, shoreLayers> texelsOf(const ShorePlace& place) {
    const auto& [first, second, third] = place.arrival;
    const auto& kept = place.kept;
    return {Texel{place.depth, first, second, third},
            Texel{place.height, place.breaking, place.sideways, place.swash},
            Texel{kept[0], kept[1], kept[2], kept[3]}};
}

} // namespace

VkDeviceSize ShoreMap::bytes(const gpu::Device& device, const Shore& shore) {
    return FixedImage::bytes(device, imageDesc(shore));
}

Status ShoreMap::create(Context& context, const Shore& shore) {
    if (const Status s = image_.create(context, imageDesc(shore), "shore map"); s != Status::ok) return s;
    const size_t places = shore.places().size();
    for (size_t i = 0; i < places; ++i) {
        const std::array<Texel, shoreLayers> texels = texelsOf(shore.places()[i]);
        for (size_t layer = 0; layer < shoreLayers; ++layer)
            std::memcpy(image_.texels() + (layer * places + i) * sizeof(Texel), &texels[layer],
                        sizeof(Texel));
    }
    return Status::ok;
}

void ShoreMap::record(const gpu::Device& device, VkCommandBuffer commands, const Shore& shore, double time,
                      double decayTime) {
    image_.recordUpload(device, commands);
    ShoreSignal now = shore.signalAt(time, decayTime);
    last_ = signal_.rows.empty() ? now : std::move(signal_);
    signal_ = std::move(now);
}

} // namespace seaglass
