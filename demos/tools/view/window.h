// A window of the desktop: what is pressed in it, and the surface that Vulkan draws to.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "view/fly_camera.h"

struct GLFWwindow;

namespace demos {

/// What was asked for by a key since it was last taken.
struct WindowWishes {
    bool pause = false;       ///< or go on: space
    bool hidePanel = false;   ///< or show it: tab
    bool savePicture = false; ///< F2
    bool saveScene = false;   ///< F3
};

class Window {
  public:
    /// Null with `error` set where there is no display.
    static std::unique_ptr<Window> open(const std::string& title, uint32_t width, uint32_t height,
                                        Error& error);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// What a surface of it needs of the instance; empty with `error` set where there is no Vulkan for it.
    static std::vector<std::string> vulkanExtensions(Error& error);

    /// Hears what happened since it last did.
    void listen();
    /// What of that moves the camera: keys, and the mouse while the right button is held; unless a panel has
    /// taken them.
    FlyInput flyInput(bool keysTaken, bool mouseTaken);
    WindowWishes takeWishes();
    bool shouldClose() const;
    /// Behind its title.
    void say(const std::string& text);
    /// In pixels; 0 while it is minimised.
    uint32_t width() const;
    uint32_t height() const;
    GLFWwindow* handle() const { return window_; }

  private:
    Window(GLFWwindow* window, const std::string& title) : window_(window), title_(title) {}
    static void onKey(GLFWwindow* handle, int key, int scancode, int action, int modifiers);

    GLFWwindow* window_;
    const std::string title_;
    WindowWishes wishes_;
    bool looking_ = false;
    double mouseX_ = 0, mouseY_ = 0; ///< where it was when it last looked
};

} // namespace demos
