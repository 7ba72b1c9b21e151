#include "view/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace demos {

namespace {

/// What GLFW last said, in one line.
std::string glfwSaid() {
    const char* what = nullptr;
    glfwGetError(&what);
    return what ? what : "unknown reason";
}

} // namespace

std::unique_ptr<Window> Window::open(const std::string& title, uint32_t width, uint32_t height,
                                     Error& error) {
    const auto fail = [&error](const char* what) {
        error.text = what;
        error.text.append(": ").append(glfwSaid());
        error.text +=
            "; expected a display, such as X11's $DISPLAY names (seaglass render draws without one)";
        return nullptr;
    };
    if (!glfwInit()) return fail("no window can be opened");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWwindow* const handle =
        glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
    if (!handle) {
        fail("no window can be opened");
        glfwTerminate();
        return nullptr;
    }
    std::unique_ptr<Window> window(new Window(handle, title));
    glfwSetWindowUserPointer(handle, window.get());
    glfwSetKeyCallback(handle, onKey);
    return window;
}

void Window::say(const std::string& text) {
    glfwSetWindowTitle(window_, (title_ + ", " + text).c_str());
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

std::vector<std::string> Window::vulkanExtensions(Error& error) {
    uint32_t count = 0;
    const char** const names = glfwGetRequiredInstanceExtensions(&count);
    if (names) return {names, names + count};
    error.text = "no Vulkan for windows: " + glfwSaid();
    return {};
}

void Window::onKey(GLFWwindow* handle, int key, int, int action, int) {
    if (action != GLFW_PRESS) return;
    WindowWishes& wishes = static_cast<Window*>(glfwGetWindowUserPointer(handle))->wishes_;
    if (key == GLFW_KEY_SPACE) wishes.pause = !wishes.pause;
    if (key == GLFW_KEY_TAB) wishes.hidePanel = !wishes.hidePanel;
    if (key == GLFW_KEY_F2) wishes.savePicture = true;
    if (key == GLFW_KEY_F3) wishes.saveScene = true;
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(handle, GLFW_TRUE);
}

void Window::listen() {
    glfwPollEvents();
}

FlyInput Window::flyInput(bool keysTaken, bool mouseTaken) {
    FlyInput input;
    const auto held = [&](int key) { return !keysTaken && glfwGetKey(window_, key) == GLFW_PRESS; };
    const auto axis = [&](int more, int less) { return double(held(more)) - double(held(less)); };
    input.right = axis(GLFW_KEY_D, GLFW_KEY_A);
    input.up = axis(GLFW_KEY_E, GLFW_KEY_Q);
    input.forward = axis(GLFW_KEY_W, GLFW_KEY_S);
    input.fast = held(GLFW_KEY_LEFT_SHIFT) || held(GLFW_KEY_RIGHT_SHIFT);

    const bool looking =
        glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS && (looking_ || !mouseTaken);
    // Disabled, the cursor is hidden and never meets the screen's edge.
    if (looking != looking_)
        glfwSetInputMode(window_, GLFW_CURSOR, looking ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    double x = 0, y = 0;
    glfwGetCursorPos(window_, &x, &y);
    if (looking && looking_) {
        input.turnRightPx = x - mouseX_;
        input.turnDownPx = y - mouseY_;
    }
    looking_ = looking;
    mouseX_ = x;
    mouseY_ = y;
    return input;
}

WindowWishes Window::takeWishes() {
    return std::exchange(wishes_, {});
}

bool Window::shouldClose() const {
    return glfwWindowShouldClose(window_);
}

uint32_t Window::width() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return static_cast<uint32_t>(width);
}

uint32_t Window::height() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return static_cast<uint32_t>(height);
}

} // namespace demos
