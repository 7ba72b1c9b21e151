#include "reference/progressive.h"

namespace demos::reference {

Progressive::Progressive(const Frame& frame)
    : frame_(frame), pixels_(size_t(frame.desc.width) * frame.desc.height) {}

bool Progressive::add(const ProgressFunction& goOn) {
    const FrameDesc& desc = frame_.desc;
    const auto row = [&](uint32_t y) {
        for (uint32_t x = 0; x < desc.width; ++x)
            pixels_[size_t(y) * desc.width + x].add(frame_, x, y, samples_);
    };
    if (!forEachRow(desc.height, desc.threads, row, goOn)) return false;
    ++samples_;
    return true;
}

Picture Progressive::mean() const {
    Picture out{frame_.desc.width, frame_.desc.height, std::vector<float>(4 * pixels_.size(), 1)};
    for (size_t i = 0; i < pixels_.size(); ++i) {
        const glm::vec3 color = pixels_[i].mean();
        for (int c = 0; c < 3; ++c) out.rgba[4 * i + static_cast<size_t>(c)] = color[c];
    }
    return out;
}

} // namespace demos::reference
