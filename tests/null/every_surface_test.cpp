// AMD's compiler takes all that is drawn: every combination of the surface's features at every quality, and
// at one each side, output, mesh and pass. Some ten minutes of one processor.
#include "tests/null/compiles.h"

namespace tests {

namespace {

using seaglass::Quality;
using seaglass::SidesSeen;
using seaglass::SurfaceOutput;
using seaglass::ViewPass;

TEST_F(Compiles, EverythingDrawn) {
    for (const std::string& letters : surfaceLetters()) {
        for (const Quality quality : {Quality::low, Quality::medium, Quality::high, Quality::highest})
            expectCompiled(water_->surface({letters, quality}));
        for (const SidesSeen sides : {SidesSeen::below, SidesSeen::either})
            if (hasLetter(letters, 'r'))
                expectCompiled(water_->surface({letters, Quality::medium, SurfaceOutput::shaded, sides}));
    }
    for (uint32_t output = 0; output <= static_cast<uint32_t>(SurfaceOutput::motion); ++output)
        for (const char* const letters : {"lroh", "wfslroh"})
            expectCompiled(water_->surface({letters, Quality::medium, static_cast<SurfaceOutput>(output)}));
    for (const char* const letters : {"", "w", "ws", "o", "wo", "wso"})
        for (const SurfaceOutput output : {SurfaceOutput::shaded, SurfaceOutput::motion})
            for (const bool hostMesh : {false, true})
                for (const bool multiview : {false, true})
                    if (!hostMesh || !hasLetter(letters, 'o'))
                        expectCompiled(water_->surface(
                            {letters, Quality::medium, output, SidesSeen::above, hostMesh, multiview}));
    for (const char* const letters : {"lr", "wfslroh"})
        for (const SidesSeen sides : {SidesSeen::below, SidesSeen::either})
            expectCompiled(water_->surface({letters, Quality::medium, SurfaceOutput::reflection, sides}));
    for (const bool multiview : {false, true})
        for (const bool figures : {false, true})
            expectCompiled(
                water_->overView({.pass = ViewPass::surface, .placesFigures = figures}, multiview));
    for (const bool multiview : {false, true})
        expectCompiled(water_->overView({.pass = ViewPass::snow}, multiview));
    for (const ViewPass pass : {ViewPass::water, ViewPass::shafts, ViewPass::waterline, ViewPass::caustics})
        for (const bool multiview : {false, true}) {
            expectCompiled(water_->overView({.pass = pass}, multiview));
            for (const bool shore : {false, true})
                if (pass != ViewPass::caustics)
                    expectCompiled(water_->overView(
                        {.pass = pass, .hasWaves = true, .hasShore = shore, .straddles = true}, multiview));
        }
    for (const bool all : {false, true})
        for (const bool multiview : {false, true})
            expectCompiled(water_->spray({.hasWaves = true,
                                          .cascades = 4,
                                          .foamCascades = 3,
                                          .isWarped = true,
                                          .hasShore = all,
                                          .onGlobe = all,
                                          .hasSunShadow = all,
                                          .fogKind = all ? 28u : 0u,
                                          .tilted = all,
                                          .straddles = all},
                                         multiview));
    expectAllWith(".frag");
    expectAllWith(".vert");
}

} // namespace

} // namespace tests
