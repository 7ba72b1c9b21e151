// FLIP: how much a person sees when flipping between two pictures. Andersson, Nilsson, Akenine-Moeller,
// Oskarsson, Aastroem and Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM
// Comput. Graph. Interact. Tech. 3(2), 2020.
#pragma once

#include <functional>
#include <vector>

#include "metrics/image.h"

namespace demos {

/// A 3840 pixel, 0.7 m wide monitor seen from 0.7 m, as its authors assume.
constexpr float standardPixelsPerDegree = 67.0206f;

/// 0 (not seen) .. 1 for each pixel. The pictures have one size and finite values, display-encoded sRGB,
/// clamped to 0..1. Symmetric.
std::vector<float> flip(const PixelView& reference, const PixelView& test,
                        float pixelsPerDegree = standardPixelsPerDegree);

/// The same of pictures that `toLight` makes light of, 0..1: it is given the values of a row.
std::vector<float> flipOf(const PixelView& reference, const PixelView& test,
                          const std::function<void(std::vector<float>&)>& toLight,
                          float pixelsPerDegree = standardPixelsPerDegree);

} // namespace demos
