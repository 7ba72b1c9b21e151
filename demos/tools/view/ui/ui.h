// Dear ImGui over the picture: its context, what it hears from the window, and how it is drawn.
#pragma once

#include "view/ui/ui_pass.h"

struct GLFWwindow;

namespace demos {

class Ui {
  public:
    Ui() = default;
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    bool create(Device& device, GLFWwindow* window, VkFormat target, Error& error);
    /// Begins a layout, `seconds` after the last; panels then follow, and end().
    void begin(VkExtent2D extent, double seconds);
    bool end(Error& error);
    void record(VkCommandBuffer commands, const Image& target) const;

    /// Whether a panel has them, as of the last layout.
    bool keysTaken() const;
    bool mouseTaken() const;

  private:
    bool exists_ = false;
    UiPass pass_;
};

} // namespace demos
