// The settings of water.h as tables: see rows.h.
#pragma once

#include "gpu/interface/fields/rows.h"
#include "seaglass/water.h"

namespace seaglass {

inline constexpr Field meshFieldRows[] = {
    field<&MeshDesc::cellSize>("cellSize", 0.01, 100, "m", "Edge of the finest cells."),
    field<&MeshDesc::cellsPerLevel>("cellsPerLevel", 128, 1024, "",
                                    "Cells until a twice coarser level takes over.")
        .byQuality(128, 128, 192, 256),
};
inline constexpr FieldTable meshFields = fieldTable("MeshDesc", meshFieldRows);

inline constexpr Field shadingFieldRows[] = {
    field<&ShadingDesc::reflectionSamples>("reflectionSamples", 1, 4, "", "At what a pixel's slopes mirror.")
        .powersOfTwo()
        .byQuality(1, 2, 2, 4),
    field<&ShadingDesc::refractionSamples>(
        "refractionSamples", 1, 16, "",
        "For where the bent ray ends; 1: straight through. From 4 on, light "
        "through crests is taken at several points.")
        .byQuality(2, 3, 6, 8),
    field<&ShadingDesc::bedDownscale>("bedDownscale", 1, 8, "",
                                      "Pixels of the view to one of the bed's picture, each way.")
        .byQuality(4, 4, 1, 1),
    field<&ShadingDesc::causticStep>("causticStep", 1, 8, "pixel",
                                     "From one ray of the sun to the next, each way.")
        .byQuality(4, 2, 1, 1),
    field<&ShadingDesc::slopeSamples>("slopeSamples", 1, 4, "",
                                      "Along a pixel's longer side, at its waves, foam and the sun's shadow.")
        .powersOfTwo()
        .byQuality(1, 1, 2, 4),
    field<&ShadingDesc::waveShadowSteps>("waveShadowSteps", 2, 32, "",
                                         "Looks for the waves that hide low sky and sun; 0: a mean.")
        .orZero()
        .byQuality(0, 0, 8, 16),
    field<&ShadingDesc::sprayParticles>("sprayParticles", 1024, 262144, "", "Of spray in a view, at most.")
        .byQuality(32768, 65536, 131072, 262144),
    field<&ShadingDesc::parallax>("parallax",
                                  "Shades waves shorter than the mesh's cells at their own height.")
        .byQuality(false, false, true, true),
    field<&ShadingDesc::glitter>(
        "glitter", 0, 0.95, "",
        "Share of the slopes within a pixel by which single facets flash; 0: a mean."),
    field<&ShadingDesc::gusts>(
        "gusts", 0, 1, "", "Of cat's paws, patches that gusts roughen and that run with the wind; 0: none."),
    field<&ShadingDesc::fresnel>("fresnel", fresnels, "What share of light is mirrored."),
    field<&ShadingDesc::pixelsPerShading>(
        "pixelsPerShading", 1, 4, "",
        "Of the surface to one that is shaded; others are as those beside them are.")
        .powersOfTwo()
        .byQuality(4, 2, 1, 1),
};
inline constexpr FieldTable shadingFields = fieldTable("ShadingDesc", shadingFieldRows);

inline constexpr Field refractionFieldRows[] = {
    field<&RefractionDesc::absorption>("absorption", 0, 100, "1/m", "Red, green, blue."),
    field<&RefractionDesc::backscatter>("backscatter", 0, 100, "1/m", "Red, green, blue."),
    field<&RefractionDesc::distortion>("distortion", 0, 1, "", "0: straight through, 1: bent as Snell says."),
    field<&RefractionDesc::scattering>("scattering", 0, 100, "1/m",
                                       "By particles: light through crests; 0: none."),
};
inline constexpr FieldTable refractionFields = fieldTable("RefractionDesc", refractionFieldRows);

inline constexpr Field underwaterFieldRows[] = {
    field<&UnderwaterDesc::meniscus>("meniscus", 0, 0.1, "m", "Width of the waterline; 0: none."),
    field<&UnderwaterDesc::shafts>("shafts", 0, 1, "", "Of sunlight; 1: as the waves gather it, 0: none."),
    field<&UnderwaterDesc::snow>("snow", 0, 1, "", "Share of all particles that may drift there; 0: none."),
};
inline constexpr FieldTable underwaterFields = fieldTable("UnderwaterDesc", underwaterFieldRows);

inline constexpr Field causticsFieldRows[] = {
    field<&CausticsDesc::strength>("strength", 0, 1, "", "Of their contrast; 1: as the waves say."),
};
inline constexpr FieldTable causticsFields = fieldTable("CausticsDesc", causticsFieldRows);

inline constexpr Field sprayFieldRows[] = {
    field<&SprayDesc::density>("density", 0, 4, "", "Of its optical depth; 1: by the wind."),
    field<&SprayDesc::shutterTime>("shutterTime", 0, 0.1, "s", "Along which drops streak."),
};
inline constexpr FieldTable sprayFields = fieldTable("SprayDesc", sprayFieldRows);

inline constexpr Field bedFieldRows[] = {
    field<&BedDesc::margin>("margin", 0, 1, "",
                            "By which its picture is larger on each side, as a share of the view's size."),
};
inline constexpr FieldTable bedFields = fieldTable("BedDesc", bedFieldRows);

inline constexpr Field extentFieldRows[] = {
    field<&ExtentDesc::shape>("shape", extentShapes, "What it covers of its plane."),
    field<&ExtentDesc::planetRadius>("planetRadius", 1e6, 1e9, "m", "Of the ball that it is; 0: flat.")
        .orZero()
        .onlyFor(ExtentShape::unbounded),
    field<&ExtentDesc::center>("center", -mostFinite, mostFinite, "m", "u and v of its middle.")
        .onlyFor(ExtentShape::rectangle),
    field<&ExtentDesc::size>("size", 0.01, 1e6, "m", "Along its own u and v.")
        .onlyFor(ExtentShape::rectangle),
    field<&ExtentDesc::yaw>("yaw", -mostFinite, mostFinite, "rad", "Of its own u, from +u towards +v.")
        .onlyFor(ExtentShape::rectangle),
};
/// Of ExtentDesc, but its points and triangles.
inline constexpr FieldTable extentFields = fieldTable("ExtentDesc", extentFieldRows);

inline constexpr Field bodyFieldRows[] = {
    field<&BodyDesc::wavesOn>("wavesOn", wavesOn, "Where its waves are computed."),
    field<&BodyDesc::motion>("motion", "Keeps the last waves for SurfaceOutput::motion."),
};
inline constexpr FieldTable bodyFields = fieldTable("BodyDesc", bodyFieldRows);

inline constexpr Field targetFieldRows[] = {
    field<&TargetDesc::samples>("samples", 1, 64, "", "Of each pixel.").powersOfTwo(),
    field<&TargetDesc::reversedDepth>("reversedDepth", "Nearer is greater."),
    field<&TargetDesc::depthWrite>("depthWrite", "The surface's depth is written."),
    field<&TargetDesc::viewMask>("viewMask", 0, 255, "", "Views of a multiview pass."),
    field<&TargetDesc::encoding>("encoding", encodings, "How colour is written."),
};
inline constexpr FieldTable targetFields = fieldTable("TargetDesc", targetFieldRows);

} // namespace seaglass
