// What a body's shaders are told about one view of it.
#pragma once

#include <glm/vec3.hpp>

#include "gpu/view/view.h"
#include "seaglass/water.h"
#include "shaders/shared/body_block.h"

namespace seaglass {

struct Body;
struct BedPicture;

/// For points relative to an `eye` in the body's axes.
void setBed(BodyBlock& block, const BedPicture& bed, const glm::dvec3& eye);

BodyBlock bodyBlock(const Body& body, const ViewGeometry& geometry, const LightingDesc& lighting);

} // namespace seaglass
