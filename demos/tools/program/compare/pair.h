// Two pictures, read and measured.
#pragma once

#include <optional>

#include "host/files/image_file.h"
#include "program/compare/compare_options.h"

namespace demos {

struct Pair {
    PictureFile reference, test;
    PictureKind kind = PictureKind::display;
    Limits limits; ///< those given, and the tolerant ones where they are asked for
    Mask leftOut;
    Comparison comparison;
    std::vector<std::string> objections; ///< empty when the two are the same within the limits

    const Picture& expected() const { return reference.picture; }
    const Picture& actual() const { return test.picture; }
};

/// Of pictures that were compared: the next ones take it, because the system clears all that is new.
struct SpentPixels {
    std::vector<float> reference, test;
};

/// Both pictures, and by what they are to be compared. Null with `error` set when they cannot be.
std::optional<Pair> readPair(const CompareOptions& options, Error& error, SpentPixels spent = {});

/// Likewise, and compared.
std::optional<Pair> measurePair(const CompareOptions& options, Error& error, SpentPixels spent = {});

/// Objections on one line.
std::string joined(const std::vector<std::string>& objections);

} // namespace demos
