#include "metrics/psnr.h"

#include <cmath>

namespace demos {

double psnrDb(double meanSquareError, double peak) {
    if (meanSquareError == 0) return HUGE_VAL;
    return 10 * std::log10(peak * peak / meanSquareError);
}

} // namespace demos
