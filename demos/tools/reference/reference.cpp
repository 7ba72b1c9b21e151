#include "reference/reference.h"

#include "reference/pixel.h"

namespace demos::reference {
namespace {

glm::vec3 colorOf(const Frame& frame, uint32_t x, uint32_t y) {
    PixelSum pixel;
    for (uint32_t i = 0; i < frame.desc.samples; ++i) pixel.add(frame, x, y, i);
    return pixel.mean();
}

Picture emptyPicture(const Frame& frame) {
    return {frame.desc.width, frame.desc.height,
            std::vector<float>(size_t(frame.desc.width) * frame.desc.height * 4)};
}

void renderRow(const Frame& frame, uint32_t y, Pictures& out) {
    for (uint32_t x = 0; x < frame.desc.width; ++x) {
        const size_t at = (size_t(y) * frame.desc.width + x) * 4;
        const glm::vec3 color = colorOf(frame, x, y);
        for (int c = 0; c < 3; ++c) out.color.rgba[at + static_cast<size_t>(c)] = color[c];
        out.color.rgba[at + 3] = 1;
        if (out.truth.rgba.empty()) continue;
        const Truth truth = truthAt(frame, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        out.truth.rgba[at] = static_cast<float>(truth.kind);
        out.truth.rgba[at + 1] = truth.pixel.x;
        out.truth.rgba[at + 2] = truth.pixel.y;
        out.truth.rgba[at + 3] = truth.distance;
        for (int c = 0; c < 3; ++c) out.mirrored.rgba[at + static_cast<size_t>(c)] = truth.radiance[c];
        out.mirrored.rgba[at + 3] = 1;
    }
}

} // namespace

Pictures renderReference(const Frame& frame, bool withTruth, const ProgressFunction& progress) {
    Pictures out;
    out.color = emptyPicture(frame);
    if (withTruth) out.truth = out.mirrored = emptyPicture(frame);
    forEachRow(
        frame.desc.height, frame.desc.threads, [&](uint32_t y) { renderRow(frame, y, out); }, progress);
    return out;
}

} // namespace demos::reference
