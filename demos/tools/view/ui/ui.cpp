#include "view/ui/ui.h"

#include <algorithm>

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

namespace demos {

Ui::~Ui() {
    if (!exists_) return;
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

bool Ui::create(Device& device, GLFWwindow* window, VkFormat target, Error& error) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // nothing is left behind where the program runs
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOther(window, true);
    exists_ = true;
    return pass_.create(device, target, error);
}

void Ui::begin(VkExtent2D extent, double seconds) {
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(extent.width), static_cast<float>(extent.height)};
    // Its own is the clock's; ImGui wants some time to pass.
    io.DeltaTime = static_cast<float>(std::max(seconds, 1e-3));
    ImGui::NewFrame();
}

bool Ui::end(Error& error) {
    ImGui::Render();
    return pass_.upload(*ImGui::GetDrawData(), error);
}

void Ui::record(VkCommandBuffer commands, const Image& target) const {
    pass_.record(commands, *ImGui::GetDrawData(), target);
}

bool Ui::keysTaken() const {
    return ImGui::GetIO().WantCaptureKeyboard;
}

bool Ui::mouseTaken() const {
    return ImGui::GetIO().WantCaptureMouse;
}

} // namespace demos
