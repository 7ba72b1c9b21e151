// Which of many reflectors to renew in a frame.
#include <algorithm>
#include <vector>

#include "gpu/guard.h"
#include "reflection/core/reflector.h"

namespace seaglass {

namespace {

struct Candidate {
    uint64_t urgency = 0;
    uint32_t index = 0;
};

bool comesBefore(const Candidate& a, const Candidate& b) {
    return a.urgency != b.urgency ? a.urgency > b.urgency : a.index < b.index;
}

Status refuseUnusable(Reflector* const* reflectors, uint32_t count, const ViewDesc* view, uint32_t most,
                      const uint32_t* chosen, const uint32_t* chosenCount) {
    const Context* const context = gpu::contextOf(reflectors, count);
    if (const Status s = gpu::refuseNull(context, "chooseReflectors",
                                         {{"reflectors", count && !reflectors},
                                          {"view", !view},
                                          {"chosen", !chosen},
                                          {"chosenCount", !chosenCount}});
        s != Status::ok)
        return s;
    if (const Status s = gpu::refuseUnusable("chooseReflectors", "reflectors", reflectors, count);
        s != Status::ok)
        return s;
    if (context && (most < 1 || most > maxReflectors))
        return context->device.fail(Status::invalidArgument, "chooseReflectors: most is %u, expected 1 to %u",
                                    most, maxReflectors);
    return gpu::refuseOutsideFrame(context, "chooseReflectors");
}

} // namespace

uint64_t Reflector::urgency(const ViewGeometry& geometry, uint32_t viewIndex) const {
    if (!technique().record) return 0;
    const glm::ivec4 shown = pixelsThatMayShow(bounds, geometry);
    if (isEmpty(shown)) return 0;
    const uint64_t pixels =
        static_cast<uint64_t>(shown.z - shown.x) * static_cast<uint64_t>(shown.w - shown.y);
    const ReflectedView& view = views[viewIndex];
    constexpr uint64_t before = uint64_t{1} << 63;
    if (!view.reflected || !view.isOf(extentOf(geometry))) return before + pixels;
    const uint64_t waited = std::min<uint64_t>(context->frameNumber - view.frame, UINT32_MAX);
    return pixels * std::max<uint64_t>(waited, 1);
}

Status chooseReflectors(Reflector* const* reflectors, uint32_t count, const ViewDesc* view, uint32_t most,
                        uint32_t* chosen, uint32_t* chosenCount) {
    if (chosenCount) *chosenCount = 0;
    if (const Status s = refuseUnusable(reflectors, count, view, most, chosen, chosenCount); s != Status::ok)
        return s;
    return gpu::guarded([&] {
        if (count == 0) return Status::ok;
        ViewGeometry geometry;
        if (const FieldError bad = readCamera(*view, geometry))
            return reflectors[0]->context->device.fail(Status::invalidArgument, "chooseReflectors: %s",
                                                       bad.text());
        std::vector<Candidate> candidates;
        for (uint32_t i = 0; i < count; ++i)
            if (const uint64_t urgency = reflectors[i]->urgency(geometry, view->viewIndex); urgency > 0)
                candidates.push_back({urgency, i});
        std::ranges::sort(candidates, comesBefore);
        if (candidates.size() > most) candidates.resize(most);
        std::ranges::sort(candidates, {}, &Candidate::index);
        for (const Candidate& candidate : candidates) chosen[(*chosenCount)++] = candidate.index;
        return Status::ok;
    });
}

} // namespace seaglass
