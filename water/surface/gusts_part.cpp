// Cat's paws: shaders/water/surface/gusts.glsl.
#include <algorithm>
#include <cmath>

#include "water/body/body.h"
#include "water/body/part.h"
#include "water/interface/sea_contents.h"
#include "water/interface/wrapped_cell.h"

namespace seaglass {

namespace {

constexpr double gustCell = 90;       ///< of their largest noise [m]
constexpr double secondsOfGusts = 60; ///< until another generation has taken over, about

/// On noise that the wind has carried along since the middle of its generation's life.
struct Generation {
    int64_t number = 0;
    double since = 0; ///< [s]
    double share = 0; ///< of what shows: from 0 up to 1 and back
};

/// Two live at any time. As whole generations make a loop, so do gusts.
Generation generationAt(double time, double loop, int which) {
    const double count = std::max(std::round(loop / secondsOfGusts), 2.0);
    const double lives = count * (time / loop - std::floor(time / loop)) + 0.5 * which;
    const double whole = std::floor(lives), past = lives - whole;
    const double number = std::fmod(whole, count);
    return {2 * static_cast<int64_t>(number) + which, (past - 0.5) * loop / count,
            1 - std::abs(2 * past - 1)};
}

struct GustsPart {
    static bool wanted(const BodyDesc& desc, const Sea* sea) {
        return sea && desc.shading.gusts > 0 && description(*sea).windSpeed > 0;
    }

    void fill(const Body& body, const BodyView& view, BodyBlock& block) const {
        const SeaDesc& sea = description(*body.sea);
        const auto wind = static_cast<double>(sea.windSpeed),
                   towards = static_cast<double>(sea.windDirection);
        const auto amplitude = static_cast<double>(sea.amplitude);
        const double lacks = std::max(1 - amplitude * amplitude, 0.0) * coxMunkSlopeVariance(wind) / 2;
        block.gusts = glm::vec4(body.shading.gusts, lacks, 1 / gustCell, 0);
        const glm::dvec2 eye(view.geometry.eye.x, view.geometry.eye.z);
        for (int i = 0; i < 2; ++i) {
            const Generation now = generationAt(body.simulatedTime, sea.loopPeriod, i);
            const glm::dvec2 along(std::cos(towards), std::sin(towards));
            const glm::dvec2 cells = (eye - wind * now.since * along) / gustCell;
            const glm::dvec2 whole = glm::floor(cells);
            block.gustCell[i] = {wrappedCell(whole.x), wrappedCell(whole.y),
                                 static_cast<int32_t>(0x27d4eb2f * static_cast<uint32_t>(now.number)), 0};
            block.gustPlace[i] = glm::vec4(cells - whole, now.share, 0);
        }
    }

    void vary(const Body&, const SurfaceDraw&, SurfaceVariant& variant) const { variant.hasGusts = true; }
};

} // namespace

Part gustsPart() {
    return partFrom<GustsPart>();
}

} // namespace seaglass
