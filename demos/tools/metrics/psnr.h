#pragma once

namespace demos {

/// Peak signal-to-noise ratio in decibels; infinite where there is no error.
double psnrDb(double meanSquareError, double peak);

} // namespace demos
