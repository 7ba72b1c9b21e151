// What a mesh's file says and is not drawn so: a warning, or with --strict an error.
#include <gtest/gtest.h>

#include "tests/gltf/plate.h"
#include "tests/program/refused.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"

namespace {

using tests::Outcome;

class Strict : public testing::Test {
  protected:
    Strict() {
        tests::writeSample(folder_.path());
        tests::Plate plate;
        plate.material()["extensions"]["VENDOR_glitter"] = tests::Json::object();
        plate.node()["extensions"]["VENDOR_bent"] = tests::Json::object();
        tests::writeAll(folder_.path() / "plate.gltf", plate.text());
        std::string scene = tests::sampleScene();
        scene.replace(scene.find("tetra"), 5, "plate");
        tests::writeAll(folder_.path() / "plate.toml", scene);
    }

    Outcome run(const std::vector<std::string>& arguments) const {
        return tests::run(SEAGLASS_PROGRAM, {arguments, {}, folder_.path()});
    }
    std::vector<std::string> outputs() const { return tests::namesIn(folder_.path() / "out"); }

    tests::TemporaryFolder folder_;
};

TEST_F(Strict, WithoutItEachIsAWarning) {
    const Outcome render = run({"render", "plate.toml", "-o", "out/a.png", "--size", "32x18"});
    EXPECT_EQ(render.code, 0) << render.err;
    EXPECT_EQ(tests::countLines(render.err), 2u) << render.err;
    EXPECT_TRUE(render.err.starts_with("warning: plate.toml:14: mesh.0.file: ")) << render.err;
    EXPECT_NE(render.err.find("plate.gltf: nodes[0]: \"VENDOR_bent\" is left out"), std::string::npos);
    const Outcome traced = run({"reference", "plate.toml", "-o", "out/a.exr", "--size", "16x9"});
    EXPECT_EQ(traced.code, 0) << traced.err;
    EXPECT_EQ(traced.err, render.err);
    const Outcome own =
        run({"render", "scene.toml", "--mesh", "plate.gltf", "-o", "out/a.png", "--size", "32x18"});
    EXPECT_TRUE(own.err.starts_with("warning: --mesh: ")) << own.err;
}

TEST_F(Strict, WithItTheFirstIsAnError) {
    const std::vector<std::string> says = {"--strict: plate.toml:14: mesh.0.file", "plate.gltf: nodes[0]",
                                           "VENDOR_bent", "1 more"};
    expectRefused(run({"render", "plate.toml", "-o", "out/a.png", "--size", "32x18", "--strict"}), says);
    expectRefused(run({"reference", "plate.toml", "-o", "out/a.exr", "--size", "16x9", "--strict"}), says);
    expectRefused(run({"measure", "plate.toml", "-o", "out/measured", "--quick", "--strict"}), says);
    EXPECT_EQ(outputs(), std::vector<std::string>{});
    const Outcome plain = run({"render", "scene.toml", "-o", "out/a.png", "--size", "32x18", "--strict"});
    EXPECT_EQ(plain.code, 0) << plain.err;
    EXPECT_EQ(plain.err, "");
}

TEST_F(Strict, WhatIsHostileIsRefusedInOneLine) {
    const std::string deep =
        R"({"asset":{"version":"2.0"},"extras":)" + std::string(50000, '[') + std::string(50000, ']') + "}";
    tests::writeAll(folder_.path() / "deep.gltf", deep);
    expectRefused(run({"render", "scene.toml", "--mesh", "deep.gltf", "-o", "out/a.png"}),
                  {"--mesh", "deep.gltf", "64 levels"});
}

} // namespace
