// Sequences: how much the picture changes from frame to frame, beside how much the reference's does.
// Two-sided: what flickers changes more, what is frozen or smeared less.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "program/compare/compare_options.h"
#include "program/compare/judged.h"
#include "program/compare/picture_pairs.h"

namespace demos {

struct Sequence {
    std::string name;                         ///< such as deep/color_*.png
    std::vector<std::filesystem::path> files; ///< by number, without a gap; at least two
};

/// Of what is in both folders and can be read.
std::vector<Sequence> sequencesOf(const PicturePairs& pairs);

/// By CompareOptions::flicker, which is given.
Judged judgedSequence(const CompareOptions& options, const Sequence& sequence);

} // namespace demos
