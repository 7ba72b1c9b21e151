// Draws, traces and times what a tradeoff is made of.
#pragma once

#include <functional>
#include <span>

#include "measure/technique.h"
#include "measure/tradeoff.h"

namespace demos::measure {

struct RunDesc {
    uint32_t width = 1280, height = 720;
    uint32_t runs = 20;           ///< medians of so many
    bool firstCameraOnly = false; ///< instead of all
};

enum class RunResult { ok, unreadable, failed }; ///< unreadable: a file that the scene names

/// What is being done, how much is done, and of how much.
using ProgressFunction = std::function<void(const std::string&, uint32_t, uint32_t)>;

/// Adds the entries and sheets of one scene. The reference is of the same moment, one ray a pixel through its
/// centre, as the host samples it.
RunResult measureScene(Host& host, std::span<const Variant> variants, const RunDesc& desc,
                       const ProgressFunction& progress, Tradeoff& out, Error& error);

} // namespace demos::measure
