#include "measure/page/table.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace demos::measure {

namespace {

using Json = nlohmann::ordered_json;

template<class T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json costJson(const Cost& cost) {
    Json json;
    json["ms"] = cost.reflection.ms;
    json["spread_ms"] = cost.reflection.spreadMs;
    json["x_floor"] = orNull(cost.xFloor);
    json["x_floor_spread"] = orNull(cost.xFloorSpread);
    json["floor_ms"] = cost.floor.ms;
    json["floor_spread_ms"] = cost.floor.spreadMs;
    json["surface_ms"] = cost.surfaceMs;
    json["surface_x_trivial"] = orNull(cost.xTrivial);
    json["gpu_frame_ms"] = orNull(cost.gpuFrameMs);
    json["bytes"] = orNull(cost.bytes);
    json["host_bytes"] = cost.hostBytes;
    json["passes"] = Json::array();
    for (const PassTime& pass : cost.passes)
        json["passes"].push_back({{"name", pass.name}, {"ms", pass.ms}, {"spread_ms", pass.spreadMs}});
    return json;
}

Json errorJson(const PictureError& error) {
    Json json;
    json["flip"] = orNull(error.flip);
    json["psnr_db"] = orNull(error.psnrDb);
    json["coverage"] = orNull(error.coverage);
    json["false_sky_hits"] = orNull(error.falseSkyHits);
    json["sky_on_geometry"] = orNull(error.skyOnGeometry);
    json["position_px_p50"] = orNull(error.positionPxP50);
    json["position_px_p95"] = orNull(error.positionPxP95);
    json["wrong_share"] = orNull(error.wrongShare);
    json["false_sky_hits_inside"] = orNull(error.falseSkyHitsInside);
    json["position_px_max"] = orNull(error.positionPxMax);
    json["psnr_valid_db"] = orNull(error.psnrValidDb);
    json["psnr_exact_db"] = orNull(error.psnrExactDb);
    json["psnr_surface_db"] = orNull(error.psnrSurfaceDb);
    json["flip_picture"] = orNull(error.flipPicture);
    json["psnr_picture_db"] = orNull(error.psnrPictureDb);
    return json;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

/// Numbers as they stand, texts in quotes, null as nothing.
std::string cell(const Json& value) {
    if (value.is_null()) return "";
    return value.is_string() ? quoted(value.get<std::string>()) : value.dump();
}

Json entryJson(const Entry& entry) {
    Json json;
    json["scene"] = entry.scene;
    json["camera"] = entry.camera;
    json["technique"] = entry.technique;
    json["quality"] = entry.quality;
    json["cost"] = costJson(entry.cost);
    json["error"] = errorJson(entry.error);
    return json;
}

} // namespace

std::string tradeoffJson(const Tradeoff& tradeoff) {
    Json json;
    json["device"] = tradeoff.device;
    json["driver"] = tradeoff.driver;
    json["clock"] = toString(tradeoff.clock);
    json["size"] = {tradeoff.width, tradeoff.height};
    json["runs"] = tradeoff.runs;
    json["reference_samples"] = tradeoff.samples;
    json["supersample"] = tradeoff.supersample;
    json["flat"] = tradeoff.flat;
    json["floor_ms"] = orNull(tradeoff.floorMs());
    json["entries"] = Json::array();
    for (const Entry& entry : tradeoff.entries) json["entries"].push_back(entryJson(entry));
    // Names come from drivers and file systems: what is no UTF-8 is replaced rather than thrown over.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string tradeoffCsv(const Tradeoff& tradeoff) {
    std::string names, lines;
    for (const Entry& entry : tradeoff.entries) {
        names.clear();
        std::string line;
        const auto add = [&](const std::string& name, const Json& value) {
            names += (names.empty() ? "" : ",") + name;
            line += (line.empty() ? "" : ",") + cell(value);
        };
        const Json cost = costJson(entry.cost), error = errorJson(entry.error);
        add("scene", entry.scene);
        add("camera", entry.camera);
        add("technique", entry.technique);
        add("quality", entry.quality);
        for (const auto& [name, value] : cost.items())
            if (!value.is_array()) add(name, value);
        for (const auto& [name, value] : error.items()) add(name, value);
        lines += line + "\n";
    }
    return names + "\n" + lines;
}

} // namespace demos::measure
