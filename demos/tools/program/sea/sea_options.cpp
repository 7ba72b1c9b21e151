#include "program/sea/sea_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "program/render/output.h"
#include "scene/fields.h"
#include "scene/nearest.h"
#include "scene/parse_all.h"
#include "scene/reading/input_file.h"
#include "scene/settings.h"

namespace demos {

namespace {

constexpr const char* footer =
    R"(Simulates the sea 16 times, with as many seeds, and prints what its surface has beside what the spectrum
asks for and what was published: significant wave height, periods, slope variance, cover of whitecaps.

  seaglass sea --wind 10 --fetch 100e3
  seaglass sea --wind 15 --fetch 300e3 --uncapped --spectrum tma --depth 10 --json
  seaglass sea --beaufort 8 -o spectrum.svg

Exit codes: 0 all is well, 1 the run failed, 2 bad input (nothing was written).)";

bool fail(const std::string& what, Error& error) {
    error.text = what;
    return false;
}

bool choose(const std::string& option, const std::string& text, std::string_view path, std::string& out,
            Error& error) {
    if (text.empty()) return true;
    if (!isOneOf(option, text, choicesOf(path), error)) return false;
    out = text;
    return true;
}

/// What the library's table says of a field of the scene's waves, or where it has none the scene itself.
Field waveField(std::string_view key) {
    const Field& field = *std::ranges::find(sectionOf("water.waves").fields, key, &Field::key);
    return field.row ? described(*field.table, *field.row, key, nullptr) : field;
}

bool holds(const Field& field, double value) {
    return field.row ? seaglass::isInRange(*field.row, value) : field.least <= value && value <= field.most;
}

template<class Value>
bool take(const char* option, const std::string& text, std::string_view key, Value& value, Error& error) {
    if (text.empty()) return true;
    const Field field = waveField(key);
    const std::optional<Value> read = parseAll<Value>(text);
    if (!read || !holds(field, static_cast<double>(*read)))
        return fail(std::string(option) + " is '" + text + "', expected " + expectation(field, &value),
                    error);
    value = *read;
    return true;
}

bool checkWind(const RawSea& raw, WavesDesc& waves, Error& error) {
    if (raw.beaufort.empty()) {
        if (raw.wind.empty()) return fail("no wind, expected --wind U [m/s] or --beaufort B", error);
        return take("--wind", raw.wind, "wind_m_s", waves.windMps, error) &&
               take("--fetch", raw.fetch, "fetch_m", waves.fetchM, error);
    }
    for (const auto& [option, text] : {std::pair{"--wind", &raw.wind}, {"--fetch", &raw.fetch}})
        if (!text->empty())
            return fail(std::string(option) + " is given with --beaufort, which sets it, expected one",
                        error);
    return take("--beaufort", raw.beaufort, "beaufort", waves.beaufort, error);
}

bool checkSpectrum(const RawSea& raw, WavesDesc& waves, Error& error) {
    if (!choose("--spectrum", raw.spectrum, "water.waves.spectrum", waves.spectrum, error)) return false;
    const bool tabulated = waves.spectrum == "table";
    if (tabulated && raw.table.empty())
        return fail("--spectrum is table, expected --table FILE.csv too", error);
    if (!tabulated && !raw.table.empty())
        return fail("--table is given without --spectrum table, expected both", error);
    waves.spectrumTable = raw.table;
    const std::string why = tabulated ? unreadable(waves.spectrumTable) : "";
    return why.empty() || fail("--table " + raw.table + ": " + why + ", expected a CSV of Hz,m^2/Hz", error);
}

bool checkSpreading(const RawSea& raw, WavesDesc& waves, Error& error) {
    return choose("--spreading", raw.spreading, "water.waves.spreading", waves.spreading, error) &&
           take("--shape", raw.shape, "spreading_shape", waves.spreadingShape, error) &&
           take("--swell", raw.swell, "swell", waves.swell, error);
}

bool checkSamples(const RawSea& raw, WavesDesc& waves, Error& error) {
    return take("--samples", raw.samples, "samples", waves.samples, error) &&
           take("--cascades", raw.cascades, "cascades", waves.cascades, error) &&
           take("--patch", raw.patch, "largest_patch_m", waves.largestPatchM, error) &&
           take("--seed", raw.seed, "seed", waves.seed, error);
}

} // namespace

void describeSea(CLI::App& command, RawSea& raw) {
    command.footer(footer);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    command.add_option("--wind", raw.wind, "Wind speed at 10 m")->type_name("M/S");
    command.add_option("--fetch", raw.fetch, "Open water upwind, 300e3 m if not given")->type_name("M");
    command.add_option("--beaufort", raw.beaufort, "A force, 0 to 12, in place of wind and fetch")
        ->type_name("B");
    command.add_flag("--uncapped", raw.uncapped,
                     "Let JONSWAP and TMA grow with the fetch past a fully developed sea");
    command.add_option("--depth", raw.depth, "Of the water, inf if not given")->type_name("M");
    const WavesDesc unsaid;
    const auto choices = [](std::string_view path, const std::string& usual) {
        return oneOf(choicesOf(path)) + "; " + usual + " if not given";
    };
    command.add_option("--spectrum", raw.spectrum, choices("water.waves.spectrum", unsaid.spectrum))
        ->type_name("NAME");
    command.add_option("--table", raw.table, "Of --spectrum table: CSV of Hz,m^2/Hz")->type_name("FILE");
    command.add_option("--spreading", raw.spreading, choices("water.waves.spreading", unsaid.spreading))
        ->type_name("NAME");
    command.add_option("--shape", raw.shape, "s of --spreading cos2s, 5 if not given")->type_name("S");
    command.add_option("--swell", raw.swell, "Elongation of the spreading, 0 to 1, 0 if not given")
        ->type_name("XI");
    command.add_option("--samples", raw.samples, "Across each cascade, 256 if not given")->type_name("N");
    command.add_option("--cascades", raw.cascades, "1 to 4, 4 if not given")->type_name("N");
    command.add_option("--patch", raw.patch, "Edge of the largest cascade, chosen if not given")
        ->type_name("M");
    command.add_option("--seed", raw.seed, "The first of the 16, 1 if not given")->type_name("N");
    command.add_flag("--json", raw.json, "Print JSON instead of a table");
    command
        .add_option("-o,--output", raw.plot,
                    "SVG: the spectrum asked for and simulated; its gnuplot script is left beside it")
        ->type_name("FILE");
    command.allow_extras();
}

std::optional<SeaOptions> checkSea(const RawSea& raw, Error& error) {
    SeaOptions options;
    options.waves.cascades = 4;
    options.waves.capFetch = !raw.uncapped;
    if (!checkWind(raw, options.waves, error) ||
        !take("--depth", raw.depth, "depth_m", options.waves.depthM, error) ||
        !checkSpectrum(raw, options.waves, error) || !checkSpreading(raw, options.waves, error) ||
        !checkSamples(raw, options.waves, error))
        return std::nullopt;
    options.json = raw.json;
    options.plot = raw.plot;
    if (!raw.plot.empty() && !checkOutput("-o", options.plot, {".svg"}, error)) return std::nullopt;
    return options;
}

} // namespace demos
