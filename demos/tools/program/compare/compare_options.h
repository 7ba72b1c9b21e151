// The command line of seaglass compare.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "metrics/compare.h"
#include "program/screenshots/regions.h"
#include "program/screenshots/stages.h"
#include "scene/scene.h"

namespace CLI {
class App;
}

namespace demos {

struct CompareOptions {
    std::filesystem::path reference, test;
    std::string referenceLayer, testLayer; ///< of EXRs with several; empty: the one that is the picture
    Limits limits;                         ///< those that are given
    bool tolerant = false;                 ///< tolerantLimits() where none is given
    std::optional<double> data;    ///< what values that are no light may be off by, where it is tolerant
    std::optional<double> flicker; ///< share that a sequence's changes may be off by from the reference's
    LeftOut leftOut;
    Stages stages;
    std::string driver;  ///< that made the test's pictures; empty: not said, and references gate
    bool advice = false; ///< references are another driver's, and gate nothing
    bool large = false;  ///< takes pictures that unpack to far more than their files hold
    std::filesystem::path report, json, junit; ///< empty: none
    std::optional<double> exposureEv;          ///< of the report's pictures of linear light
};

/// What the line says, before any of it is checked.
struct RawCompare {
    std::string reference, test, maxFlip, maxDiff, maxShare, maxP99, maxPixel, wrong, maxWrong, maxBlob,
        maxData, maxLocal, report, exposure, json, junit, mask, maxFlicker, driver;
    std::vector<std::string> ignored, stages;
    bool tolerant = false;
    std::vector<std::string> layers;
    bool large = false;
};

void describeCompare(CLI::App& command, RawCompare& raw);
std::optional<CompareOptions> checkCompare(const RawCompare& raw, Error& error);

} // namespace demos
