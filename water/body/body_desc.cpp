#include "water/body/body_desc.h"

#include <glm/vec4.hpp>

#include "gpu/view/plane.h"
#include "seaglass/fields/reflection.h"
#include "seaglass/fields/sea.h"
#include "seaglass/fields/water.h"
#include "water/mesh/extent.h"
#include "water/mesh/mesh.h"

namespace seaglass {

namespace {

template<typename Desc>
FieldError badPart(const FieldTable& table, const Desc* part) {
    return part ? badField(table, part) : FieldError();
}

static_assert(meshFieldRows[1].low == fewestInRange);

/// What parts need of each other.
const char* badParts(const BodyDesc& desc) {
    if (desc.foam && !desc.waves) return "BodyDesc.foam needs BodyDesc.waves";
    if (desc.waves && desc.wavesOn == WavesOn::cpu && !desc.wavesBackend)
        return "BodyDesc.wavesOn is cpu, which needs BodyDesc.wavesBackend";
    if (desc.underwater && !desc.refraction) return "BodyDesc.underwater needs BodyDesc.refraction";
    if (desc.caustics && (!desc.waves || !desc.refraction))
        return "BodyDesc.caustics needs BodyDesc.waves and BodyDesc.refraction";
    if (desc.bed && !desc.refraction) return "BodyDesc.bed needs BodyDesc.refraction";
    return nullptr;
}

} // namespace

FieldError badField(const BodyDesc& desc) {
    glm::dvec4 plane;
    if (const char* bad = readPlane(desc.plane, plane)) return bad;
    // A normal that was turned there may end on either side of level.
    if (!(plane.y > 1e-6)) return "BodyDesc.plane does not face up, expected a normal whose y is positive";
    if (const FieldError bad = badField(desc.extent)) return bad;
    if (const FieldError bad = badField(bodyFields, &desc)) return bad;
    if (const char* bad = badParts(desc)) return bad;
    if (const FieldError bad = badPart(foamFields, desc.foam)) return bad;
    if (const FieldError bad = badPart(refractionFields, desc.refraction)) return bad;
    if (const FieldError bad = badPart(reflectionFields, desc.reflection)) return bad;
    if (const FieldError bad = badPart(underwaterFields, desc.underwater)) return bad;
    if (const FieldError bad = badPart(causticsFields, desc.caustics)) return bad;
    if (const FieldError bad = badPart(bedFields, desc.bed)) return bad;
    if (const FieldError bad = badField(shadingFields, &desc.shading)) return bad;
    return badField(meshFields, &desc.mesh);
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
