// Two folders of pictures, ref and out, that the program is run beside.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "demos/host/files/image_file.h"
#include "tests/program/run.h"

namespace tests {

class Folders : public testing::Test {
  protected:
    static constexpr uint32_t width = 40, height = 24;

    /// seaglass compare ref out
    Outcome compare(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"compare", "ref", "out"});
        return run(SEAGLASS_PROGRAM, {more, {}, at("")});
    }
    Outcome bless(std::vector<std::string> more) const {
        more.insert(more.begin(), {"bless", "ref", "out"});
        return run(SEAGLASS_PROGRAM, {more, {}, at("")});
    }

    std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }

    /// Grey, but for a square of 6 pixels a side, whose left is given.
    static demos::Picture square(uint32_t left, float value = 0.1f) {
        demos::Picture picture{width, height, std::vector<float>(size_t{4} * width * height, 0.5f)};
        for (uint32_t y = 8; y < 14; ++y)
            for (uint32_t x = left; x < left + 6; ++x)
                std::fill_n(&picture.rgba[4 * (size_t{y} * width + x)], 3, value);
        return picture;
    }

    void write(const std::string& name, const demos::Picture& picture) const {
        std::filesystem::create_directories(at(name).parent_path());
        demos::Error error;
        if (name.ends_with(".exr")) {
            ASSERT_TRUE(demos::writeExr(at(name), picture, error)) << error.text;
            return;
        }
        std::vector<uint8_t> rgb;
        for (size_t i = 0; i < picture.rgba.size(); ++i)
            if (i % 4 != 3) rgb.push_back(static_cast<uint8_t>(picture.rgba[i] * 255 + 0.5f));
        ASSERT_TRUE(demos::writePng(at(name), picture.width, picture.height, rgb, error)) << error.text;
    }
    void writeBoth(const std::string& name, const demos::Picture& picture) const {
        write("ref/" + name, picture);
        write("out/" + name, picture);
    }

    const TemporaryFolder folder_;
};

/// All of `words` are in what it says, wherever.
inline void expectSays(const Outcome& outcome, int code, const std::vector<std::string>& words) {
    EXPECT_EQ(outcome.code, code) << outcome.err << outcome.out;
    for (const std::string& word : words)
        EXPECT_NE((outcome.out + outcome.err).find(word), std::string::npos)
            << "'" << word << "' is not in: " << outcome.out << outcome.err;
}

} // namespace tests
