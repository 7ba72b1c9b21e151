// demos/host/shaders/mirror.frag on the CPU, its mirror traced.
//
// With one sample a pixel the mirror is as sharp as the plane is flat. With more, each sample meets a facet
// of the rough surface: what the shader's blurred reflection and its damped Fresnel term are an estimate of.
#pragma once

#include "reference/frame.h"

namespace demos::reference {

/// `random` is null for one sample a pixel.
glm::vec3 shadeFloor(const Frame& frame, const Ray& ray, const Hit& hit, Random* random);

/// The ray that the flat plane mirrors.
Ray mirrorOfFloor(const Ray& ray, const Hit& hit);

} // namespace demos::reference
