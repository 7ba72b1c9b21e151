// What an ICC profile says of a picture's colours (ICC.1:2010): those by a matrix and one curve, as screens
// and cameras have.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "host/files/color/primaries.h"

namespace demos {

struct ProfileColor {
    double gamma = 0; ///< of what is stored, light to that power; 0: it is by sRGB's curve
    Primaries primaries{};
};

/// What is stored, 0..1, as light by such a gamma.
double lightOf(double stored, double gamma);

/// Null for profiles by tables, of grey or of inks, and for broken ones.
std::optional<ProfileColor> readProfile(std::span<const uint8_t> profile);

/// Its description in ASCII, '?' for what is none; empty where there is none.
std::string profileName(std::span<const uint8_t> profile);

bool isCalledSRgb(const std::string& name);

} // namespace demos
