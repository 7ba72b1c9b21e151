#include "tests/program/sample.h"

namespace tests {

std::string sampleScene() {
    return R"(title = "Sample"
time_s = 1.5
exposure_ev = 0.5

[sky]
file = "sky.hdr"

[sun]
azimuth_deg = 40
elevation_deg = 20
irradiance = [3, 2, 1]

[[mesh]]
file = "tetra.gltf"
position_m = [0, 0.5, -5]

[water]
level_m = 0
cells_per_level = 128

[water.waves]
wind_m_s = 6
samples = 128
cascades = 1

[water.foam]
bias = 0.2

[water.refraction]
distortion = 1

[water.reflection]
technique = "sspr"

[[camera]]
name = "level"
position_m = [0, 2, 4]
target_m = [0, 1, -5]

[[camera]]
name = "low"
position_m = [0, 1, 4]
target_m = [0, 1, -5]
)";
}

std::string sampleFloorScene() {
    std::string scene = sampleScene();
    const size_t from = scene.find("[water]"), to = scene.find("[[camera]]");
    return scene.replace(from, to - from, R"([floor]
point_m = [0, 0, 0]
normal = [0, 1, 0]
width_m = 10
roughness = 0.25

[floor.reflection]
technique = "sspr"

)");
}

std::string sampleSky() {
    const int width = 16, height = 8;
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool above = y < height / 2;
            file += static_cast<char>(above ? 90 : 60);
            file += static_cast<char>(above ? 120 : 60);
            file += static_cast<char>(above ? 150 + x : 50);
            file += static_cast<char>(128); // exponent: 150 stands for 0.59
        }
    }
    return file;
}

std::string evenSky() {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n" + std::string(size_t{4} * 8 * 16, '\x80');
}

std::string sampleMesh() {
    // Four corners, twelve indices (uint16), as one buffer of 72 bytes.
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,0,-1],"max":[1,2,1]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,AACAvwAAAAAAAIC/AACAPwAAAAAAAIC/AAAAAAAAAAAAAIA/AAAAAAAAAEAAAAAAAAABAAIAAAADAAEAAQADAAIAAgADAAAA"}]})";
}

void writeSample(const std::filesystem::path& folder) {
    writeAll(folder / "scene.toml", sampleScene());
    writeAll(folder / "sky.hdr", sampleSky());
    writeAll(folder / "tetra.gltf", sampleMesh());
    std::filesystem::create_directory(folder / "out");
}

} // namespace tests
