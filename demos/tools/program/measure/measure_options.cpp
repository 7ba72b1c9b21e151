#include "program/measure/measure_options.h"

#include <CLI/CLI.hpp>

#include "program/scene_options.h"
#include "scene/random_camera.h"

namespace demos {

namespace {

constexpr Size quickSize = {320, 180};
constexpr uint32_t quickRounds = 5, mostRounds = 1000, mostRandomCameras = 1000;

constexpr const char* measureExamples =
    R"(For each scene, camera and technique: what the reflection costs, in milliseconds and as a multiple of
the floor (a compute copy of the frame's colour and depth, timed between the same frames), and how far the
picture is from the ray-traced one. Writes tradeoff.json, .csv and .md, and index.html with plots and pictures.

  flip, wrong_share, psnr_surface_db   of the tone-mapped picture over the surface that mirrors
  flip_picture, psnr_picture_db      the same over the whole picture; these alone are of --supersample
  psnr_db          of what is mirrored, before Fresnel, where it is seen elsewhere in the picture
  psnr_valid_db    the same where it was found
  coverage         how much of it was found
  position_px_*    how far from the mirrored point the picture was looked up for it, in pixels
  false_sky_hits   of what mirrors the sky: how much was taken for something solid
  false_sky_hits_inside  the same where all pixels around mirror the sky too: not at edges
  sky_on_geometry  of what mirrors something solid: how much was taken for the sky

What cannot be measured is null, such as shares of nothing. Validation, which would be timed as well, is off.

Examples:
  seaglass measure -o out/tradeoff
  seaglass measure demos/scenes/harbour.toml -o out/tradeoff --quick
  seaglass measure demos/scenes/harbour.toml -o out/flat --flat --technique sspr --camera level
  seaglass measure demos/scenes/pool.toml -o out/faults --technique water --random-cameras 8 --spp 16 --rounds 1

Files are written view by view. Exit codes: 0 all is well, 1 the run failed, 2 bad input (nothing was written),
130 interrupted (what was finished is written).)";

} // namespace

void describeMeasure(CLI::App& command, RawMeasure& raw) {
    command.footer(measureExamples);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    command
        .add_option("SCENE", raw.scenes,
                    "Scene files (TOML) with water or a floor; all such of demos/scenes if not given")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_option("-o,--output", raw.folder, "Folder for what is found; it is made if need be")
        ->type_name("DIR");
    command.add_option("--size", raw.size, "Picture size, 1280x720 if not given, 320x180 with --quick")
        ->type_name("WxH");
    command
        .add_option(
            "--spp", raw.samples,
            "Samples a pixel of the reference's colour, 1 (its centre, as the picture is) if not given")
        ->type_name("N");
    command
        .add_option("--supersample", raw.supersample,
                    "Compare pictures that were rendered N times larger each way and averaged, 1 to 4, 1 if "
                    "not given")
        ->type_name("N");
    const auto addCollected = [&](const char* name, std::vector<std::string>& values, const char* about,
                                  const char* type) {
        command.add_option(name, values, about)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
            ->allow_extra_args(false)
            ->type_name(type);
    };
    addCollected("--technique", raw.techniques, "Measure this one, and others given likewise; all if none is",
                 "NAME");
    addCollected("--camera", raw.cameras,
                 "Measure this camera of each scene, and others given likewise; all if none is", "NAME");
    command
        .add_option("--random-cameras", raw.randomCameras,
                    "Measure the views random:1 to random:N of each scene, which nobody chose")
        ->type_name("N");
    addCollected("--set", raw.overrides, "Override a value of the scenes: water.waves.wind_m_s=12",
                 "PATH=VALUE");
    command.add_flag("--flat", raw.flat, "Still the water: no waves, no foam, where mirrors are exact");
    command
        .add_option("--rounds", raw.rounds, "Costs are medians of so many, 20 if not given, 5 with --quick")
        ->type_name("N");
    describeStrict(command, raw.strict);
    command.add_flag("--quick", raw.quick, "Each scene's first camera alone");
    command.add_option("--device", raw.device, "Part of a device's name; the best device if not given")
        ->type_name("NAME");
    command.allow_extras();
}

std::optional<MeasureOptions> checkMeasure(const RawMeasure& raw, Error& error) {
    MeasureOptions options;
    if (raw.folder.empty()) {
        error.text = "no output, expected -o DIR";
        return std::nullopt;
    }
    options.folder = raw.folder;
    options.scenes.assign(raw.scenes.begin(), raw.scenes.end());
    options.techniques = raw.techniques;
    options.cameras = raw.cameras;
    if (!raw.randomCameras.empty()) {
        const std::optional<uint32_t> count =
            parseCount("--random-cameras", raw.randomCameras, mostRandomCameras, error);
        if (!count) return std::nullopt;
        for (uint32_t i = 1; i <= *count; ++i) options.cameras.push_back(randomCameraName(i));
    }
    options.overrides = raw.overrides;
    options.flat = raw.flat;
    options.strict = raw.strict;
    if (raw.quick) {
        options.size = quickSize;
        options.rounds = quickRounds;
        options.firstCameraOnly = options.cameras.empty();
    }
    if (!raw.size.empty()) {
        const std::optional<Size> size = parseSize("--size", raw.size, error);
        if (!size) return std::nullopt;
        options.size = *size;
    }
    if (!raw.rounds.empty()) {
        const std::optional<uint32_t> rounds = parseCount("--rounds", raw.rounds, mostRounds, error);
        if (!rounds) return std::nullopt;
        options.rounds = *rounds;
    }
    if (!raw.samples.empty()) {
        const std::optional<uint32_t> samples = parseCount("--spp", raw.samples, mostSamples, error);
        if (!samples) return std::nullopt;
        options.samples = *samples;
    }
    if (!raw.supersample.empty()) {
        const std::optional<uint32_t> factor = parseSupersample(raw.supersample, options.size, error);
        if (!factor) return std::nullopt;
        options.supersample = *factor;
    }
    options.device = raw.device;
    return options;
}

} // namespace demos
