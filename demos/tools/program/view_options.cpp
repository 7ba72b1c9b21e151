#include "program/view_options.h"

#include <CLI/CLI.hpp>

#include "program/render/aov_names.h"
#include "program/render/output.h"
#include "scene/fields.h"
#include "scene/nearest.h"
#include "view/view_state.h"

namespace demos {

namespace {

constexpr uint32_t mostFrames = 100000;
constexpr const char* referenceName = "reference";

constexpr const char* keysInWindow = R"(In the window:
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
  seaglass view demos/scenes/harbour.toml --split reference --paused
  seaglass view demos/scenes/harbour.toml --no-ui --frames 10 --dt 0.1 --screenshot window.png

Exit codes: 0 all is well, 1 the run failed, 2 bad input, or no display to open a window on.)";

std::span<const std::string_view> techniques() {
    return choicesOf("water.reflection.technique");
}

bool checkSplit(const std::string& half, Error& error) {
    std::vector<std::string_view> names(techniques().begin(), techniques().end());
    names.push_back(referenceName);
    return half.empty() || isOneOf("--split", half, names, error);
}

bool checkReference(const RawView& raw, ViewOptions& options, Error& error) {
    options.splitReference = raw.split == referenceName;
    if (options.splitReference && options.picture.aov != Aov::color) {
        error.text = "--split is 'reference', which shows color alone, expected no --aov beside it";
        return false;
    }
    if (raw.spp.empty()) return true;
    if (!options.splitReference) {
        error.text = "--spp is given without --split reference, expected both";
        return false;
    }
    const std::optional<uint32_t> samples = parseCount("--spp", raw.spp, mostSamples, error);
    options.referenceSamples = samples.value_or(0);
    return samples.has_value();
}

} // namespace

void describeView(CLI::App& command, RawView& raw) {
    command.footer(keysInWindow);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    describeScene(command, raw);
    describeQuality(command, raw);
    describePlain(command, raw);
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
                    "Mirror the right half by another technique: " + oneOf(techniques()) +
                        "; or trace its rays: reference")
        ->type_name("NAME");
    command
        .add_option(
            "--spp", raw.spp,
            "With --split reference: samples a pixel, 64 if not given; with --dt each frame waits for them")
        ->type_name("N");
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
    if (!checkSplit(raw.split, error) || !checkReference(raw, options, error)) return std::nullopt;
    if (!options.splitReference) options.split = raw.split;
    options.picture.lens = !raw.plain && options.picture.aov == Aov::color;
    options.paused = raw.paused;
    options.panel = !raw.noPanel;
    return options;
}

} // namespace demos
