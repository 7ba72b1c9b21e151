#include "tests/reference/traced_picture.h"

#include <stdexcept>

namespace tests {

demos::reference::Pictures traced(const demos::reference::World& world,
                                  const demos::reference::FrameDesc& desc, bool withTruth) {
    demos::reference::Frame frame;
    demos::Error error;
    if (!demos::reference::prepareFrame(world, desc, frame, error)) throw std::runtime_error(error.text);
    return demos::reference::renderReference(frame, withTruth);
}

demos::reference::Pictures traced(const demos::Scene& scene, const demos::reference::FrameDesc& desc,
                                  bool withTruth) {
    demos::reference::World world;
    demos::Error error;
    if (!demos::reference::loadWorld(scene, world, error)) throw std::runtime_error(error.text);
    return traced(world, desc, withTruth);
}

} // namespace tests
