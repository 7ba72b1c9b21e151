// Draws, traces and times what a tradeoff is made of.
#pragma once

#include <functional>

#include "measure/subject.h"
#include "measure/tradeoff.h"

namespace demos::measure {

struct RunDesc {
    uint32_t width = 1280, height = 720;
    uint32_t rounds = 20;     ///< medians of so many
    uint32_t samples = 1;     ///< of the reference's colour, a pixel
    uint32_t supersample = 1; ///< pictures that are compared are means of so many pixels each way
};

enum class RunResult { ok, failed, stopped };

/// What is being done, how much is done, and of how much. False stops it.
using ProgressFunction = std::function<bool(const std::string&, uint32_t, uint32_t)>;
/// Takes each view as it is finished. False with the error set fails the run.
using FinishedFunction = std::function<bool(ViewResult&&, Error&)>;

/// Measures one view after the other. The reference is of the same moment; what is mirrored where, its
/// classes and radiances, are of one ray a pixel through its centre, as the host samples it.
RunResult measureSubject(Host& host, const Subject& subject, const RunDesc& desc,
                         const ProgressFunction& progress, const FinishedFunction& finished, Error& error);

} // namespace demos::measure
