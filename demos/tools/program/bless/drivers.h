// Which driver made references: driver.txt beside them says it, or in a folder above.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace demos {

/// Of this machine's first device that is supported, such as "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"; empty if
/// there is none.
std::string thisDriver();

/// Of a reference; empty if nothing says it.
std::string driverOf(const std::filesystem::path& reference);

/// Says it in the reference's own folder, unless it is said already.
bool noteDriver(const std::filesystem::path& reference, const std::string& driver, Error& error);

} // namespace demos
