// The pictures of a pair as eyes can take them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "program/compare/pair.h"

namespace demos {

struct ReportPictures {
    std::vector<uint8_t> reference, test, map; ///< RGB
    std::string note;                          ///< how values are shown; empty: as they are
    std::string mapName;
    std::array<std::string, 5> ticks; ///< of the map's scale, from its start to its end
    std::vector<Blob> blobs;          ///< worth a closer look, the largest first
};

/// Light is tone-mapped, values that are no light are grey between the least and the greatest of both.
ReportPictures reportPictures(const CompareOptions& options, const Pair& pair);

/// A picture by itself; `note` as above.
std::vector<uint8_t> reportPicture(const PictureFile& file, std::string& note);

} // namespace demos
