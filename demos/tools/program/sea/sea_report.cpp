#include "program/sea/sea_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace demos {

namespace {

using nlohmann::ordered_json;

template<class... Values>
std::string print(const char* format, Values... values) {
    char text[256];
    std::snprintf(text, sizeof(text), format, values...);
    return text;
}

/// Null for what is not there, and for infinity, which JSON has no number for.
ordered_json orNull(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json();
}

ordered_json unlessFlat(double value) {
    return value > 0 ? ordered_json(value) : ordered_json();
}

std::string cell(const std::optional<double>& value) {
    return value ? print("%12.4g", *value) : print("%12s", "-");
}

using Value = std::optional<double>;

std::string row(const char* name, Value first, Value second, Value third, Value fourth) {
    return print("%-24s", name) + cell(first) + cell(second) + cell(third) + cell(fourth) + "\n";
}

std::string head(const char* name, const std::array<const char*, 4>& columns) {
    std::string line = print("%-24s", name);
    for (const char* const column : columns) line += print("%12s", column);
    return line + "\n";
}

std::optional<double> unlessZero(double value) {
    return value > 0 ? std::optional(value) : std::nullopt;
}

std::string distance(double metres) {
    return metres < 1000 ? print("%.4g m", metres) : print("%.4g km", metres / 1000);
}

/// Without what would end a text of gnuplot's.
std::string quoted(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '"' || c == '\\' || c == '\n'; }, ' ');
    return '"' + text + '"';
}

} // namespace

std::string seaTitle(const WavesDesc& waves, const seaglass::SeaDesc& desc) {
    const std::string force =
        waves.beaufort == WavesDesc::noForce ? "" : print("Beaufort %u: ", waves.beaufort);
    const std::string depth = std::isfinite(desc.depth) ? distance(static_cast<double>(desc.depth)) + " deep"
                                                        : std::string("deep water");
    const bool grows =
        desc.spectrum == seaglass::SpectrumModel::jonswap || desc.spectrum == seaglass::SpectrumModel::tma;
    return force + waves.spectrum + print(", %.4g m/s", static_cast<double>(desc.windSpeed)) +
           (grows ? " over " + distance(static_cast<double>(desc.fetch)) : "") + ", " + depth;
}

std::string seaTable(const WavesDesc& waves, const seaglass::SeaDesc& desc, const SeaFigures& figures,
                     const PublishedSea& published) {
    std::string text = seaTitle(waves, desc) +
                       print("; %u seeds of %u samples\n\n", seaSeeds, static_cast<unsigned>(desc.samples));
    text += head("", {"asked", "resolved", "simulated", "published"});
    text += row("significant height, m", figures.hsSpectrumM, figures.hsResolvedM, figures.hsSimulatedM,
                published.hsM);
    text += row("peak period, s", unlessZero(figures.tpS), {}, {}, published.tpS);
    text += row("zero-crossing period, s", unlessZero(figures.tzS), {}, unlessZero(figures.tzSimulatedS),
                published.tzS);
    text += "\n" + head("", {"resolved", "roughness", "total", "Cox-Munk"});
    text += row("slope variance", figures.slopesResolved, figures.slopesRoughness,
                figures.slopesResolved + figures.slopesRoughness, published.slopeVariance);
    text += "\n" + head("", {"", "simulated", "Monahan", "Callaghan"});
    text += row("whitecap cover", {}, figures.whitecaps, published.whitecapsOfMonahan,
                published.whitecapsOfCallaghan);
    text += "\n" + head("cascade", {"tile, m", "longest, m", "shortest", "Hs, m"});
    for (size_t c = 0; c < figures.cascades.size(); ++c) {
        const seaglass::Cascade& cascade = figures.cascades[c];
        constexpr double turn = 6.283185307179586;
        text += row(std::to_string(c).c_str(), cascade.patch,
                    cascade.kMin > 0 ? turn / cascade.kMin : cascade.patch, turn / cascade.kMax,
                    4 * std::sqrt(cascade.variance));
    }
    return text;
}

std::string seaJson(const WavesDesc& waves, const seaglass::SeaDesc& desc, const SeaFigures& figures,
                    const PublishedSea& published) {
    ordered_json json;
    json["spectrum"] = waves.spectrum;
    json["wind_m_s"] = static_cast<double>(desc.windSpeed);
    json["fetch_m"] = static_cast<double>(desc.fetch);
    json["depth_m"] = orNull(static_cast<double>(desc.depth));
    json["hs_spectrum_m"] = figures.hsSpectrumM;
    json["hs_resolved_m"] = figures.hsResolvedM;
    json["resolved_share"] = figures.resolvedShare;
    json["hs_simulated_m"] = figures.hsSimulatedM;
    json["hs_published_m"] = orNull(published.hsM);
    json["tp_s"] = unlessFlat(figures.tpS);
    json["tz_s"] = unlessFlat(figures.tzS);
    json["tz_simulated_s"] = unlessFlat(figures.tzSimulatedS);
    json["slope_variance"] = {{"resolved", figures.slopesResolved},
                              {"roughness", figures.slopesRoughness},
                              {"total", figures.slopesResolved + figures.slopesRoughness},
                              {"cox_munk", published.slopeVariance}};
    json["whitecap"] = {{"simulated", figures.whitecaps},
                        {"monahan", published.whitecapsOfMonahan},
                        {"callaghan", published.whitecapsOfCallaghan}};
    json["cascades"] = ordered_json::array();
    for (const seaglass::Cascade& cascade : figures.cascades) {
        json["cascades"].push_back({{"patch_m", cascade.patch},
                                    {"samples", cascade.samples},
                                    {"k_min", cascade.kMin},
                                    {"k_max", cascade.kMax},
                                    {"variance_m2", cascade.variance}});
    }
    return json.dump(2) + "\n";
}

std::string seaPlotScript(const SeaFigures& figures, const std::string& title, const std::string& svg) {
    double highest = 0;
    for (const SpectrumBin& bin : figures.bins) highest = std::max(highest, bin.asked);
    std::string script = R"(set terminal svg size 720,420 dynamic background "#1b1d1f" font "sans-serif,12"
set encoding utf8
set border 3 lc rgb "#a4abb2"
set grid lc rgb "#33373b" lt 1
set tics nomirror scale 0.5 textcolor rgb "#dcdfe2"
set xlabel "angular frequency, rad/s" textcolor rgb "#dcdfe2"
set ylabel "S, m² s" textcolor rgb "#dcdfe2"
set key textcolor rgb "#dcdfe2"
set logscale xy
set format y "10^{%T}"
)";
    script += "set output " + quoted(svg) + "\nset title " + quoted(title) +
              " noenhanced textcolor rgb \"#dcdfe2\"\n";
    // Seven decades below the peak show all that a surface shows.
    if (highest > 0) script += print("set yrange [%.3g:%.3g]\n", highest * 1e-7, highest * 3);
    script += "# frequency, asked, simulated\n$spectrum << EOD\n";
    for (const SpectrumBin& bin : figures.bins)
        script += print("%.6g %.6g %.6g\n", bin.omega, bin.asked, bin.simulated);
    return script + "EOD\n"
                    "plot $spectrum using 1:2 with lines lw 2 lc rgb \"#6cb2ff\" title \"asked\", \\\n"
                    "  $spectrum using 1:3 with points pt 6 ps 0.7 lc rgb \"#ffb454\" title \"simulated\"\n";
}

} // namespace demos
