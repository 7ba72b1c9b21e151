// What shaders cost on a GPU, by AMD's compiler and without one: each kernel, and the surface at each
// quality and with more and more of its features.
//
//   seaglass_bench_shaders [--json] [LETTERS QUALITY]
//
// With letters, as of SurfaceChoice, of that surface alone at that quality.
#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/water/quality.h"
#include "tests/gpu/rig/surface_constant.h"
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

/// Of kernels that shade, which step.
std::string stepOf(const CompiledStage& stage) {
    constexpr std::array steps = {"", ", bed", ", mirror", ", rest"};
    constexpr size_t constant = surfaceConstant("shadingStep");
    if (stage.shader != "shaded_surface.comp" || stage.constants.size() <= constant) return "";
    return steps[stage.constants[constant]];
}

/// One for each stage, but for those that an earlier variant of the same shader equals.
void add(std::vector<Row>& rows, const std::vector<CompiledPipeline>& pipelines, const std::string& variant) {
    for (const CompiledPipeline& pipeline : pipelines)
        for (const CompiledStage& stage : pipeline.stages) {
            const bool samples = stage.shader.starts_with("waves_");
            const std::string name = variant + stepOf(stage);
            const Row row{stage.shader, samples ? std::to_string(stage.constants.front()) : name,
                          stage.spirvBytes, stage.costs};
            const bool known = std::ranges::any_of(rows, [&](const Row& before) {
                return before.shader == row.shader && before.costs.instructions == row.costs.instructions &&
                       before.costs.vectorRegisters == row.costs.vectorRegisters &&
                       before.spirvBytes == row.spirvBytes;
            });
            if (!known) rows.push_back(row);
        }
}

void addSurface(std::vector<Row>& rows, CompiledWater& water, const std::string& letters, size_t quality) {
    const std::string variant =
        letters + (letters.empty() ? "" : " ") + std::string(demos::qualities()[quality]);
    add(rows, water.surface({letters, static_cast<seaglass::Quality>(quality)}), variant);
}

std::vector<Row> measured(CompiledWater& water) {
    using namespace seaglass;
    std::vector<Row> rows;
    add(rows, water.kernels(), "");
    for (const ViewPass pass : {ViewPass::water, ViewPass::shafts, ViewPass::waterline})
        for (const bool shore : {false, true}) {
            const ViewPassVariant variant = {
                .pass = pass, .hasWaves = true, .hasShore = shore, .straddles = true};
            add(rows, water.overView(variant, false), "");
        }
    add(rows, water.overView({.pass = ViewPass::caustics}, false), "");
    add(rows, water.overView({.pass = ViewPass::snow}, false), "");
    for (const uint32_t fog : {0u, 28u})
        add(rows, water.spray({.cascades = 4, .foamCascades = 3, .isWarped = true, .fogKind = fog}, false),
            fog ? "fog" : "");
    add(rows, water.overView({.pass = ViewPass::surface}, false), "");
    for (const char* const letters : surfaces)
        for (size_t q = 0; q < demos::qualities().size(); ++q) addSurface(rows, water, letters, q);
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
    const bool json = count > 1 && !std::strcmp(arguments[1], "--json");
    const std::vector<std::string> choice(arguments + (json ? 2 : 1), arguments + count);
    const auto quality =
        choice.size() == 2 ? std::ranges::find(demos::qualities(), choice[1]) : demos::qualities().begin();
    if (choice.size() == 1 || choice.size() > 2 || quality == demos::qualities().end()) {
        std::fprintf(stderr, "seaglass_bench_shaders: expected [--json] [LETTERS QUALITY]\n");
        return 2;
    }
    std::string whyNot;
    const std::unique_ptr<CompiledWater> water = CompiledWater::create(whyNot);
    if (!water) {
        std::fprintf(stderr, "seaglass_bench_shaders: %s\n", whyNot.c_str());
        return 1;
    }
    std::vector<Row> rows;
    if (choice.empty())
        rows = measured(*water);
    else
        addSurface(rows, *water, choice[0], static_cast<size_t>(quality - demos::qualities().begin()));
    json ? printJson(water->nullDevice().name(), rows) : printTable(water->nullDevice().name(), rows);
    return 0;
}
