#include "program/view_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "program/aov_names.h"
#include "program/output.h"
#include "scene/fields.h"
#include "scene/nearest.h"
#include "view/view_state.h"

namespace demos {

namespace {

constexpr uint32_t mostFrames = 100000;

constexpr const char* footer = R"(In the window:
  W A S D, Q E    fly forwards, left, back, right, down and up; with shift faster
  right button    hold it and move the mouse to look around
  space           pause or go on
  tab             hide or show the panel
  F2, F3          save the picture, the scene
  escape          close

Examples:
  seaglass view demos/scenes/harbour.toml
  seaglass view demos/scenes/ocean.toml --set water.waves.beaufort=8 --camera high
  seaglass view demos/scenes/harbour.toml --split planar
  seaglass view demos/scenes/harbour.toml --no-ui --frames 10 --dt 0.1 --screenshot window.png

Exit codes: 0 all is well, 1 the run failed, 2 bad input, or no display to open a window on.)";

bool checkSplit(const std::string& technique, Error& error) {
    const std::span<const std::string_view> known = choicesOf("water.reflection.technique");
    if (technique.empty() || std::ranges::find(known, technique) != known.end()) return true;
    const std::vector<std::string_view> names(known.begin(), known.end());
    error.text = "--split is '" + technique +
                 "', expected sky, sspr, ssr, hybrid or planar; the nearest is " +
                 std::string(nearest(technique, names));
    return false;
}

} // namespace

void describeView(CLI::App& command, RawView& raw) {
    command.footer(footer);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    describeScene(command, raw);
    command.add_option("--aov", raw.aov, "What to show, as render's; without depth and reflection_source")
        ->type_name("NAME");
    command.add_option("--frames", raw.frames, "Show so many, then close")->type_name("N");
    command.add_option("--dt", raw.step, "Seconds from each frame to the next, whatever the clock says")
        ->type_name("S");
    command
        .add_option("--screenshot", raw.screenshot,
                    "With --frames: PNG of what the window shows at the last of them")
        ->type_name("FILE");
    command
        .add_option("--split", raw.split,
                    "Mirror the right half by another technique: sky sspr ssr hybrid planar")
        ->type_name("NAME");
    command.add_flag("--paused", raw.paused, "Begin with the waves standing still");
    command.add_flag("--no-ui", raw.noPanel, "Begin without the panel");
    describeDevice(command, raw);
    command.allow_extras();
}

std::optional<ViewOptions> checkView(const RawView& raw, Error& error) {
    ViewOptions options;
    if (!checkScene(raw, "seaglass view SCENE.toml", options.picture, error) ||
        !checkDevice(raw, options.picture, error))
        return std::nullopt;
    if (!raw.aov.empty()) {
        const std::optional<Aov> aov = parseAov("--aov", raw.aov, error);
        if (!aov) return std::nullopt;
        if (!isViewable(*aov)) {
            error.text = "--aov is '" + raw.aov + "', which a window does not show, expected seaglass render";
            return std::nullopt;
        }
        options.picture.aov = *aov;
    }
    if (!raw.frames.empty()) {
        const std::optional<uint32_t> frames = parseCount("--frames", raw.frames, mostFrames, error);
        if (!frames) return std::nullopt;
        options.frames = *frames;
        options.endless = false;
    }
    if (!raw.step.empty()) {
        options.stepS = parseNumber("--dt", raw.step, 0, 10, "a number of seconds, 0 to 10", error);
        if (!options.stepS) return std::nullopt;
    }
    if (!raw.screenshot.empty()) {
        if (options.endless) {
            error.text = "--screenshot is given without --frames, expected both";
            return std::nullopt;
        }
        options.screenshot = raw.screenshot;
        if (!checkOutput("--screenshot", options.screenshot, {".png"}, error)) return std::nullopt;
    }
    if (!checkSplit(raw.split, error)) return std::nullopt;
    options.split = raw.split;
    options.paused = raw.paused;
    options.panel = !raw.noPanel;
    return options;
}

} // namespace demos
