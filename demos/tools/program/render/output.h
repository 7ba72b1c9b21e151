// Where pictures go: names, and whether they can be written, before anything is rendered.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/text_file.h"

namespace demos {

/// Whether a file can be written there: `option` is what errors call it, `extensions` are the ones allowed.
bool checkOutput(const std::string& option, const std::filesystem::path& file,
                 const std::vector<std::string>& extensions, Error& error);

/// Whether a folder is there or can be made, and can be written to.
bool checkFolder(const std::string& option, const std::filesystem::path& folder, Error& error);

/// False with `error` set when the output is one of the inputs.
bool checkApart(const std::string& option, const std::filesystem::path& output,
                const std::vector<std::filesystem::path>& inputs, Error& error);

/// Of what can be written, which is PNG or EXR.
bool isPng(const std::filesystem::path& file);

/// The file of one frame of a sequence: in place of %d or %04d, or else _0000 before the extension.
std::filesystem::path numbered(const std::filesystem::path& file, uint32_t frame);

} // namespace demos
