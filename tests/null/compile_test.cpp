// AMD's compiler takes every kernel, and a selection of what is drawn; every_surface_test.cpp draws it all.
#include "tests/null/compiles.h"

namespace tests {

namespace {

using seaglass::Quality;
using seaglass::SidesSeen;
using seaglass::SurfaceOutput;

TEST_F(Compiles, EveryKernel) {
    expectCompiled(water_->kernels());
    expectCompiled(water_->surface({"wflr"}));
    expectAllWith(".comp");
}

TEST_F(Compiles, ASelectionOfSurfaces) {
    const SurfaceChoice choices[] = {
        {"", Quality::low},
        {"lroh", Quality::medium},
        {"w", Quality::high},
        {"wlrh", Quality::low},
        {"wo", Quality::medium, SurfaceOutput::slopes},
        {"wflo", Quality::high},
        {"wfrh", Quality::medium, SurfaceOutput::shaded, SidesSeen::either},
        {"wslr", Quality::highest, SurfaceOutput::shaded, SidesSeen::below},
        {"wsroh", Quality::high},
        {"wfs", Quality::low, SurfaceOutput::motion},
        {"wfslroh", Quality::highest},
        {"wflr", Quality::highest, SurfaceOutput::shaded, SidesSeen::above, true, true},
    };
    for (const SurfaceChoice& choice : choices) expectCompiled(water_->surface(choice));
}

TEST_F(Compiles, Spray) {
    for (const bool straddles : {false, true})
        expectCompiled(water_->spray(
            {.hasWaves = true, .cascades = 4, .foamCascades = 2, .isWarped = true, .straddles = straddles},
            false));
}

} // namespace

} // namespace tests
