#include "measure/shots.h"

namespace demos::measure {

namespace {

bool take(Host& host, FrameDesc frame, Aov aov, Picture& out, Error& error) {
    frame.aov = aov;
    std::optional<Picture> picture = host.render(frame, error);
    if (picture) out = std::move(*picture);
    return picture.has_value();
}

} // namespace

bool takeShots(Host& host, const FrameDesc& frame, Shots& out, Error& error) {
    return take(host, frame, Aov::color, out.color, error) &&
           take(host, frame, Aov::reflection, out.reflection, error) &&
           take(host, frame, Aov::reflectionSource, out.sources, error) &&
           (!out.scene.rgba.empty() || take(host, frame, Aov::scene, out.scene, error));
}

} // namespace demos::measure
