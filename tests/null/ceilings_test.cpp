// What shaders may take of a GPU's vector registers: the more each takes, the fewer waves hide each other's
// waiting. A SIMD unit of RDNA 2 holds 32 waves of 32 registers each, 8 of 128.
#include <algorithm>
#include <map>

#include "tests/gpu/rig/surface_constant.h"
#include "tests/null/compiles.h"

namespace tests {

namespace {

using seaglass::Quality;

/// Those that Mesa 22.3 gave, which come in eights, and eight more.
struct Ceiling {
    const char* shader;
    uint64_t registers;
    const char* with = nullptr; ///< a constant that must be set: before those without
};

constexpr Ceiling kernels[] = {
    {"blur.comp", 32},
    {"caustics_blur.comp", 48, "hasSunShadow"},
    {"caustics_blur.comp", 32},
    {"caustics_cast.comp", 64, "hasShore"},
    {"caustics_cast.comp", 40},
    {"caustics_gather.comp", 16},
    {"cells.comp", 32},
    {"completed_surface.comp", 32},
    {"edge_reach.comp", 40},
    {"foam.comp", 24},
    {"march_cells.comp", 72},
    {"march_cells_open.comp", 72},
    {"march_strides.comp", 80},
    {"march_strides_open.comp", 80},
    {"mip_chain_rg16f.comp", 40},
    {"mip_chain_rgba16f.comp", 40},
    {"mip_chain_rgba32f.comp", 32},
    {"miss.comp", 24},
    {"open_tiles.comp", 24},
    {"overlay.comp", 24},
    {"planar.comp", 24},
    {"planar_apart.comp", 24},
    {"planar_multisampled.comp", 24},
    {"planar_resolved.comp", 24},
    {"resolve.comp", 56},
    {"resolve_overhangs.comp", 56},
    {"scatter.comp", 40},
    {"scatter_coarse.comp", 48},
    {"seen_columns.comp", 24},
    {"seen_tiles.comp", 24},
    {"single_sample_color.comp", 16},
    {"single_sample_depth.comp", 16},
    {"single_sample_resolved.comp", 32},
    {"stretch.comp", 32},
    {"surface_tiles.comp", 32},
    {"temporal.comp", 104},
    {"tiles.comp", 24},
    {"tiles_overhangs.comp", 48},
    {"unseen_tiles.comp", 16},
    {"waves_columns.comp", 120},
    {"waves_rows.comp", 120},
};

struct SurfaceCeiling {
    const char* letters;
    Quality quality;
    uint64_t registers;
    uint64_t instructions = 4000;
};

/// Of each step that shades them.
constexpr SurfaceCeiling surfaces[] = {
    {"lr", Quality::medium, 64},           {"w", Quality::medium, 56, 1300},
    {"w", Quality::highest, 88},           {"wl", Quality::highest, 136},
    {"wlr", Quality::medium, 64, 1800},    {"wflr", Quality::low, 72, 2200},
    {"wflr", Quality::medium, 64, 1800},   {"wflr", Quality::high, 88, 2800},
    {"wflr", Quality::highest, 136, 3000}, {"wfslr", Quality::medium, 120, 2700},
    {"wfslr", Quality::high, 120, 3650},   {"wfslroh", Quality::medium, 120, 2900},
    {"wfslroh", Quality::high, 120, 3950}, {"wfslroh", Quality::highest, 120},
};

class Ceilings : public Compiles {
  protected:
    void SetUp() override {
        Compiles::SetUp();
        if (water_ && water_->nullDevice().name().find("Mesa 22.3") == std::string::npos)
            GTEST_SKIP() << "registers are Mesa 22.3's, and this is " << water_->nullDevice().name();
    }
};

bool isOf(const Ceiling& ceiling, const CompiledStage& stage) {
    return ceiling.shader == stage.shader &&
           (!ceiling.with || stage.constants.at(surfaceConstant(ceiling.with)) != 0);
}

/// That no register of lanes is spilled to memory either.
void expectWithin(uint64_t ceiling, const CompiledStage& stage) {
    EXPECT_LE(stage.costs.vectorRegisters, ceiling) << stage.shader;
    EXPECT_EQ(stage.costs.spilledVectors, 0u) << stage.shader;
}

TEST_F(Ceilings, OfKernels) {
    for (const CompiledPipeline& pipeline : water_->kernels()) {
        ASSERT_EQ(pipeline.result, VK_SUCCESS);
        const CompiledStage& stage = pipeline.last();
        const auto* const found =
            std::ranges::find_if(kernels, [&](const Ceiling& ceiling) { return isOf(ceiling, stage); });
        if (found == std::end(kernels)) {
            ADD_FAILURE() << stage.shader << " has no ceiling; it takes " << stage.costs.vectorRegisters;
            continue;
        }
        expectWithin(found->registers, stage);
    }
}

TEST_F(Ceilings, OfSurfaces) {
    for (const SurfaceCeiling& ceiling : surfaces) {
        SCOPED_TRACE(std::string(ceiling.letters) + ", quality " +
                     std::to_string(static_cast<int>(ceiling.quality)));
        const std::vector<CompiledPipeline> made = water_->surface({ceiling.letters, ceiling.quality});
        ASSERT_GE(made.size(), 3u) << water_->message();
        expectWithin(64, made[0].stages.front());
        expectWithin(24, made[0].last());
        expectWithin(24, made[1].last());
        for (size_t step = 2; step < made.size(); ++step) {
            expectWithin(ceiling.registers, made[step].last());
            EXPECT_LE(made[step].last().costs.instructions, ceiling.instructions);
        }
    }
    const std::vector<CompiledPipeline> placed =
        water_->overView({.pass = seaglass::ViewPass::surface}, false);
    ASSERT_EQ(placed.size(), 1u) << water_->message();
    EXPECT_LE(placed.front().last().costs.instructions, 60u);
}

TEST_F(Ceilings, OfSpray) {
    for (const bool all : {false, true}) {
        const std::vector<CompiledPipeline> made = water_->spray({.hasWaves = true,
                                                                  .cascades = 4,
                                                                  .foamCascades = 3,
                                                                  .isWarped = true,
                                                                  .hasSunShadow = all,
                                                                  .fogKind = all ? 28u : 0u,
                                                                  .straddles = all},
                                                                 false);
        ASSERT_EQ(made.size(), 1u) << water_->message();
        expectWithin(all ? 56 : 48, made.front().stages.front());
        expectWithin(32, made.front().last());
    }
}

} // namespace

} // namespace tests
