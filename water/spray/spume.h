// How much water wind tears off breaking crests. No Vulkan.
#pragma once

namespace seaglass {

/// Below which no wind tears drops off crests [m/s] (Monahan, Spiel and Davidson 1986).
constexpr double leastSpumeWind = 9;

/// Cross-section of the spume drops of 10 to 500 um that a square metre of sea sends up in a second, by the
/// wind at 10 m (Andreas 1998, whose smallest drops are Smith, Park and Consterdine's 1993 times 3.5) [1/s].
double spumeFlux(double windSpeed);

/// Share, 0..1, of what breaks that wind tears to spray: that flux over the whitecaps that it comes from, of
/// which Beaufort 11 has all. Grows from none at leastSpumeWind to where crests begin to blow away as
/// spindrift, Beaufort 8.
double tornShare(double windSpeed);

} // namespace seaglass
