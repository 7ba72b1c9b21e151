// A measured spectrum as a text of two columns.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/surroundings.h"
#include "seaglass/sea.h"

namespace demos {

/// Lines of "hertz,density in m^2/Hz", the first of which may be a heading; those that are empty or begin
/// with # are passed over. Errors are a heading that says other units, and a density of nines alone, such as
/// NDBC's 999 for a missing one, and numbers that the sea does not take. False with `error` set, which names
/// the line.
bool readSpectrum(const std::filesystem::path& file, std::vector<seaglass::SpectrumSample>& out,
                  Error& error);

} // namespace demos
