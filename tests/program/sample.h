// A small scene with everything in it, in a folder of its own.
#pragma once

#include <string>

#include "tests/program/run.h"

namespace tests {

/// The scene's text: sky.hdr, tetra.gltf, water with all features, cameras "level" and "low".
std::string sampleScene();
/// The same with a floor in the water's place.
std::string sampleFloorScene();
/// A 16x8 lat-long sky, Radiance HDR.
std::string sampleSky();
/// One of the same light from everywhere, 0.5.
std::string evenSky();
/// One tetrahedron, its data within the JSON.
std::string sampleMesh();

/// Puts scene.toml, sky.hdr and tetra.gltf into a folder, and makes a folder out/ in it.
void writeSample(const std::filesystem::path& folder);

} // namespace tests
