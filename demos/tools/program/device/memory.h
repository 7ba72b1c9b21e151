// Whether pictures fit into memory, before anything is made.
#pragma once

#include "program/compare/values.h"

namespace demos {

/// Attachments, their copies, reflections and read-back of a frame, for each pixel. On a CPU device all of it
/// is ordinary memory.
constexpr double frameBytesAPixel = 160;

/// False with `error` set when what is free is known and less than so many bytes a pixel.
bool fitsMemory(const Size& size, double bytesAPixel, Error& error);

} // namespace demos
