#include "program/render/stats.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace demos {

std::string statsJson(const DeviceInfo& device, const Size& size, const Scene& scene,
                      const CameraDesc& camera, const FrameTimes& times) {
    nlohmann::ordered_json json;
    json["device"] = device.name;
    json["driver"] = device.driver;
    json["size"] = {size.width, size.height};
    json["scene"] = scene.file.string();
    json["camera"] = camera.name;
    json["clock"] = toString(times.clock);
    json["frame_ms"] = times.frameMs;
    json["gpu_frame_ms"] = times.gpuFrameMs ? nlohmann::ordered_json(*times.gpuFrameMs) : nullptr;
    json["cpu_simulate_ms"] = times.cpuSimulateMs;
    json["runs"] = times.runs;
    json["floor_ms"] = times.yardsticks.floor.ms;
    json["full_screen_ms"] = times.yardsticks.fullScreen.ms;
    json["passes"] = nlohmann::ordered_json::array();
    for (const PassTime& pass : times.passes) {
        json["passes"].push_back({{"name", pass.name}, {"ms", pass.ms}, {"spread_ms", pass.spreadMs}});
    }
    // Names come from drivers and file systems: what is no UTF-8 is replaced rather than thrown over.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string statsTable(const FrameTimes& times) {
    size_t width = sizeof("simulate (CPU)") - 1;
    for (const PassTime& pass : times.passes) width = std::max(width, pass.name.size());
    std::string table;
    const auto row = [&](const std::string& name, const std::string& ms, const std::string& spread) {
        std::vector<char> line(width + 64);
        std::snprintf(line.data(), line.size(), "%-*s %10s %10s\n", static_cast<int>(width), name.c_str(),
                      ms.c_str(), spread.c_str());
        table += line.data();
    };
    const auto number = [](double ms) {
        char text[32];
        std::snprintf(text, sizeof(text), "%.3f", ms);
        return std::string(text);
    };
    row("pass", "ms", "spread ms");
    for (const PassTime& pass : times.passes) row(pass.name, number(pass.ms), number(pass.spreadMs));
    for (const PassTime* const pass : {&times.yardsticks.floor, &times.yardsticks.fullScreen})
        row(pass->name, number(pass->ms), number(pass->spreadMs));
    row("simulate (CPU)", number(times.cpuSimulateMs), "");
    if (times.gpuFrameMs) row("frame (GPU)", number(*times.gpuFrameMs), "");
    row("frame", number(times.frameMs), "");
    return table + "by " + describe(times.clock) + "\n";
}

} // namespace demos
