// What the panel lays out, without a window: controls of everything that a scene's water and light have.
#include "view/ui/panel.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <imgui.h>

#include "view/field_widgets.h"

namespace {

using namespace demos;

class Panel : public testing::Test {
  protected:
    Panel() : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        WaterDesc& water = state_.scene.water.emplace();
        water.waves.emplace().swells.resize(2);
        water.foam.emplace();
        water.refraction.emplace();
        water.reflection.emplace();
        water.bed.emplace();
        water.caustics.emplace();
        state_.scene.fog.emplace();
    }
    ~Panel() override { ImGui::DestroyContext(context_); }

    /// How far to the right anything of it reaches [pixel].
    float layOut(uint32_t width, uint32_t height) {
        ImGui::GetIO().DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
        PanelInfo info;
        info.width = width;
        info.height = height;
        for (int i = 0; i < 3; ++i) {
            ImGui::NewFrame();
            layOutPanel(state_, info);
            ImGui::Render();
        }
        float right = 0;
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int i = 0; i < drawn.CmdListsCount; ++i)
            for (const ImDrawCmd& command : drawn.CmdLists[i]->CmdBuffer)
                if (command.ElemCount > 0 && command.ClipRect.z < static_cast<float>(width))
                    right = std::max(right, command.ClipRect.z);
        return right;
    }

    ImGuiContext* context_;
    ViewState state_;
};

TEST_F(Panel, IsNarrowerThanAFifth) {
    for (const auto& [width, height] : {std::pair(1280u, 720u), {1920u, 1080u}, {2560u, 1440u}}) {
        const float right = layOut(width, height);
        EXPECT_GT(right, 100.0f);
        EXPECT_LT(panelWidth(width), 0.2f * static_cast<float>(width));
        EXPECT_LE(right, panelWidth(1280) + 8) << "a window keeps its own";
    }
}

TEST(PanelWords, SayWhatAFrameTakes) {
    PanelInfo info;
    EXPECT_EQ(frameText(info), "a frame a step") << "steps are no clock's";
    info.frameMs = 16.6;
    EXPECT_EQ(frameText(info), "16.6 ms a frame, 60 a second");
}

const Field& fieldOf(const char* section, std::string_view key) {
    return *std::ranges::find(sectionOf(section).fields, key, &Field::key);
}

TEST(PanelLabels, AreWordsWithoutUnits) {
    EXPECT_EQ(labelOf(fieldOf("water.waves", "wind_m_s")), "wind");
    EXPECT_EQ(labelOf(fieldOf("water.waves", "wind_towards_deg")), "wind towards");
    EXPECT_EQ(labelOf(fieldOf("water.foam", "decay_s")), "decay");
    EXPECT_EQ(labelOf(fieldOf("water.refraction", "scattering_per_m")), "scattering");
    EXPECT_EQ(labelOf(fieldOf("water.caustics", "step_px")), "step");
    EXPECT_EQ(labelOf(fieldOf("water.waves", "peak_enhancement")), "peak enhancement");
}

} // namespace
