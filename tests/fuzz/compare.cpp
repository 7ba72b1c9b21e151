// Measures of two small pictures of any values.
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "metrics/compare.h"
#include "metrics/tolerant.h"
#include "tests/fuzz/taken.h"

namespace fuzz {

void comparePictures(Bytes bytes) {
    constexpr uint32_t mostEdge = 12;
    Taken from(bytes);
    const demos::PictureKind kind = from.yes() ? demos::PictureKind::linear : demos::PictureKind::display;
    const uint32_t width = 1 + from.below(mostEdge), height = 1 + from.below(mostEdge);
    std::vector<float> pictures[2];
    for (std::vector<float>& picture : pictures) {
        picture.resize(size_t{4} * width * height);
        for (float& value : picture) value = from.value<float>();
    }
    const demos::Limits limits = demos::tolerantLimits(kind);
    const demos::Comparison compared =
        demos::compare({width, height, pictures[0]}, {width, height, pictures[1]}, kind, limits);
    const std::vector<std::string> objections = demos::objections(compared, limits);
    // Neither NaN nor infinity passes.
    const bool finite = compared.notFiniteInReference + compared.notFiniteInTest == 0;
    if (!finite && objections.empty()) std::abort();
    if ((demos::badness(compared, limits) > 1) != !objections.empty()) std::abort();
    // Equal pictures are within every limit.
    if (finite && pictures[0] == pictures[1] && !objections.empty()) std::abort();
}

} // namespace fuzz
