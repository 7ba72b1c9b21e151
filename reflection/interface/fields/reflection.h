// The settings of reflection.h as a table: see rows.h.
#pragma once

#include "gpu/interface/fields/rows.h"
#include "seaglass/reflection.h"

namespace seaglass {

inline constexpr Field reflectionFieldRows[] = {
    field<&ReflectionDesc::technique>("technique", reflectionTechniques, "How what is mirrored is found.")
        .byQuality(ReflectionTechnique::sspr, ReflectionTechnique::sspr, ReflectionTechnique::hybrid,
                   ReflectionTechnique::hybrid),
    field<&ReflectionDesc::downscale>("downscale", 1, 8, "",
                                      "Pixels of the view to one of the reflection, each way.")
        .powersOfTwo()
        .byQuality(2, 2, 1, 1),
    field<&ReflectionDesc::height>("height", 8, 16384, "pixel",
                                   "Of the reflection, in the place of downscale; 0: by that.")
        .orZero(),
    field<&ReflectionDesc::coarseKeys>("coarseKeys", "One key for 2 x 2 pixels, a quarter of their memory.")
        .onlyFor(ReflectionTechnique::sspr)
        .byQuality(false, false, false, false),
    field<&ReflectionDesc::edgeFade>(
        "edgeFade", 0, 0.5, "",
        "Share of the picture's height over which borrowed pixels fade at the border."),
    field<&ReflectionDesc::edgeFadeAround>("edgeFadeAround", "They fade at all four borders.")
        .onlyFor(ReflectionTechnique::sspr, ReflectionTechnique::ssr, ReflectionTechnique::hybrid),
    field<&ReflectionDesc::edgeReach>("edgeReach", 0, 1, "",
                                      "How far beyond the border what reaches it is taken to go on, as a "
                                      "share of the picture's height.")
        .onlyFor(ReflectionTechnique::sspr, ReflectionTechnique::ssr, ReflectionTechnique::hybrid),
    field<&ReflectionDesc::undersideLight>(
        "undersideLight", 0, 1, "", "Light of an underside that is not seen, as a share of its top's."),
    field<&ReflectionDesc::overhangSamples>("overhangSamples", 0, 8, "",
                                            "For undersides that end unseen; 0 is free.")
        .onlyFor(ReflectionTechnique::sspr, ReflectionTechnique::hybrid)
        .byQuality(0, 6, 6, 6),
    field<&ReflectionDesc::distortion>("distortion", 0, 1, "",
                                       "Share of the normal's tilt that is followed; 0: a flat mirror."),
    field<&ReflectionDesc::blurLevels>("blurLevels", 0, 6, "",
                                       "Halvings kept for rough surfaces; 0: all are sharp."),
    field<&ReflectionDesc::clearDistance>("clearDistance", 0, 1e6, "m",
                                          "What is no farther from the mirror is not scattered."),
    field<&ReflectionDesc::scatter>("scatter", 0, 1, "",
                                    "How fast reflections widen beyond that: the sine of a cone."),
    field<&ReflectionDesc::skyFadeDistance>("skyFadeDistance", 0, 1e6, "m",
                                            "How far from the mirror the sky has taken over; 0: nowhere."),
    field<&ReflectionDesc::edgeStretch>("edgeStretch", 0, 100, "1/m",
                                        "How far pixels beside the borders take what is farther inside."),
    field<&ReflectionDesc::edgeStretchBand>("edgeStretchBand", 0.01, 0.5, "",
                                            "Share of the picture's width that it moves, at either border."),
    field<&ReflectionDesc::temporal>("temporal", 0, 0.95, "",
                                     "Share of each pixel that is taken from the frame before."),
    field<&ReflectionDesc::marchCells>("marchCells",
                                       "Rays go over cells, then pixel by pixel; else in strides.")
        .onlyFor(ReflectionTechnique::ssr, ReflectionTechnique::hybrid)
        .byQuality(true, true, true, true),
    field<&ReflectionDesc::marchSteps>("marchSteps", 8, 512, "", "Pixels that a ray looks at, at most.")
        .onlyFor(ReflectionTechnique::ssr, ReflectionTechnique::hybrid)
        .byQuality(32, 64, 64, 128),
    field<&ReflectionDesc::marchThickness>("marchThickness", 0.001, 100, "m",
                                           "Depth of things behind what is seen of them, at most.")
        .onlyFor(ReflectionTechnique::ssr, ReflectionTechnique::hybrid),
    field<&ReflectionDesc::marchDistance>("marchDistance", 0.1, 1e6, "m",
                                          "How far along a ray hits are looked for.")
        .onlyFor(ReflectionTechnique::ssr, ReflectionTechnique::hybrid),
    field<&ReflectionDesc::marchJitter>(
        "marchJitter", 0, 1, "", "Share of a stride by which neighbouring rays start apart: noise for bands.")
        .onlyFor(ReflectionTechnique::ssr, ReflectionTechnique::hybrid),
};

inline constexpr FieldTable reflectionFields = fieldTable("ReflectionDesc", reflectionFieldRows);

inline constexpr Field sceneSampleFieldRows[] = {
    field<&SceneSamples::depth>("depth", 1, 16, "", "Of each pixel's depth.").powersOfTwo(),
    field<&SceneSamples::color>("color", 1, 16, "", "Of each pixel's colour.").powersOfTwo(),
};
inline constexpr FieldTable sceneSampleFields = fieldTable("SceneSamples", sceneSampleFieldRows);

inline constexpr Field overlayFieldRows[] = {
    field<&OverlayDesc::kind>("kind", overlayKinds, "What is drawn."),
    field<&OverlayDesc::contourSpacing>("contourSpacing", 0.001, 1e6, "m",
                                        "Heights between the contour lines of the plane."),
};
inline constexpr FieldTable overlayFields = fieldTable("OverlayDesc", overlayFieldRows);

} // namespace seaglass
