// Intermediates of a picture that are kept beside it: of those that differ the first is where the fault
// began.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "program/compare/judged.h"

namespace demos {

/// Of names of pictures, such as harbour.height.exr or height_0003.exr.
class Stages {
  public:
    /// In the order in which a renderer makes them, the picture itself last. Seaglass' own, if empty.
    explicit Stages(std::vector<std::string> names = {});

    /// Of a picture; empty where its name has none.
    std::string of(const std::filesystem::path& picture) const;

    /// Says of each picture that differs which of the stages of it, in the same folder, was the first.
    void nameFirst(std::vector<Judged>& all) const;

  private:
    struct Place {
        std::string picture; ///< all but the stage's name
        size_t stage = 0;
    };
    /// Null: no stage.
    std::optional<Place> placeOf(const std::filesystem::path& picture) const;

    std::vector<std::string> names_;
};

/// Whether a stage's values are no light: metres, directions, classes. FLIP says nothing of them.
bool isData(const std::string& stage);

} // namespace demos
