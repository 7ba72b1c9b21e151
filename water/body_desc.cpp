#include "water/body_desc.h"

#include <glm/vec4.hpp>

#include "reflection/mirror.h"
#include "reflection/reflector.h"
#include "water/extent.h"
#include "water/mesh.h"
#include "water/whitecaps.h"

namespace seaglass {

namespace {

bool coefficientsInRange(const float (&values)[3]) {
    for (const float value : values)
        if (!(value >= 0 && value <= 100)) return false;
    return true;
}

const char* badField(const MeshDesc& desc) {
    if (!(desc.cellSize >= 0.01f && desc.cellSize <= 100))
        return "MeshDesc.cellSize is out of range, expected 0.01 to 100";
    if (desc.cellsPerLevel < fewestInRange || desc.cellsPerLevel > 1024)
        return "MeshDesc.cellsPerLevel is out of range, expected 128 to 1024";
    return nullptr;
}

bool isOneTwoOrFour(uint32_t value) {
    return value == 1 || value == 2 || value == 4;
}

const char* badField(const ShadingDesc& desc) {
    if (!isOneTwoOrFour(desc.mirrorLooks))
        return "ShadingDesc.mirrorLooks is out of range, expected 1, 2 or 4";
    if (desc.refractionLooks < 1 || desc.refractionLooks > 16)
        return "ShadingDesc.refractionLooks is out of range, expected 1 to 16";
    if (desc.bedDownscale < 1 || desc.bedDownscale > 8)
        return "ShadingDesc.bedDownscale is out of range, expected 1 to 8";
    if (desc.causticStep < 1 || desc.causticStep > 8)
        return "ShadingDesc.causticStep is out of range, expected 1 to 8";
    if (!isOneTwoOrFour(desc.slopeLooks)) return "ShadingDesc.slopeLooks is out of range, expected 1, 2 or 4";
    if (desc.waveShadowSteps == 1 || desc.waveShadowSteps > 32)
        return "ShadingDesc.waveShadowSteps is out of range, expected 0 or 2 to 32";
    if (desc.fresnel > Fresnel::schlick) return "ShadingDesc.fresnel is no Fresnel";
    return nullptr;
}

const char* badField(const RefractionDesc& desc) {
    if (!coefficientsInRange(desc.absorption))
        return "RefractionDesc.absorption is out of range, expected 0 to 100";
    if (!coefficientsInRange(desc.backscatter))
        return "RefractionDesc.backscatter is out of range, expected 0 to 100";
    if (!(desc.distortion >= 0 && desc.distortion <= 1))
        return "RefractionDesc.distortion is out of range, expected 0 to 1";
    if (!(desc.scattering >= 0 && desc.scattering <= 100))
        return "RefractionDesc.scattering is out of range, expected 0 to 100";
    return nullptr;
}

const char* badField(const UnderwaterDesc& desc) {
    if (!(desc.meniscus >= 0 && desc.meniscus <= 0.1f))
        return "UnderwaterDesc.meniscus is out of range, expected 0 to 0.1";
    return nullptr;
}

const char* badField(const CausticsDesc& desc) {
    if (!(desc.strength >= 0 && desc.strength <= 1))
        return "CausticsDesc.strength is out of range, expected 0 to 1";
    return nullptr;
}

} // namespace

const char* badField(const BodyDesc& desc) {
    glm::dvec4 plane;
    if (const char* bad = readPlane(desc.plane, plane)) return bad;
    // A normal that was turned there may end on either side of level.
    if (!(plane.y > 1e-6)) return "BodyDesc.plane does not face up, expected a normal whose y is positive";
    if (const char* bad = badField(desc.extent)) return bad;
    if (desc.foam && !desc.waves) return "BodyDesc.foam needs BodyDesc.waves";
    if (desc.wavesOn > WavesOn::cpu) return "BodyDesc.wavesOn is no WavesOn";
    if (desc.waves && desc.wavesOn == WavesOn::cpu && !desc.wavesBackend)
        return "BodyDesc.wavesOn is cpu, which needs BodyDesc.wavesBackend";
    if (desc.foam)
        if (const char* bad = badField(*desc.foam)) return bad;
    if (desc.refraction)
        if (const char* bad = badField(*desc.refraction)) return bad;
    if (desc.reflection)
        if (const char* bad = badField(*desc.reflection)) return bad;
    if (desc.underwater && !desc.refraction) return "BodyDesc.underwater needs BodyDesc.refraction";
    if (desc.underwater)
        if (const char* bad = badField(*desc.underwater)) return bad;
    if (desc.caustics && (!desc.waves || !desc.refraction))
        return "BodyDesc.caustics needs BodyDesc.waves and BodyDesc.refraction";
    if (desc.caustics)
        if (const char* bad = badField(*desc.caustics)) return bad;
    if (desc.bed && !desc.refraction) return "BodyDesc.bed needs BodyDesc.refraction";
    if (desc.bed && !(desc.bed->margin >= 0 && desc.bed->margin <= 1))
        return "BedDesc.margin is out of range, expected 0 to 1";
    if (const char* bad = badField(desc.shading)) return bad;
    return badField(desc.mesh);
}

ReflectionDesc reflectionOf(const ReflectionDesc& desc, bool hasWaves) {
    ReflectionDesc seen = desc;
    if (hasWaves) return seen;
    seen.distortion = 0;
    if (seen.scatter == 0) seen.blurLevels = 0;
    return seen;
}

const WavesBackend* chosenBackend(const gpu::Device& device, const BodyDesc& desc) {
    const bool onCpu = desc.wavesOn == WavesOn::cpu || (desc.wavesOn == WavesOn::automatic && device.isCpu());
    return onCpu ? desc.wavesBackend : nullptr;
}

} // namespace seaglass
