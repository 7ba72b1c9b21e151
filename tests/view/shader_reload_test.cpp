// Shaders that change while the viewer draws with them: a copy of the library's.
#include <fstream>
#include <iterator>

#include "scene/fields.h"
#include "tests/view/in_window.h"

namespace {

namespace fs = std::filesystem;

class ShaderReload : public tests::InWindow {
  protected:
    void openOver(const std::string& technique = "sspr") {
        fs::copy(SEAGLASS_SHADER_FOLDER, shaders(), fs::copy_options::recursive);
        ASSERT_NO_FATAL_FAILURE(open({tests::stepS, 1, shaders()}));
        demos::ViewState state = viewer_->state();
        state.paused = true;
        state.scene.water->reflection->technique = demos::techniqueNamed(technique);
        ASSERT_TRUE(viewer_->change(state, {.surface = true}, error_)) << error_.text;
        stepOn(1);
    }
    fs::path shaders() const { return folder_.path() / "shaders"; }
    std::string read(const fs::path& name) const {
        std::ifstream in(shaders() / name);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const fs::path& name, const std::string& text) {
        tests::writeAll(shaders() / name, text);
        // Two writes within a tick of the file system's clock would be one.
        stamp_ += std::chrono::seconds(1);
        fs::last_write_time(shaders() / name, stamp_);
    }
    /// With a text in the place of another, which is there once.
    void edit(const fs::path& name, const std::string& from, const std::string& to) {
        std::string text = read(name);
        const size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        ASSERT_EQ(text.find(from, at + 1), std::string::npos) << from;
        write(name, text.replace(at, from.size(), to));
    }
    /// Share of the pixels that are red and nothing else.
    double redShare() {
        const std::vector<uint8_t> rgb = shown();
        size_t red = 0;
        for (size_t i = 0; i < rgb.size(); i += 3) red += rgb[i] > 150 && rgb[i + 1] < 50 && rgb[i + 2] < 50;
        return 3.0 * static_cast<double>(red) / static_cast<double>(rgb.size());
    }
    const std::string& message() const { return viewer_->info().message; }
    void expectMessage(const std::string& text) {
        EXPECT_NE(message().find(text), std::string::npos) << message();
    }

  private:
    fs::file_time_type stamp_ = fs::file_time_type::clock::now();
};

const char* const kernel = "water/shading/shaded_surface.comp";
const std::string shaded = "    vec4 made = shaded(s);";
const std::string red = "    vec4 made = vec4(1.0, 0.0, 0.0, 1.0);";

TEST_F(ShaderReload, DrawsWhatTheShaderSaysNow) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(openOver());
    const std::vector<uint8_t> before = shown();
    EXPECT_EQ(redShare(), 0);
    const std::string text = read(kernel);
    ASSERT_NO_FATAL_FAILURE(edit(kernel, shaded, red));
    stepOn(1);
    EXPECT_EQ(message(), "shaders reloaded");
    EXPECT_GT(redShare(), 0.2);

    write(kernel, text);
    stepOn(1);
    EXPECT_EQ(shown(), before);
    EXPECT_EQ(host_->validationMessages(), 0u);
}

TEST_F(ShaderReload, BrokenItLeavesThePictureAndNamesTheLine) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(openOver());
    ASSERT_NO_FATAL_FAILURE(edit(kernel, shaded, red));
    stepOn(1);
    const std::vector<uint8_t> before = shown();
    const std::string good = read(kernel);
    const size_t at = good.find(red);
    const auto line = 1 + std::count(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    ASSERT_NO_FATAL_FAILURE(edit(kernel, red, "    vec4 made = nothing;"));
    testing::internal::CaptureStderr();
    stepOn(1);
    const std::string said = testing::internal::GetCapturedStderr();
    const std::string place = "shaded_surface.comp:" + std::to_string(line) + ": 'nothing'";
    expectMessage(place);
    EXPECT_NE(said.find(place), std::string::npos) << said;
    EXPECT_EQ(shown(), before);
    stepOn(2);
    EXPECT_EQ(shown(), before);

    write(kernel, good);
    stepOn(1);
    EXPECT_EQ(message(), "shaders reloaded");
    EXPECT_EQ(shown(), before);
}

TEST_F(ShaderReload, FollowsWhatShadersInclude) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(openOver());
    const std::vector<uint8_t> before = shown();
    const std::string text = read("gpu/optics.glsl");
    write("gpu/optics.glsl", text + "\nbroken\n");
    stepOn(1);
    expectMessage("optics.glsl:");
    EXPECT_EQ(shown(), before);
    write("gpu/optics.glsl", text);
    stepOn(1);
    EXPECT_EQ(message(), "shaders reloaded");
    EXPECT_EQ(shown(), before);
}

TEST_F(ShaderReload, BrokenShadersThatNothingDrawsWithWaitUntilSomethingDoes) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(openOver("sky"));
    const std::string text = read("scatter.comp");
    write("scatter.comp", text + "\nbroken\n");
    stepOn(1);
    EXPECT_EQ(message(), "shaders reloaded");
    demos::ViewState state = viewer_->state();
    state.scene.water->reflection->technique = seaglass::ReflectionTechnique::sspr;
    ASSERT_TRUE(viewer_->change(state, {.surface = true}, error_)) << error_.text;
    stepOn(2);
    expectMessage("scatter.comp:");
    write("scatter.comp", text);
    stepOn(1);
    EXPECT_EQ(message(), "shaders reloaded");
}

} // namespace
