// The layers of an OpenEXR file: which channels belong together, and which of them are the picture. Channel
// names are "layer.R" (OpenEXR, "Technical Introduction"); parts have names of their own.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/surroundings.h"

namespace demos {

/// What one part of a file holds.
struct ImagePart {
    std::string name;
    std::vector<std::string> channels;
};

/// A layer that a picture is read from.
struct ImageLayer {
    int part = 0;
    std::string name; ///< as it is asked for; empty: the file's one unnamed layer
    /// Channels in their part of red, green, blue and alpha; -1: there is none. Grey has red alone, and a
    /// layer of two channels no blue.
    std::array<int, 4> channels{-1, -1, -1, -1};
};

/// What is asked for by name, and how: "sky.layer", for errors.
struct LayerChoice {
    std::string name; ///< of a layer or its last part, in any case; empty: the one that is the picture
    std::string option;
    bool anyChannel = false; ///< a file of one channel has a picture, whatever that is called
};

/// The unnamed layer, or the one of a beauty pass' name, or the only one of colour. Null with `error`, which
/// does not name the file, when that is none or several.
std::optional<ImageLayer> chooseLayer(const std::vector<ImagePart>& parts, const LayerChoice& choice,
                                      Error& error);

} // namespace demos
