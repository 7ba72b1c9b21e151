#include "metrics/tolerant.h"

namespace demos {

Limits tolerantLimits(PictureKind kind) {
    Limits limits;
    limits.flipMean = 0.01;
    limits.flipP99 = 0.06;
    limits.flipLocal = 0.035;
    limits.wrong = {0.15, 0.002, 16};
    // Light has no white that a step could be a share of.
    if (kind == PictureKind::display) {
        limits.shares = {{3.0 / 255, 0.025}, {0.35, 0, true}};
        limits.differenceMean = 0.003;
    } else {
        limits.flipMax = 0.6;
        limits.outliers = 0;
    }
    return limits;
}

} // namespace demos
