#include "water/waves/waves_part.h"

#include <cmath>

#include "shaders/shared/water_bindings.h"
#include "water/body/body.h"
#include "water/interface/waves_backend.h"
#include "water/waves/in_tile.h"

namespace seaglass {

const WavesBackend* chosenBackend(const gpu::Device& device, const BodyDesc& desc) {
    const bool onCpu = desc.wavesOn == WavesOn::cpu || (desc.wavesOn == WavesOn::automatic && device.isCpu());
    return onCpu ? desc.wavesBackend : nullptr;
}

FieldError WavesPart::validate(const BodyDesc& desc) {
    if (desc.waves && desc.wavesOn == WavesOn::cpu && !desc.wavesBackend)
        return "BodyDesc.wavesOn is cpu, which needs BodyDesc.wavesBackend";
    return {};
}

Status WavesPart::addCost(const AskedBody& asked, Estimate& sum) {
    const gpu::Device& device = asked.context.device;
    const WavesBackend* backend = chosenBackend(device, asked.desc);
    sum.bytes += Waves::bytes(asked.context, *asked.sea, backend) +
                 (asked.desc.motion ? Waves::lastBytes(device, *asked.sea, backend) : 0);
    return Status::ok;
}

Status WavesPart::create(Body& body, const BodyDesc& desc) {
    const gpu::Device& device = body.context->device;
    if (const Status s = waves.create(*body.context, *body.sea, chosenBackend(device, desc)); s != Status::ok)
        return s;
    return desc.motion ? waves.keepLast(device) : Status::ok;
}

Status WavesPart::simulate(Body& body, VkCommandBuffer commands, double time) {
    return waves.record(*body.context, commands, time);
}

void WavesPart::fill(const Body& body, const BodyView& view, BodyBlock& block) const {
    const Sea& sea = *body.sea;
    const WaveMaps& maps = waves.maps();
    block.seaCascades = static_cast<int32_t>(maps.cascades);
    block.maxMip = static_cast<float>(maps.mipLevels - 1);
    const SlopeCovariance rough = roughness(sea);
    const double whole = std::sqrt((resolvedSlopeVariance(sea) + unresolvedSlopeVariance(sea)) / 2);
    block.roughness = glm::vec4(rough.uu, rough.vv, rough.uv, whole);
    block.heightDeviation = static_cast<float>(significantWaveHeight(sea) / 4);
    const glm::dvec3& eye = view.geometry.eye;
    static_assert(bodyWarpScales == warpScales);
    for (size_t s = 0; s < warpScales; ++s) {
        const auto& [alongU, alongV, amplitude] = sea.warp[s];
        block.warpAlong[s] = glm::vec4(alongU[0], alongU[1], alongV[0], alongV[1]);
        block.warpFrom[s] =
            glm::vec4(warpTurns(alongU, eye.x, eye.z), warpTurns(alongV, eye.x, eye.z), 8 * amplitude, 0);
    }
    const double atRest = warpAtRest(sea.warp);
    for (uint32_t i = 0; i < maps.cascades; ++i) {
        const double patch = cascade(sea, i).patch;
        // Maps hold samples at i * patch / samples, textures at half a texel more.
        const double half = 0.5 / maps.samples;
        block.cascade[i] = glm::vec4(inTile(eye.x - atRest, patch) + half,
                                     inTile(eye.z - atRest, patch) + half, 1 / patch, maps.samples / patch);
    }
}

void WavesPart::vary(const Body& body, const SurfaceDraw&, SurfaceVariant& variant) const {
    variant.hasWaves = true;
    variant.cascades = static_cast<int>(cascadeCount(*body.sea));
    variant.isWarped = description(*body.sea).warp > 0;
    variant.reflectionSamples = static_cast<int>(body.shading.reflectionSamples);
    variant.slopeSamples = static_cast<int>(body.shading.slopeSamples);
    variant.waveShadowSteps = static_cast<int>(body.shading.waveShadowSteps);
    variant.hasParallax = !body.sea->shore && body.shading.parallax;
}

Status WavesPart::bind(Body& body, const BodyView& view, Resources& out) {
    const VkSampler repeat = body.context->samplers.trilinearRepeat();
    constexpr uint32_t numbers[waveMapCount] = {waveDisplacementBinding, waveDerivativesBinding,
                                                waveMomentsBinding};
    for (uint32_t i = 0; i < waveMapCount; ++i)
        out.push_back({numbers[i], gpu::sampledImage(repeat, waves.maps().images[i].view())});
    if (view.surface && view.surface->isMotion())
        out.push_back({lastDisplacementBinding, gpu::sampledImage(repeat, waves.lastDisplacement())});
    return Status::ok;
}

Part wavesPart() {
    return partFrom<WavesPart>();
}

} // namespace seaglass
