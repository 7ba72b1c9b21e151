// Whether the header of an OpenEXR file asks for no more than there is. OpenEXR allocates what attributes and
// windows say before it looks at how long the file is: 64 bytes then take 2 GiB.
#pragma once

#include <filesystem>
#include <string>

namespace demos {

/// What is wrong with it, in words that do not name the file; empty when nothing is.
std::string exrHeaderProblem(const std::filesystem::path& file);

} // namespace demos
