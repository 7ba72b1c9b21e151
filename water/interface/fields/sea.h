// The settings of sea.h as tables: see rows.h. No Vulkan.
#pragma once

#include <limits>

#include "gpu/interface/fields/rows.h"
#include "seaglass/sea.h"

namespace seaglass {

inline constexpr Field seaFieldRows[] = {
    field<&SeaDesc::spectrum>("spectrum", spectrumModels, "Model of the wind sea's spectrum."),
    field<&SeaDesc::windSpeed>("windSpeed", 0, 100, "m/s", "At 10 m; 0: no wind sea."),
    field<&SeaDesc::windDirection>("windDirection", -mostFinite, mostFinite, "rad",
                                   "Where it blows towards, from +u to +v."),
    field<&SeaDesc::fetch>("fetch", 1, 1e6, "m", "Open water upwind."),
    field<&SeaDesc::capFetch>("capFetch", "No further than a fully developed sea."),
    field<&SeaDesc::peakEnhancement>("peakEnhancement", 1, 10, "", "JONSWAP's gamma."),
    field<&SeaDesc::depth>("depth", 0, std::numeric_limits<double>::infinity(), "m",
                           "Of the water, for its waves."),
    field<&SeaDesc::spreading>("spreading", spreadingModels, "Model of the wind sea's directions."),
    field<&SeaDesc::spreadingShape>("spreadingShape", 0, 1000, "", "s of cos2s."),
    field<&SeaDesc::swell>("swell", 0, 1, "", "Elongation of the directional spreading."),
    field<&SeaDesc::amplitude>("amplitude", 0, 1, "", "Scale of all heights; 1: as the wind makes them."),
    field<&SeaDesc::choppiness>("choppiness", 0, 10, "",
                                "Scale of the horizontal displacement; 1: the linear theory's."),
    field<&SeaDesc::samples>("samples", 16, 2048, "", "Across each cascade.").powersOfTwo(),
    field<&SeaDesc::cascades>("cascades", 1, maxCascades, "", "Bands of wavelengths."),
    field<&SeaDesc::largestPatch>("largestPatch", 1, 1e5, "m", "Edge of the largest cascade; 0 chooses.")
        .orZero(),
    field<&SeaDesc::warp>("warp", 0, 1, "", "Keeps tiles from showing; 0: they repeat exactly."),
    field<&SeaDesc::loopPeriod>("loopPeriod", 16, 1e6, "s", "After which the sea repeats."),
};
/// Of SeaDesc, but its seed, which may be any.
inline constexpr FieldTable seaFields = fieldTable("SeaDesc", seaFieldRows);

inline constexpr Field spectrumSampleFieldRows[] = {
    field<&SpectrumSample::frequency>("frequency", 0.01, 50, "Hz", "Rising from one to the next."),
    field<&SpectrumSample::density>("density", 0, 1e6, "m^2/Hz", "Of the height's variance."),
};
inline constexpr FieldTable spectrumSampleFields = fieldTable("SpectrumSample", spectrumSampleFieldRows);

inline constexpr Field swellFieldRows[] = {
    field<&SwellDesc::height>("height", 0, 30, "m", "Its own significant wave height; 0: none."),
    field<&SwellDesc::peakPeriod>("peakPeriod", 1, 30, "s", "Of its peak."),
    field<&SwellDesc::direction>("direction", -mostFinite, mostFinite, "rad",
                                 "Where it runs towards, from +u to +v."),
    field<&SwellDesc::bandwidth>("bandwidth", 0.02, 0.25, "",
                                 "Standard deviation of frequency, as a share of the peak's."),
    field<&SwellDesc::spreading>("spreading", 0, 1000, "", "s of cos^2s: greater is straighter."),
};
inline constexpr FieldTable swellFields = fieldTable("SwellDesc", swellFieldRows);

inline constexpr Field shoreFieldRows[] = {
    field<&ShoreDesc::samples>("samples", 2, 1024, "", "Of the bed, along u and v."),
    field<&ShoreDesc::spacing>("spacing", 0.05, 100, "m", "Between them."),
    field<&ShoreDesc::origin>("origin", -1e6, 1e6, "m", "u and v of the first."),
};
/// Of ShoreDesc, but its bed.
inline constexpr FieldTable shoreFields = fieldTable("ShoreDesc", shoreFieldRows);

inline constexpr Field foamFieldRows[] = {
    field<&FoamDesc::bias>("bias", -1, 1, "", "Taken off the compression at which waves break."),
    field<&FoamDesc::decayTime>("decayTime", 0.1, 20, "s", "In which foam fades to 1/e."),
    field<&FoamDesc::albedo>("albedo", 0, 1, "", "Of full foam."),
};
inline constexpr FieldTable foamFields = fieldTable("FoamDesc", foamFieldRows);

} // namespace seaglass
