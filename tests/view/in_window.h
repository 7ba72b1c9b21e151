// The viewer in a window of a display of its own, with the sample scene.
#pragma once

#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "demos/tools/view/viewer.h"
#include "tests/program/sample.h"
#include "tests/view/xvfb.h"

namespace tests {

constexpr double stepS = 0.125;

/// The greatest of any channel of any pixel.
inline int difference(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    if (a.size() != b.size()) return 255;
    int most = 0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

class InWindow : public testing::Test {
  protected:
    ~InWindow() override {
        viewer_.reset();
        host_.reset();
        window_.reset();
    }

    void open(const demos::ViewerDesc& viewing = {stepS}) {
        setenv("DISPLAY", xvfb_.display().c_str(), 1);
        writeSample(folder_.path());
        const std::optional<demos::Scene> scene = demos::loadScene(folder_.path() / "scene.toml", {}, error_);
        ASSERT_TRUE(scene) << error_.text;
        window_ = demos::Window::open("test", 96, 64, error_);
        ASSERT_TRUE(window_) << error_.text;
        demos::HostDesc desc{"", true};
        desc.windowExtensions = demos::Window::vulkanExtensions(error_);
        host_ = demos::Host::create(desc, error_);
        ASSERT_TRUE(host_ && host_->load(*scene, error_)) << error_.text;
        demos::ViewState state;
        state.scene = *scene;
        state.camera = scene->cameras.front();
        state.timeS = scene->timeS;
        state.panel = false;
        viewer_ = demos::Viewer::create(*window_, *host_, state, viewing, error_);
        ASSERT_TRUE(viewer_) << error_.text;
        stepOn(1);
    }

    std::vector<uint8_t> shown() {
        uint32_t width = 0, height = 0;
        std::vector<uint8_t> rgb;
        EXPECT_TRUE(viewer_->read(width, height, rgb, error_)) << error_.text;
        return rgb;
    }

    void stepOn(int frames) {
        for (int i = 0; i < frames; ++i) ASSERT_TRUE(viewer_->step(error_)) << error_.text;
    }

    /// Waits until what was sent has come.
    void expectSoon(const std::function<bool()>& come) {
        for (int i = 0; i < 1000 && !come(); ++i) {
            window_->listen();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        EXPECT_TRUE(come());
    }

    TemporaryFolder folder_;
    Xvfb xvfb_;
    demos::Error error_;
    std::unique_ptr<demos::Window> window_;
    std::unique_ptr<demos::Host> host_;
    std::unique_ptr<demos::Viewer> viewer_;
};

} // namespace tests
