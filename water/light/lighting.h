// What the host says of light, checked and as shaders want it.
#pragma once

#include "gpu/fields.h"
#include "seaglass/host.h"

namespace seaglass {

/// What is wrong with it, if anything is.
FieldError badField(const LightingDesc& lighting);

/// Which code the surface has for it, as shaders/water/surface/surface_fog.glsl reads it: the shape, 8 where
/// it lies over the sky, 16 where its colour is the sky's. 0: none.
uint32_t fogKind(const FogDesc* fog);

} // namespace seaglass
