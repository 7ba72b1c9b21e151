#include "host/lens/temporal.h"

#include <algorithm>
#include <cstring>

#include <glm/gtc/type_ptr.hpp>

#include "host/lens/bloom.h"
#include "host/lens/halton.h"
#include "spirv/bloom.frag.h"
#include "spirv/temporal.frag.h"

namespace demos {

namespace {

constexpr uint32_t jitters = 16;
constexpr uint32_t mostMoving = 6, mostStanding = 31; ///< frames that count as much as the new one

/// As in shaders/temporal.frag.
struct TemporalConstants {
    glm::mat4 historyFromClip;
    float pixel[2], kept, moves;
};

} // namespace

std::array<double, 2> jitterOf(uint32_t index) {
    return haltonPx(index % jitters);
}

bool Temporal::fit(const Device& device, const FrameTargets& targets, Error& error) {
    if (histories_[0].image.view) return true;
    if (!pass_.exists() &&
        (!pass_.create(device, temporal_frag, 3, sizeof(TemporalConstants), false, error) ||
         !copy_.create(device, bloom_frag, 1, sizeof(BloomConstants), false, error)))
        return false;
    for (History& history : histories_) {
        const bool made = createPicture(device, targets.extent, history.image, error);
        const VkImageView read[] = {targets.color.view.get(), targets.sceneDepth.view.get(),
                                    history.image.view.get()};
        if (made && pass_.allocate(device, read, history.pool, history.set, error) &&
            copy_.allocate(device, {&history.image.view.get(), 1}, history.copyPool, history.copySet, error))
            continue;
        drop();
        return false;
    }
    return true;
}

void Temporal::drop() {
    for (History& history : histories_) history = {};
    averaged_ = 0;
}

void Temporal::forget() {
    histories_[0].drawn = histories_[1].drawn = false;
}

void Temporal::record(VkCommandBuffer commands, const FrameTargets& targets, const Sight& sight,
                      bool follows) {
    History &before = histories_[1 - next_], &now = histories_[next_];
    const bool stands = follows && sight.desc == before_.desc && sight.timeS == before_.timeS;
    averaged_ = follows && before.drawn ? std::min(averaged_ + 1, stands ? mostStanding : mostMoving) : 0;
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), sight.eye - before_.eye);
    TemporalConstants constants{};
    constants.historyFromClip = glm::mat4(before_.clipFromEye * moved * glm::inverse(sight.clipFromEye));
    constants.pixel[0] = 1.0f / static_cast<float>(targets.extent.width);
    constants.pixel[1] = 1.0f / static_cast<float>(targets.extent.height);
    constants.kept = static_cast<float>(averaged_) / static_cast<float>(averaged_ + 1);
    constants.moves = stands ? 0.0f : 1.0f;

    targets.copyDepth(commands);
    drawnToRead(commands, targets.color);
    // Nothing of it counts, but it is in a layout to be read.
    if (!before.drawn) {
        readToDrawn(commands, before.image, VK_IMAGE_LAYOUT_UNDEFINED);
        drawnToRead(commands, before.image);
    }
    readToDrawn(commands, now.image,
                now.drawn ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_UNDEFINED);
    pass_.record(commands, now.image, before.set, &constants);
    drawnToRead(commands, now.image);
    readToDrawn(commands, targets.color);
    const BloomConstants copy = {{constants.pixel[0], constants.pixel[1]}};
    copy_.record(commands, targets.color, now.copySet, &copy);
    before.drawn = now.drawn = true;
    next_ = 1 - next_;
    before_ = sight;
}

} // namespace demos
