// The colour spaces of FLIP, all relative to the white of sRGB.
#pragma once

#include <array>

namespace demos {

using Rgb = std::array<float, 3>; ///< linear sRGB
using Xyz = std::array<float, 3>; ///< CIE XYZ, each divided by that of white
using Lab = std::array<float, 3>; ///< CIE L*a*b*
/// Y, Cx, Cz of S-CIELAB: L*a*b* without its cube root, linear in light, so that it may be filtered.
using Opponent = std::array<float, 3>;

/// 0..1 of a display's bytes to light.
float decodeSrgb(float encoded);

Xyz xyzOfRgb(const Rgb& rgb);
Rgb rgbOfXyz(const Xyz& xyz);
Opponent opponentOfXyz(const Xyz& xyz);
Xyz xyzOfOpponent(const Opponent& opponent);
Lab labOfXyz(const Xyz& xyz);

} // namespace demos
