// What the viewer's panel shows, and what it lets change.
#pragma once

#include <optional>
#include <string>

#include "view/view_state.h"

namespace demos {

/// What the panel shows beside the state.
struct PanelInfo {
    std::string device;
    uint32_t width = 0, height = 0;
    std::optional<double> frameMs;   ///< of late, in the mean; none where time is not the clock's
    std::optional<FrameTimes> costs; ///< as last measured
    std::string reference;           ///< how far it is; empty where none is wanted
    std::string message;             ///< what came of the last wish, or what is wrong
};

/// What the state alone does not do.
struct PanelWishes {
    bool surface = false; ///< the scene's water or floor has changed
    bool light = false;   ///< its sun or sky has
    bool split = false;   ///< the right half has
    bool measure = false;
    bool meter = false;
    bool savePicture = false;
    bool saveScene = false;
};

/// Lays the panel out. Changes the state as it is used; wishes for what that needs once a change is complete.
PanelWishes layOutPanel(ViewState& state, const PanelInfo& info);

/// Of a window of that many pixels: less than a fifth, as long as there is room for words.
float panelWidth(uint32_t width);
/// What a frame takes, in words.
std::string frameText(const PanelInfo& info);

} // namespace demos
