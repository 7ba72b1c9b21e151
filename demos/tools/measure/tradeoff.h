// Cost and error of techniques, as plain data. What was not measured is not there: nothing is made up.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/host.h"

namespace demos::measure {

struct Cost {
    PassTime reflection; ///< the reflection's own passes; the surface's drawing is among `passes`
    PassTime floor;      ///< measured between the same frames, or in them
    std::optional<double> xFloor, xFloorSpread;
    std::optional<uint64_t> bytes; ///< of the reflection on the device, for one view
    double surfaceMs = 0;          ///< all that a frame has for the surface, its waves and its drawing too
    /// The same in trivial passes, of a full screen that is copied, as they were in the same rounds.
    std::optional<double> xTrivial;
    std::optional<double> gpuFrameMs; ///< of the whole frame, from its first timestamp to its last
    uint64_t hostBytes = 0;           ///< what the host holds for it beside, as SurfaceTimes says
    std::vector<PassTime> passes;     ///< of the whole frame
};

/// Shares are 0..1. What has no pixel to be measured on is not there.
struct PictureError {
    std::optional<double> flip, psnrSurfaceDb;        ///< of the picture over the pixels of the surface
    std::optional<double> flipPicture, psnrPictureDb; ///< over all its pixels
    /// Of what is mirrored, before Fresnel, where it is seen elsewhere in the picture; and of these where the
    /// technique says that it found it.
    std::optional<double> psnrDb, psnrValidDb;
    /// What `psnrDb` would be were each such pixel looked up in the very pixel that shows what it mirrors.
    std::optional<double> psnrExactDb;
    std::optional<double> coverage;     ///< hits, of what is mirrored and seen elsewhere in the picture
    std::optional<double> falseSkyHits; ///< hits, of what mirrors the sky
    /// The same where all pixels around mirror the sky too: not at edges, which one sample a pixel cannot
    /// place.
    std::optional<double> falseSkyHitsInside;
    std::optional<double> skyOnGeometry; ///< called sky, of what mirrors something solid
    /// How far from the mirrored point, in pixels, the picture was looked up, where it was rightly so.
    std::optional<double> positionPxP50, positionPxP95, positionPxMax;
    std::optional<double> wrongShare; ///< pixels of the surface that are off by more than 5 % of white
};

struct Entry {
    std::string scene, camera, technique, quality;
    Cost cost;
    PictureError error;

    std::string name() const { return technique + ", " + quality; }
};

/// What one camera of a scene gave, with tone-mapped pictures: RGB, rows from the top.
struct ViewResult {
    std::string scene, camera;
    std::vector<uint8_t> reference;
    std::vector<Entry> entries;                 ///< by technique
    std::vector<std::vector<uint8_t>> pictures; ///< one for each entry
};

/// The entries of one camera of a scene.
struct Sheet {
    std::string scene, camera;
    std::string file;                   ///< of its pictures and its plot, without folder and ending
    size_t firstEntry = 0, entries = 0; ///< of Tradeoff::entries
};

struct Tradeoff {
    std::string device, driver;
    PassClock clock = PassClock::fence; ///< by which costs were taken
    uint32_t width = 0, height = 0;
    uint32_t runs = 0;
    uint32_t samples = 1;       ///< of the reference's colour, a pixel
    uint32_t supersample = 1;   ///< of the pictures that are compared, each way
    bool flat = false;          ///< the waters were stilled
    std::vector<Entry> entries; ///< by scene, camera and technique, in this order
    std::vector<Sheet> sheets;

    /// The median over the sheets.
    std::optional<double> floorMs() const;
    std::span<const Entry> of(const Sheet& sheet) const;
};

} // namespace demos::measure
