// seaglass render SCENE.toml -o OUT.{png,exr} ..., seaglass view SCENE.toml ..., seaglass reference ...,
// seaglass measure ..., seaglass compare A B ..., seaglass bless A B ..., seaglass report DIR, seaglass sea
// ..., seaglass devices: see --help.
#pragma once

namespace demos {

/// All of the program for that command line. The exit code.
int runProgram(int argc, char** argv);

} // namespace demos
