// Says where a sea is not the one asked for, since its cascades hold too little of it.
#pragma once

#include <string>

namespace demos {

/// For pictures: below it waves are more than a tenth too low.
constexpr double leastResolvedInPictures = 0.8;

/// A line to stderr when `resolvedShare` (seaglass/sea.h) is below `least`. `beginning` leads in, or is
/// empty; `patch` and `samples` are what they are called where they were asked for.
void warnOfLostWaves(double resolvedShare, double least, const std::string& beginning,
                     const std::string& patch, const std::string& samples);

} // namespace demos
