// What the command line says of a scene, for every command that draws one.
#pragma once

#include <string>
#include <vector>

#include "program/render/render_options.h"

namespace CLI {
class App;
}

namespace demos {

/// What the line says, before any of it is checked.
struct RawScene {
    std::string scene, size, time, camera, sky, mesh, quality;
    std::vector<std::string> overrides;
    bool strict = false, plain = false;
};

void describeStrict(CLI::App& command, bool& strict);
/// For those that make pictures to be looked at.
void describePlain(CLI::App& command, RawScene& raw);
void describeScene(CLI::App& command, RawScene& raw);
/// For those that draw it with the library.
void describeQuality(CLI::App& command, RawScene& raw);
/// `expected` is how the command is called.
bool checkScene(const RawScene& raw, const char* expected, RenderOptions& out, Error& error);

/// Whether some "path=value" is of this path, or of one within it.
bool sets(const std::vector<std::string>& overrides, const std::string& path);

} // namespace demos
