// The viewer in a real window: keys, mouse and sizes come from the display's server, as from a desktop.
#include "host/lens/meter.h"
#include "tests/view/in_window.h"

// Last: X11 defines words that others use.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xutil.h>

// As glfw3native.h has them, which asks for headers of the display's extensions besides.
extern "C" Display* glfwGetX11Display();
extern "C" Window glfwGetX11Window(GLFWwindow*);

namespace {

using tests::difference;
using tests::stepS;

class InWindow : public tests::InWindow {
  protected:
    Display* display() const { return glfwGetX11Display(); }
    ::Window xWindow() const { return glfwGetX11Window(window_->handle()); }

    /// Waits until what was sent has come.
    void expectSoon(const std::function<bool()>& come) {
        tests::InWindow::expectSoon([&] {
            XSync(display(), False);
            window_->listen();
            return come();
        });
    }

    void key(KeySym symbol, bool press) {
        XEvent event{};
        event.xkey.type = press ? KeyPress : KeyRelease;
        event.xkey.display = display();
        event.xkey.window = xWindow();
        event.xkey.root = DefaultRootWindow(display());
        event.xkey.time = ++time_;
        event.xkey.keycode = XKeysymToKeycode(display(), symbol);
        event.xkey.same_screen = True;
        XSendEvent(display(), xWindow(), False, press ? KeyPressMask : KeyReleaseMask, &event);
    }
    void hold(KeySym symbol, int glfwKey) {
        key(symbol, true);
        expectSoon([&] { return glfwGetKey(window_->handle(), glfwKey) == GLFW_PRESS; });
    }
    void release(KeySym symbol, int glfwKey) {
        key(symbol, false);
        expectSoon([&] { return glfwGetKey(window_->handle(), glfwKey) == GLFW_RELEASE; });
    }

    demos::Picture rendered() {
        const demos::ViewState& state = viewer_->state();
        const std::optional<demos::Picture> picture = host_->render(
            {window_->width(), window_->height(), state.camera, state.timeS, state.aov}, error_);
        EXPECT_TRUE(picture) << error_.text;
        return picture.value_or(demos::Picture{});
    }

    Time time_ = 0;
};

TEST_F(InWindow, KeysMoveTheCameraAsComputed) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open());
    demos::CameraDesc expected = viewer_->state().camera;
    EXPECT_EQ(expected.positionM, (demos::Vec3{0, 2, 4}));

    hold(XK_w, GLFW_KEY_W);
    stepOn(3);
    for (int i = 0; i < 3; ++i) demos::fly(expected, {.forward = 1}, stepS);
    EXPECT_EQ(viewer_->state().camera.positionM, expected.positionM);
    EXPECT_LT(expected.positionM[2], 3);

    hold(XK_d, GLFW_KEY_D);
    hold(XK_Shift_L, GLFW_KEY_LEFT_SHIFT);
    stepOn(1);
    demos::fly(expected, {.right = 1, .forward = 1, .fast = true}, stepS);
    EXPECT_EQ(viewer_->state().camera.positionM, expected.positionM);

    release(XK_w, GLFW_KEY_W);
    release(XK_d, GLFW_KEY_D);
    release(XK_Shift_L, GLFW_KEY_LEFT_SHIFT);
    stepOn(2);
    EXPECT_EQ(viewer_->state().camera.positionM, expected.positionM);
    EXPECT_EQ(viewer_->state().camera.targetM, expected.targetM);
    EXPECT_EQ(host_->validationMessages(), 0u);
}

TEST_F(InWindow, TheMouseLooksAroundWhileTheRightButtonIsHeld) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open());
    const demos::CameraDesc before = viewer_->state().camera;
    double x = 0, y = 0, fromX = 0, fromY = 0;
    const auto pointer = [&] { glfwGetCursorPos(window_->handle(), &x, &y); };
    XWarpPointer(display(), None, xWindow(), 0, 0, 0, 0, 40, 30);
    expectSoon([&] {
        pointer();
        return x == 40 && y == 30;
    });
    stepOn(1);
    EXPECT_EQ(viewer_->state().camera.targetM, before.targetM) << "no button is held";
    XEvent event{};
    event.xbutton.type = ButtonPress;
    event.xbutton.display = display();
    event.xbutton.window = xWindow();
    event.xbutton.button = Button3;
    XSendEvent(display(), xWindow(), False, ButtonPressMask, &event);
    expectSoon([&] { return glfwGetMouseButton(window_->handle(), GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS; });
    stepOn(1);
    EXPECT_EQ(viewer_->state().camera.targetM, before.targetM);

    glfwGetCursorPos(window_->handle(), &fromX, &fromY);
    XWarpPointer(display(), None, None, 0, 0, 0, 0, 20, -5);
    expectSoon([&] {
        pointer();
        return x != fromX;
    });
    stepOn(1);
    demos::CameraDesc expected = before;
    demos::fly(expected, {.turnRightPx = x - fromX, .turnDownPx = y - fromY}, stepS);
    EXPECT_EQ(viewer_->state().camera.targetM, expected.targetM);
    EXPECT_EQ(x - fromX, 20);
    EXPECT_EQ(y - fromY, -5);
}

TEST_F(InWindow, SpacePausesTheWaves) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open());
    stepOn(2);
    EXPECT_EQ(viewer_->state().timeS, 1.5 + 2 * stepS);
    key(XK_space, true);
    key(XK_space, false);
    const auto paused = [&] {
        stepOn(1);
        return viewer_->state().paused;
    };
    expectSoon(paused);
    const double stopped = viewer_->state().timeS;
    stepOn(3);
    EXPECT_EQ(viewer_->state().timeS, stopped);
}

TEST_F(InWindow, TheSavedSceneDrawsWhatIsSeen) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open());
    std::filesystem::current_path(folder_.path());
    hold(XK_s, GLFW_KEY_S);
    stepOn(3);
    release(XK_s, GLFW_KEY_S);
    key(XK_F3, true);
    key(XK_F3, false);
    const std::filesystem::path file = folder_.path() / "scene_0001.toml";
    expectSoon([&] {
        if (!std::filesystem::exists(file)) stepOn(1);
        return std::filesystem::exists(file);
    });
    const std::optional<demos::Scene> saved = demos::loadScene(file, {}, error_);
    ASSERT_TRUE(saved) << error_.text;
    EXPECT_EQ(saved->cameras.front().name, "view");
    EXPECT_EQ(saved->cameras.front().positionM, viewer_->state().camera.positionM);
    EXPECT_NE(saved->cameras.front().positionM, saved->cameras[1].positionM) << "it had flown";
    ASSERT_TRUE(host_->load(*saved, error_)) << error_.text;
    const std::optional<demos::Picture> drawn =
        host_->render({96, 64, saved->cameras.front(), saved->timeS}, error_);
    ASSERT_TRUE(drawn) << error_.text;
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> shown;
    ASSERT_TRUE(viewer_->read(width, height, shown, error_)) << error_.text;
    EXPECT_LE(difference(shown, demos::toneMap(*drawn, saved->exposureEv)), 1);
}

TEST_F(InWindow, ThePanelLiesOverThePictureAndTabHidesIt) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open());
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> bare, covered;
    key(XK_space, true);
    key(XK_space, false);
    expectSoon([&] {
        stepOn(1);
        return viewer_->state().paused;
    });
    ASSERT_TRUE(viewer_->read(width, height, bare, error_)) << error_.text;
    key(XK_Tab, true);
    key(XK_Tab, false);
    expectSoon([&] {
        stepOn(2); // it lays itself out in the first
        return viewer_->state().panel;
    });
    ASSERT_TRUE(viewer_->read(width, height, covered, error_)) << error_.text;
    EXPECT_GT(difference(bare, covered), 50);
    EXPECT_EQ(host_->validationMessages(), 0u);
}

TEST_F(InWindow, ChangesShowAndWhatCannotBeLeavesTheScene) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open());
    demos::ViewState state = viewer_->state();
    state.paused = true;
    state.scene.water->waves->beaufort = 7;
    state.scene.water->reflection->technique = seaglass::ReflectionTechnique::planar;
    ASSERT_TRUE(viewer_->change(state, {.surface = true}, error_)) << error_.text;
    stepOn(1);
    const std::vector<uint8_t> stormy = shown();
    state.scene.sun.elevationDeg = 60;
    ASSERT_TRUE(viewer_->change(state, {.light = true}, error_)) << error_.text;
    stepOn(1);
    const std::vector<uint8_t> sunny = shown();
    EXPECT_GT(difference(stormy, sunny), 10);
    state.split = demos::Split{};
    state.split->reflection.technique = seaglass::ReflectionTechnique::sky;
    ASSERT_TRUE(viewer_->change(state, {.split = true, .measure = true}, error_)) << error_.text;
    stepOn(1);
    state.split.reset();
    ASSERT_TRUE(viewer_->change(state, {.split = true}, error_)) << error_.text;
    stepOn(1);
    EXPECT_EQ(shown(), sunny) << "as before the split";

    demos::ViewState wrong = state;
    wrong.scene.water->waves->samples = 48;
    EXPECT_FALSE(viewer_->change(wrong, {.surface = true}, error_));
    EXPECT_NE(error_.text.find("samples"), std::string::npos) << error_.text;
    EXPECT_EQ(viewer_->state().scene.water->waves->samples, 128u);
    stepOn(1);
    EXPECT_EQ(shown(), sunny);

    ASSERT_TRUE(host_->load(state.scene, error_)) << error_.text;
    EXPECT_LE(difference(sunny, demos::toneMap(rendered(), state.scene.exposureEv)), 1) << "as loaded anew";
    ASSERT_TRUE(viewer_->change(state, {.meter = true}, error_)) << error_.text;
    EXPECT_NEAR(viewer_->state().scene.exposureEv, demos::meteredEv(rendered()), 0.1);
    EXPECT_EQ(host_->validationMessages(), 0u);
}

TEST_F(InWindow, TheReferenceComesWhenNothingMovesAndGoesWhenSomethingDoes) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open({std::nullopt, 2}));
    const auto traced = [&] {
        stepOn(1);
        return viewer_->info().reference == "reference: 2 of 2 samples";
    };
    demos::ViewState state = viewer_->state();
    state.paused = true;
    ASSERT_TRUE(viewer_->change(state, {}, error_)) << error_.text;
    stepOn(1);
    const std::vector<uint8_t> drawn = shown();
    state.split = demos::Split{{}, 0, true};
    ASSERT_TRUE(viewer_->change(state, {.split = true}, error_)) << error_.text;
    expectSoon(traced);
    const std::vector<uint8_t> first = shown();
    EXPECT_GT(difference(drawn, first), 10);

    state.camera.positionM[1] += 0.5;
    ASSERT_TRUE(viewer_->change(state, {}, error_)) << error_.text;
    stepOn(1);
    EXPECT_EQ(viewer_->info().reference, "reference: waits until nothing moves (space pauses)");
    EXPECT_LE(difference(shown(), demos::toneMap(rendered(), state.scene.exposureEv)), 1);
    expectSoon(traced);
    EXPECT_GT(difference(shown(), first), 10);
    state.camera.positionM[1] -= 0.5;
    ASSERT_TRUE(viewer_->change(state, {}, error_)) << error_.text;
    expectSoon(traced);
    EXPECT_EQ(shown(), first) << "the same samples";
    char* title = nullptr;
    ASSERT_TRUE(XFetchName(display(), xWindow(), &title) && title);
    EXPECT_NE(std::string(title).find(" ms a frame, "), std::string::npos) << title;
    XFree(title);

    state.scene.water->waves->beaufort = 7;
    ASSERT_TRUE(viewer_->change(state, {.surface = true}, error_)) << error_.text;
    EXPECT_EQ(viewer_->info().reference, "");
    expectSoon(traced);
    EXPECT_GT(difference(shown(), first), 10);
    EXPECT_EQ(host_->validationMessages(), 0u);
}

TEST_F(InWindow, ShowsThePictureAtAnySize) {
    REQUIRE_DISPLAY(xvfb_);
    ASSERT_NO_FATAL_FAILURE(open());
    for (const unsigned width : {96u, 130u, 61u}) {
        XResizeWindow(display(), xWindow(), width, 70);
        expectSoon([&] { return window_->width() == width && window_->height() == 70; });
        stepOn(2);
        uint32_t shownWidth = 0, shownHeight = 0;
        std::vector<uint8_t> shown;
        ASSERT_TRUE(viewer_->read(shownWidth, shownHeight, shown, error_)) << error_.text;
        ASSERT_EQ(shownWidth, width);
        ASSERT_EQ(shownHeight, 70u);

        const auto onDisplay = [&] {
            XImage* const image = XGetImage(display(), xWindow(), 0, 0, width, 70, AllPlanes, ZPixmap);
            std::vector<uint8_t> rgb;
            for (int y = 0; y < 70; ++y) {
                for (int x = 0; x < static_cast<int>(width); ++x) {
                    const unsigned long pixel = XGetPixel(image, x, y);
                    for (const int shift : {16, 8, 0}) rgb.push_back(static_cast<uint8_t>(pixel >> shift));
                }
            }
            XDestroyImage(image);
            return rgb;
        };
        expectSoon([&] { return onDisplay() == shown; });

        const std::vector<uint8_t> expected = demos::toneMap(rendered(), viewer_->state().scene.exposureEv);
        EXPECT_LE(difference(shown, expected), 1) << "at " << width << " columns";
    }
    EXPECT_EQ(host_->validationMessages(), 0u);
}

} // namespace
