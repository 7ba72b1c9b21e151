// The figures of a sea as a table, as JSON, and as a plot of its spectrum.
#pragma once

#include <optional>
#include <string>

#include "program/sea/sea_figures.h"

namespace demos {

/// What was published for such a sea; null where nothing was.
struct PublishedSea {
    std::optional<double> hsM, tpS, tzS;
    double slopeVariance = 0; ///< Cox and Munk 1954
    double whitecapsOfMonahan = 0;
    double whitecapsOfCallaghan = 0;
};

PublishedSea publishedFor(const seaglass::SeaDesc& desc, const WavesDesc& waves);

std::string seaTable(const WavesDesc& waves, const seaglass::SeaDesc& desc, const SeaFigures& figures,
                     const PublishedSea& published);
std::string seaJson(const WavesDesc& waves, const seaglass::SeaDesc& desc, const SeaFigures& figures,
                    const PublishedSea& published);

/// A script by which gnuplot draws the spectrum into `svg`.
std::string seaPlotScript(const SeaFigures& figures, const std::string& title, const std::string& svg);

/// "jonswap, 10 m/s over 100 km, deep water".
std::string seaTitle(const WavesDesc& waves, const seaglass::SeaDesc& desc);

} // namespace demos
