// What the host says of light, checked and as shaders want it.
#pragma once

#include "gpu/fields.h"
#include "water/body/body_block.h"
#include "water/body/body_frame.h"

namespace seaglass {

/// What is wrong with it, if anything is.
FieldError badField(const LightingDesc& lighting);

/// Which code the surface has for it, as shaders/water/surface/surface_fog.glsl reads it: the shape, 8 where
/// it lies over the sky, 16 where its colour is the sky's. 0: none.
uint32_t fogKind(const FogDesc* fog);

/// For a body in these axes, and points relative to an `eye` in them.
void setSunShadow(BodyBlock& block, const SunShadow& shadow, const BodyFrame& frame, const glm::dvec3& eye);

} // namespace seaglass
