#include <cstdio>

#include "measure/page/table.h"

namespace demos::measure {

namespace {

std::string cell(const char* format, const std::optional<double>& value, double scale = 1) {
    char text[32] = " - |";
    if (value) std::snprintf(text, sizeof(text), format, *value * scale);
    return text;
}

std::string line(const Entry& entry) {
    const Cost& cost = entry.cost;
    const PictureError& error = entry.error;
    std::optional<double> megabytes;
    if (cost.bytes) megabytes = static_cast<double>(*cost.bytes) * 1e-6;
    return "| " + entry.camera + " | " + entry.technique + " | " + entry.quality + " |" +
           cell(" %.3f |", cost.reflection.ms) + cell(" %.3f |", cost.reflection.spreadMs) +
           cell(" %.2f |", cost.xFloor) + cell(" %.1f |", cost.surfaceMs) + cell(" %.1f |", cost.xTrivial) +
           cell(" %.1f |", megabytes) + cell(" %.4f |", error.flip) + cell(" %.1f |", error.wrongShare, 100) +
           cell(" %.2f |", error.psnrDb) + cell(" %.2f |", error.psnrExactDb) +
           cell(" %.1f |", error.coverage, 100) + cell(" %.2f |", error.positionPxP50) +
           cell(" %.2f |", error.positionPxP95) + cell(" %.2f |", error.falseSkyHits, 100) +
           cell(" %.2f |", error.falseSkyHitsInside, 100) + cell(" %.2f |", error.skyOnGeometry, 100) + "\n";
}

constexpr const char* tableHead =
    "| camera | technique | quality | ms | \u00b1 | x floor | whole surface, ms | x trivial | MB | FLIP | "
    "wrong, % "
    "| PSNR, dB | exactly placed | found, % | "
    "off, px: median | p95 | sky as solid, % | inside it | solid as sky, % |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

} // namespace

std::string tradeoffMarkdown(const Tradeoff& tradeoff) {
    char about[256];
    std::snprintf(about, sizeof(about), "; %ux%u, medians of %u by %s, floor %.3f ms%s.\n", tradeoff.width,
                  tradeoff.height, tradeoff.runs, describe(tradeoff.clock), tradeoff.floorMs().value_or(0),
                  tradeoff.flat ? ", the water stilled" : "");
    std::string text = tradeoff.device + ", " + tradeoff.driver + about;
    const std::string* scene = nullptr;
    for (const Entry& entry : tradeoff.entries) {
        if (!scene || *scene != entry.scene) text += "\n### " + entry.scene + "\n\n" + tableHead;
        scene = &entry.scene;
        text += line(entry);
    }
    return text;
}

} // namespace demos::measure
