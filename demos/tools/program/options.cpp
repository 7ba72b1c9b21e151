#include "program/options.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include <seaglass/version.h>

#include "program/device/device_options.h"
#include "program/render/aov_names.h"
#include "program/render/output.h"
#include "program/scene_options.h"
#include "scene/nearest.h"

namespace demos {

namespace {

constexpr uint32_t mostFrames = 100000;

constexpr std::array<std::pair<std::string_view, Mistake>, 2> mistakes = {{
    {"flipped_y", Mistake::flippedY},
    {"forward_depth", Mistake::forwardDepth},
}};

constexpr const char* examples = R"(Examples:
  seaglass render demos/scenes/harbour.toml -o harbour.png
  seaglass render demos/scenes/ocean.toml -o sea.exr --set water.waves.wind_m_s=16 --camera low
  seaglass render demos/scenes/ocean.toml -o frame%04d.png --frames 240 --fps 24 --quality high
  seaglass render demos/scenes/ocean.toml -o mine.png --sky my_sky.exr --mesh my_boat.glb
  seaglass view demos/scenes/harbour.toml
  seaglass reference demos/scenes/harbour.toml -o truth.exr --spp 64 --truth classes.exr

Exit codes: 0 all is well, 1 the run failed, 2 bad input (nothing was written).)";

/// What the line says, before any of it is checked.
struct Raw : RawScene, RawDevice {
    std::string supersample, frames, fps, aov, mistake, stats, spp, seed, truth, mirrored;
    std::vector<std::string> outputs;
    bool metered = false, untimed = false;
};

/// What render and reference have in common.
void describePicture(CLI::App& command, Raw& raw) {
    command.footer(examples);
    // Scripts append to a command line: the last of an option counts, but for those that collect.
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    describeScene(command, raw);
    describePlain(command, raw);
    command.add_flag(
        "--metered", raw.metered,
        "Expose PNGs as a camera's light meter would, whatever the scene's exposure_ev; also if --set "
        "says sky.clear or sun.elevation_deg, but not exposure_ev");
    command
        .add_option("-o,--output", raw.outputs,
                    "PNG (tone-mapped) or EXR (linear); may be given more than once")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false)
        ->type_name("FILE");
    command.allow_extras();
}

void describeReference(CLI::App& reference, Raw& raw) {
    describePicture(reference, raw);
    reference.add_option("--spp", raw.spp, "Samples a pixel, 1 (its centre) if not given")->type_name("N");
    reference.add_option("--seed", raw.seed, "Of the samples, 1 if not given")->type_name("N");
    reference
        .add_option("--truth", raw.truth,
                    "EXR: class of what is mirrored, its pixel (x, y), its distance from the surface")
        ->type_name("FILE");
    reference
        .add_option("--mirrored", raw.mirrored,
                    "EXR: radiance of what is mirrored, before Fresnel; black where nothing mirrors")
        ->type_name("FILE");
}

std::string versionText() {
    const uint32_t v = seaglass::version();
    return std::to_string(v >> 22u) + "." + std::to_string(v >> 12u & 0x3ffu) + "." +
           std::to_string(v & 0xfffu);
}

void describe(CLI::App& app, CLI::App& render, Raw& raw) {
    app.set_help_flag("-h,--help", "Print this help");
    app.set_version_flag("--version", "seaglass " + versionText());
    app.footer(examples);
    describePicture(render, raw);
    describeQuality(render, raw);
    render
        .add_option("--supersample", raw.supersample,
                    "Render N times larger each way and average, 1 to 4; if not given 2, or 1 with --plain")
        ->type_name("N");
    render
        .add_option("--frames", raw.frames,
                    "Render so many, numbered in place of %04d or before the extension")
        ->type_name("N");
    render.add_option("--fps", raw.fps, "Frames in a second, 30 if not given")->type_name("F");
    render
        .add_option(
            "--aov", raw.aov,
            "What to draw: color reflection class height normal foam depth reflection_source, or how the "
            "library understands the frame: overlay_depth overlay_plane overlay_classes "
            "overlay_confidence overlay_distance")
        ->type_name("NAME");
    render
        .add_option(
            "--mistake", raw.mistake,
            "Tell the library a wrong projection, to know what that looks like: flipped_y forward_depth")
        ->type_name("NAME");
    render.add_option("--stats", raw.stats, "Measure the frame's passes, print them and write them as JSON")
        ->type_name("FILE");
    render.add_flag("--untimed", raw.untimed, "Draw no frame more than once, and say no time");
    describeDevice(render, raw);
    app.allow_extras();
}

bool fail(const std::string& what, Error& error) {
    error.text = what;
    return false;
}

bool checkExtras(const CLI::App& app, const std::vector<std::string>& extras, Error& error) {
    if (extras.empty()) return true;
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    const std::string& extra = extras.front();
    if (extra.starts_with("-") || app.get_parent() == nullptr) {
        const std::vector<std::string_view> known(names.begin(), names.end());
        return fail(extra + " is not known, the nearest is " + std::string(nearest(extra, known)), error);
    }
    return fail("'" + extra + "' is one word too many, expected options (see seaglass " + app.get_name() +
                    " --help)",
                error);
}

/// Whether all that is asked for is to be looked at, and nothing to be measured.
bool isToLookAt(const RenderOptions& options) {
    return options.aov == Aov::color && options.mistake == Mistake::none && options.stats.empty() &&
           std::ranges::all_of(options.outputs, isPng);
}

/// A scene is exposed for its own light, which is not that of another hour.
bool isAnotherHour(const std::vector<std::string>& overrides) {
    return (sets(overrides, "sky.clear") || sets(overrides, "sun.elevation_deg")) &&
           !sets(overrides, "exposure_ev");
}

bool check(const Raw& raw, RenderOptions& out, Error& error) {
    if (!checkScene(raw, "seaglass render SCENE.toml -o OUT.png", out, error)) return false;
    if (raw.outputs.empty()) return fail("no output, expected -o OUT.png or -o OUT.exr", error);
    out.outputs.assign(raw.outputs.begin(), raw.outputs.end());
    if (!raw.supersample.empty()) {
        const std::optional<uint32_t> factor = parseSupersample(raw.supersample, out.size, error);
        if (!factor) return false;
        out.supersample = *factor;
    }
    if (!raw.frames.empty()) {
        const std::optional<uint32_t> frames = parseCount("--frames", raw.frames, mostFrames, error);
        if (!frames) return false;
        out.frames = *frames;
        out.numbered = true;
    }
    if (!raw.fps.empty()) {
        const auto fps = parseNumber("--fps", raw.fps, 1e-3, 1e4, "frames a second, 0.001 to 10000", error);
        if (!fps) return false;
        if (!out.numbered) return fail("--fps is given without --frames, expected both", error);
        out.fps = *fps;
    }
    if (!raw.aov.empty()) {
        const std::optional<Aov> found = parseAov("--aov", raw.aov, error);
        if (!found) return false;
        out.aov = *found;
        if (out.supersample > 1 && out.aov != Aov::color)
            return fail("--supersample is given with --aov " + raw.aov +
                            ", expected color, which can be averaged",
                        error);
    }
    if (!raw.mistake.empty()) {
        const auto* const found =
            std::ranges::find(mistakes, raw.mistake, &std::pair<std::string_view, Mistake>::first);
        if (found == mistakes.end())
            return fail("--mistake is '" + raw.mistake + "', expected flipped_y or forward_depth", error);
        out.mistake = found->second;
    }
    if (raw.untimed && !raw.stats.empty())
        return fail("--untimed and --stats exclude each other, expected one of them", error);
    out.stats = raw.stats;
    out.untimed = raw.untimed;
    out.lens = !raw.plain && isToLookAt(out);
    out.metered = raw.metered || (out.lens && isAnotherHour(out.overrides));
    return checkDevice(raw, out, error);
}

bool check(const Raw& raw, ReferenceOptions& out, Error& error) {
    if (!check(raw, out.picture, error)) return false;
    if (!raw.spp.empty()) {
        const std::optional<uint32_t> samples = parseCount("--spp", raw.spp, mostSamples, error);
        if (!samples) return false;
        out.samples = *samples;
    }
    if (!raw.seed.empty()) {
        const std::optional<uint32_t> seed =
            parseCount("--seed", raw.seed, std::numeric_limits<uint32_t>::max(), error);
        if (!seed) return false;
        out.seed = *seed;
    }
    out.truth = raw.truth;
    out.mirrored = raw.mirrored;
    out.picture.lens = out.picture.lens && out.truth.empty() && out.mirrored.empty();
    return true;
}

/// What the line says of each command.
struct Line {
    Raw raw;
    RawView view;
    RawCompare compare;
    RawBless bless;
    RawGather report;
    RawMeasure measure;
    RawSea sea;
};

struct Commands {
    Commands(CLI::App& program, Line& line)
        : app(program), render(*app.add_subcommand("render", "Render a scene file")),
          view(*app.add_subcommand("view", "Show a scene file in a window")),
          reference(*app.add_subcommand("reference", "Ray-trace a scene file on the CPU")),
          compare(*app.add_subcommand("compare", "Compare two pictures, or folders of them")),
          bless(*app.add_subcommand("bless", "Make new pictures the references")),
          report(*app.add_subcommand("report", "Make one page of several reports of compare")),
          measure(*app.add_subcommand("measure", "Measure cost and error of the techniques side by side")),
          sea(*app.add_subcommand("sea", "Print what a sea is, beside the published tables")),
          devices(*app.add_subcommand("devices", "List the Vulkan devices")) {
        devices.allow_extras();
        describe(app, render, line.raw);
        describeReference(reference, line.raw);
        describeView(view, line.view);
        describeCompare(compare, line.compare);
        describeBless(bless, line.bless);
        describeGather(report, line.report);
        describeMeasure(measure, line.measure);
        describeSea(sea, line.sea);
    }

    bool checkExtras(Error& error) const {
        for (const CLI::App* command :
             {&app, &render, &view, &reference, &compare, &bless, &report, &measure, &sea, &devices})
            if (!demos::checkExtras(*command, command->remaining(), error)) return false;
        return true;
    }

    CLI::App &app, &render, &view, &reference, &compare, &bless, &report, &measure, &sea, &devices;
};

template<class T>
bool take(std::optional<T> checked, T& out) {
    if (checked) out = std::move(*checked);
    return checked.has_value();
}

/// What the command that the line names is given.
bool check(const Commands& commands, const Line& line, Options& out, Error& error) {
    using Command = Options::Command;
    const auto is = [&](const CLI::App& command, Command named) {
        if (command.parsed()) out.command = named;
        return command.parsed();
    };
    if (is(commands.devices, Command::devices)) return true;
    if (is(commands.view, Command::view)) return take(checkView(line.view, error), out.view);
    if (is(commands.reference, Command::reference)) return check(line.raw, out.reference, error);
    if (is(commands.compare, Command::compare)) return take(checkCompare(line.compare, error), out.compare);
    if (is(commands.bless, Command::bless)) return take(checkBless(line.bless, error), out.bless);
    if (is(commands.report, Command::report)) return take(checkGather(line.report, error), out.report);
    if (is(commands.measure, Command::measure)) return take(checkMeasure(line.measure, error), out.measure);
    if (is(commands.sea, Command::sea)) return take(checkSea(line.sea, error), out.sea);
    if (is(commands.render, Command::render)) return check(line.raw, out.render, error);
    return fail(
        "no command, expected seaglass render, view, reference, compare, bless, report, measure, sea or "
        "devices "
        "(see seaglass --help)",
        error);
}

/// An empty word is what a script's unset variable leaves, and would be taken for an option that is not
/// given.
bool holdsEmptyWord(int argc, const char* const* argv, Error& error) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const bool unsaid = word.starts_with("--") && word.ends_with("=");
        if (!word.empty() && !unsaid) continue;
        error.text = (unsaid ? std::string(word) : "the word after " + std::string(argv[i - 1])) +
                     " is empty, expected a value";
        return true;
    }
    return false;
}

} // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv, Error& error) {
    if (holdsEmptyWord(argc, argv, error)) return std::nullopt;
    CLI::App app("Water for Vulkan: renders scene files to pictures, and compares pictures.", "seaglass");
    Line line;
    const Commands commands(app, line);
    Options options;
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        if (problem.get_exit_code() == 0) {
            app.exit(problem);
            return options;
        }
        error.text = problem.what();
        std::replace(error.text.begin(), error.text.end(), '\n', ' ');
        return std::nullopt;
    }
    if (!commands.checkExtras(error) || !check(commands, line, options, error)) return std::nullopt;
    return options;
}

} // namespace demos
