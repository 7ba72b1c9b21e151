#include "reference/texture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demos::reference {
namespace {

float linearOf(uint8_t byte) {
    const float c = static_cast<float>(byte) / 255;
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

size_t wrapped(int64_t i, uint32_t size, Wrap wrap) {
    const auto n = static_cast<int64_t>(size);
    if (wrap == Wrap::clamp) return static_cast<size_t>(std::clamp<int64_t>(i, 0, n - 1));
    const int64_t period = wrap == Wrap::mirror ? 2 * n : n;
    const int64_t in = (i % period + period) % period;
    return static_cast<size_t>(in < n ? in : 2 * n - 1 - in);
}

} // namespace

Texture::Texture(const MeshTexture& source)
    : wrapU_(source.wrapU), wrapV_(source.wrapV), larger_(source.larger), smaller_(source.smaller),
      mips_(source.mips) {
    Level level{source.width, source.height, {}};
    level.texels.resize(size_t(level.width) * level.height);
    for (size_t i = 0; i < level.texels.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const uint8_t byte = source.rgba[4 * i + static_cast<size_t>(c)];
            level.texels[i][c] = source.srgb && c < 3 ? linearOf(byte) : static_cast<float>(byte) / 255;
        }
    levels_.push_back(std::move(level));
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        // A blit with a linear filter takes the texels between which the new one's centre lies.
        const Level& last = levels_.back();
        Level next{std::max(1u, last.width / 2), std::max(1u, last.height / 2), {}};
        const Wrap wrapU = std::exchange(wrapU_, Wrap::clamp), wrapV = std::exchange(wrapV_, Wrap::clamp);
        next.texels.resize(size_t(next.width) * next.height);
        for (uint32_t y = 0; y < next.height; ++y)
            for (uint32_t x = 0; x < next.width; ++x)
                next.texels[size_t(y) * next.width + x] =
                    bilinear(last, {(static_cast<float>(x) + 0.5f) / static_cast<float>(next.width),
                                    (static_cast<float>(y) + 0.5f) / static_cast<float>(next.height)});
        wrapU_ = wrapU;
        wrapV_ = wrapV;
        levels_.push_back(std::move(next));
    }
}

glm::vec4 Texture::bilinear(const Level& level, const glm::vec2& uv) const {
    const double x = static_cast<double>(uv.x) * level.width - 0.5;
    const double y = static_cast<double>(uv.y) * level.height - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    const auto at = [&](int64_t i, int64_t j) {
        return level.texels[wrapped(j, level.height, wrapV_) * level.width + wrapped(i, level.width, wrapU_)];
    };
    const auto i = static_cast<int64_t>(x0), j = static_cast<int64_t>(y0);
    return glm::mix(glm::mix(at(i, j), at(i + 1, j), fx), glm::mix(at(i, j + 1), at(i + 1, j + 1), fx), fy);
}

glm::vec4 Texture::nearest(const Level& level, const glm::vec2& uv) const {
    const auto i = static_cast<int64_t>(std::floor(double{uv.x} * level.width));
    const auto j = static_cast<int64_t>(std::floor(double{uv.y} * level.height));
    return level.texels[wrapped(j, level.height, wrapV_) * level.width + wrapped(i, level.width, wrapU_)];
}

glm::vec4 Texture::sample(const glm::vec2& uv, const glm::vec2& right, const glm::vec2& below) const {
    const glm::vec2 size(static_cast<float>(levels_[0].width), static_cast<float>(levels_[0].height));
    const float texels = std::max(glm::length(right * size), glm::length(below * size));
    const auto last = static_cast<float>(levels_.size() - 1);
    const float detail = std::log2(std::max(texels, 1e-6f));
    const float mip = mips_ == Mips::none ? 0.0f : std::clamp(detail, 0.0f, last);
    const Filter filter = detail <= 0 ? larger_ : smaller_;
    const auto at = [&](size_t level) {
        return filter == Filter::nearest ? nearest(levels_[level], uv) : bilinear(levels_[level], uv);
    };
    if (mips_ != Mips::linear) return at(static_cast<size_t>(mip + 0.5f));
    const auto level = static_cast<size_t>(mip);
    const size_t next = std::min(level + 1, levels_.size() - 1);
    return glm::mix(at(level), at(next), mip - static_cast<float>(level));
}

} // namespace demos::reference
