// What shaders cost on a GPU, by AMD's compiler and without one: each kernel, and the surface at each
// quality and with more and more of its features.
//
//   seaglass_bench_shaders [--json]
#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/water/quality.h"
#include "tests/null/compiled_water.h"

namespace {

using namespace tests;

struct Row {
    std::string shader, variant;
    size_t spirvBytes = 0;
    StageCosts costs;
};

/// More and more of what a surface has: SurfaceChoice::letters.
constexpr std::array surfaces = {"", "l", "lr", "w", "wl", "wlr", "wf", "wflr", "wfslr", "wfslroh"};

/// One for each stage, but for those that an earlier variant of the same shader equals.
void add(std::vector<Row>& rows, const std::vector<CompiledPipeline>& pipelines, const std::string& variant) {
    for (const CompiledPipeline& pipeline : pipelines)
        for (const CompiledStage& stage : pipeline.stages) {
            const bool samples = stage.shader.starts_with("waves_");
            const Row row{stage.shader, samples ? std::to_string(stage.constants.front()) : variant,
                          stage.spirvBytes, stage.costs};
            const bool known = std::ranges::any_of(rows, [&](const Row& before) {
                return before.shader == row.shader && before.costs.instructions == row.costs.instructions &&
                       before.costs.vectorRegisters == row.costs.vectorRegisters &&
                       before.spirvBytes == row.spirvBytes;
            });
            if (!known) rows.push_back(row);
        }
}

std::vector<Row> measured(CompiledWater& water) {
    using namespace seaglass;
    std::vector<Row> rows;
    add(rows, water.kernels(), "");
    for (const ViewPass pass : {ViewPass::water, ViewPass::shafts, ViewPass::waterline})
        for (const bool shore : {false, true}) {
            const ViewPassVariant variant = {
                .pass = pass, .straddles = true, .hasWaves = true, .hasShore = shore};
            add(rows, water.overView(variant, false), "");
        }
    add(rows, water.overView({.pass = ViewPass::caustics}, false), "");
    add(rows, water.overView({.pass = ViewPass::snow}, false), "");
    for (const uint32_t fog : {0u, 28u})
        add(rows, water.spray({.cascades = 4, .foamCascades = 3, .isWarped = true, .fogKind = fog}, false),
            fog ? "fog" : "");
    add(rows, water.overView({.pass = ViewPass::surface}, false), "");
    for (const char* const letters : surfaces)
        for (size_t q = 0; q < demos::qualities().size(); ++q) {
            const SurfaceChoice choice = {letters, static_cast<Quality>(q)};
            const std::string variant =
                std::string(letters) + (*letters ? " " : "") + std::string(demos::qualities()[q]);
            add(rows, water.surface(choice), variant);
        }
    return rows;
}

void printJson(const std::string& device, const std::vector<Row>& rows) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Row& r : rows)
        list.push_back({{"shader", r.shader},
                        {"variant", r.variant},
                        {"instructions", r.costs.instructions},
                        {"vgprs", r.costs.vectorRegisters},
                        {"sgprs", r.costs.scalarRegisters},
                        {"waves", r.costs.waves},
                        {"spilled_vgprs", r.costs.spilledVectors},
                        {"spilled_sgprs", r.costs.spilledScalars},
                        {"lds_bytes", r.costs.sharedBytes},
                        {"spirv_bytes", r.spirvBytes}});
    std::printf("%s\n", nlohmann::ordered_json{{"device", device}, {"shaders", list}}.dump(2).c_str());
}

void printTable(const std::string& device, const std::vector<Row>& rows) {
    std::printf("%s\n", device.c_str());
    std::printf("%-32s %-16s %12s %5s %5s %5s %12s %7s %7s\n", "shader", "variant", "instructions", "VGPRs",
                "SGPRs", "waves", "spilled V, S", "LDS, B", "SPIR-V");
    for (const Row& r : rows)
        std::printf("%-32s %-16s %12" PRIu64 " %5" PRIu64 " %5" PRIu64 " %5" PRIu64 " %7" PRIu64 ", %3" PRIu64
                    " %7" PRIu64 " %7zu\n",
                    r.shader.c_str(), r.variant.c_str(), r.costs.instructions, r.costs.vectorRegisters,
                    r.costs.scalarRegisters, r.costs.waves, r.costs.spilledVectors, r.costs.spilledScalars,
                    r.costs.sharedBytes, r.spirvBytes);
}

} // namespace

int main(int count, char** arguments) {
    const bool json = count == 2 && !std::strcmp(arguments[1], "--json");
    if (count > 1 && !json) {
        std::fprintf(stderr, "seaglass_bench_shaders: %s is not known, expected --json or nothing\n",
                     arguments[1]);
        return 2;
    }
    std::string whyNot;
    const std::unique_ptr<CompiledWater> water = CompiledWater::create(whyNot);
    if (!water) {
        std::fprintf(stderr, "seaglass_bench_shaders: %s\n", whyNot.c_str());
        return 1;
    }
    const std::vector<Row> rows = measured(*water);
    json ? printJson(water->nullDevice().name(), rows) : printTable(water->nullDevice().name(), rows);
    return 0;
}
