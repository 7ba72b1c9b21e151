// Each target comes back from all that its corpus holds, and from each of those cut short: what the fuzzers
// found once, and what they begin with.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fuzz/target.h"
#include "tests/program/run.h"

namespace {

class Corpus : public testing::TestWithParam<fuzz::Target> {};
INSTANTIATE_TEST_SUITE_P(, Corpus, testing::ValuesIn(fuzz::targets().begin(), fuzz::targets().end()),
                         [](const auto& info) { return info.param.name; });

TEST_P(Corpus, IsReadToItsEnd) {
    const std::filesystem::path folder = std::filesystem::path(SEAGLASS_CORPUS) / GetParam().name;
    const std::vector<std::string> names = tests::namesIn(folder);
    EXPECT_FALSE(names.empty());
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        const std::string content = tests::readAll(folder / name);
        const fuzz::Bytes bytes = std::as_bytes(std::span(content));
        constexpr size_t cuts = 8;
        for (size_t i = 1; i <= cuts; ++i) GetParam().run(bytes.first(bytes.size() * i / cuts));
    }
}

} // namespace
