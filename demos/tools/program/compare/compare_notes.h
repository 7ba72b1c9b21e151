// What of two files compare looks at, and what it passes over, in words.
#pragma once

#include "host/files/image_header.h"

namespace demos {

/// Lines for stdout; empty when both hold nothing but the colour that is compared.
std::string compareNotes(const ImageHeader& reference, const ImageHeader& test);

} // namespace demos
