// Of builds with SEAGLASS_SHADER_RELOAD alone: shaders with a defect, for scripts/mutants.
#pragma once

namespace tests {

/// From here on pipelines take NAME.spv of the folder that the environment names by SEAGLASS_SWAPPED_SHADERS,
/// where there is one, for the built-in shader of that name.
void swapShaders();

} // namespace tests
