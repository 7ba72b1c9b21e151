// Which driver made references: driver.txt beside them says it, or in a folder above.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace demos {

/// Of this machine's first device that is supported and whose name has `named` in it, such as
/// "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"; empty if there is none.
std::string thisDriver(const std::string& named = {});

/// What --driver says: 'auto' and 'auto:NAME' are looked up.
std::string statedDriver(const std::string& text);

/// Where references of another driver lie, which advise: beside screenshots in
/// screenshots@llvmpipe-Mesa-22.3.6.
std::filesystem::path advisoryFolder(std::filesystem::path references, const std::string& driver);

/// The same for one reference or a folder within references; empty where there are none.
std::filesystem::path advisoryReference(const std::filesystem::path& reference, const std::string& driver);

/// Of a reference; empty if nothing says it.
std::string driverOf(const std::filesystem::path& reference);

/// Of a reference, or of the first that says it in a folder of them.
std::string driverOfAny(const std::filesystem::path& references);

/// Says it in the reference's own folder, unless it is said already.
bool noteDriver(const std::filesystem::path& reference, const std::string& driver, Error& error);

} // namespace demos
