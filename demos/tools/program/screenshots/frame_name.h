// Names of the pictures of a sequence, such as color_0003.png.
#pragma once

#include <optional>
#include <string>

namespace demos {

struct FrameName {
    std::string stem; ///< without the number and what parts it off
    std::optional<uint32_t>
        number; ///< of two digits or more behind _, - or a dot; null: a picture of its own
};

/// Of a file's name without its extension.
FrameName frameName(const std::string& stem);

} // namespace demos
