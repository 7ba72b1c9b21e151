// Tests that AMD's compiler takes what the libraries make.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/null/built_shaders.h"
#include "tests/null/compiled_water.h"

namespace tests {

class Compiles : public testing::Test {
  protected:
    void SetUp() override {
        std::string whyNot;
        water_ = CompiledWater::create(whyNot);
        if (!water_) GTEST_SKIP() << whyNot;
    }

    void expectCompiled(const std::vector<CompiledPipeline>& pipelines) {
        EXPECT_FALSE(pipelines.empty()) << water_->message();
        for (const CompiledPipeline& pipeline : pipelines) {
            EXPECT_EQ(pipeline.result, VK_SUCCESS) << pipeline.last().shader;
            for (const CompiledStage& stage : pipeline.stages) {
                EXPECT_GT(stage.costs.instructions, 0u) << stage.shader;
                compiled_.insert(stage.shader);
            }
        }
    }

    /// That all of the libraries' shaders whose names end so were, but what only CPU devices have.
    void expectAllWith(const char* suffix) const {
        for (const BuiltShader& shader : builtShaders()) {
            if (!shader.name.ends_with(suffix) || shader.name.find("_copied") != std::string::npos) continue;
            EXPECT_TRUE(compiled_.contains(std::string(shader.name))) << shader.name << " was not compiled";
        }
    }

    std::unique_ptr<CompiledWater> water_;

  private:
    std::set<std::string> compiled_;
};

} // namespace tests
