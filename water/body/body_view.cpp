// How a body reads the views that it is drawn in: whether they are usable, and what of the water they see.
#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "gpu/view/encoding.h"
#include "water/below/refraction_part.h"
#include "water/below/underwater_part.h"
#include "water/body/body.h"
#include "water/light/lighting.h"

namespace seaglass {

namespace {

/// Where lines of sight begin, within `reach` metres of a place.
struct SightStart {
    glm::dvec3 middle{0};
    double reach = 0;
};

/// At the eye, as far as the corners of the near plane; of parallel lines on that plane, as far as those
/// stand above its middle.
SightStart sightStart(const ViewGeometry& geometry) {
    const double depth = geometry.reversedDepth ? 1 : 0;
    const auto onNearPlane = [&](double x, double y) {
        const glm::dvec2 at = glm::dvec2(x, y) * glm::dvec2(geometry.regionSize);
        const glm::dvec4 p = geometry.relativeFromPixel * glm::dvec4(at, depth, 1);
        return glm::dvec3(p) / std::abs(p.w);
    };
    const glm::dvec3 middle = geometry.parallel ? onNearPlane(0.5, 0.5) : glm::dvec3(0);
    SightStart start{geometry.eye + middle, 0};
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 corner = onNearPlane(i & 1, i >> 1) - middle;
        start.reach = std::max(start.reach, geometry.parallel ? std::abs(corner.y) : glm::length(corner));
    }
    return start;
}

/// In a camera-to-world matrix the camera's right is level, most often. Taken for its inverse, the camera
/// looks rolled; but for one that looks along the z axis, which stays level. Along the x axis a camera that
/// is rolled indeed would look the same.
bool looksInverse(const ViewDesc& view) {
    const double(&m)[16] = view.view;
    const bool isRolled = std::abs(m[4]) > 1e-3;
    const bool otherIsNot = std::abs(m[1]) < 1e-6 && std::abs(m[0]) > 1e-6 && m[5] > 0;
    return isRolled && otherIsNot;
}

} // namespace

FieldError Body::readTurned(const ViewDesc& view, bool seesScene, ViewGeometry& out) const {
    const ViewDesc turned = frame.fromWorld(view);
    if (const FieldError bad = seesScene ? readView(turned, out) : readCamera(turned, out)) return bad;
    placeEye(out, -plane.w);
    return {};
}

Status Body::read(const char* call, const ViewDesc& view, const LightingDesc& lighting, const char* wanted,
                  BodyView& out) {
    const gpu::Device& device = context->device;
    const RefractionPart* refraction = find<RefractionPart>();
    const bool seesScene = refraction && hasScene(view);
    if (const FieldError bad = readTurned(view, seesScene, out.geometry))
        return device.fail(Status::invalidArgument, "%s: %s", call, bad.text());
    if (wanted && !seesScene)
        return device.fail(Status::invalidArgument,
                           "%s: ViewDesc.sceneColor.view and sceneDepth.view are null, and %s reads them",
                           call, wanted);
    if (const FieldError bad = badField(lighting))
        return device.fail(Status::invalidArgument, "%s: %s", call, bad.text());
    if (sea && simulatedIn == 0)
        return device.misused("%s: the body has waves but simulate() was never called", call);
    drawnIn = context->frameNumber;
    out.given = &view;
    out.read = view;
    out.lighting = &lighting;
    if (!refraction) return Status::ok;
    tellUnspecified(*context, view.sceneColor);
    if (!isMultisampled(view)) return Status::ok;
    if (!maySee(out.geometry)) return Status::ok; // nothing was taken, and nothing will be drawn
    return refraction->standIn(*context, view, out.read);
}

Status Body::readSurface(const char* call, const ViewDesc& view, const LightingDesc& lighting,
                         SurfaceOutput output, BodyView& out, SurfaceDraw& drawn) {
    if (const Status s = read(call, view, lighting, needsScene(), out); s != Status::ok) return s;
    drawn = {.output = output,
             .sides = output == SurfaceOutput::motion ? SidesSeen::above : sidesSeen(out.geometry),
             .seesScene = hasScene(view),
             .sceneIsEncoded = isEncoded(view.sceneColor),
             .manySamples = isMultisampled(view),
             .view = &view,
             .lighting = &lighting};
    out.surface = &drawn;
    return checkEye(call, view, out.geometry);
}

bool Body::mayBeWet(const glm::dvec3& point) const {
    return find<UnderwaterPart>() && placing.covers(point) && !isExcluded(exclusionVolumes, point);
}

SidesSeen Body::sidesSeen(const ViewGeometry& geometry) const {
    const SightStart start = sightStart(geometry);
    if (!mayBeWet(start.middle)) return SidesSeen::above;
    const double height = heightOf(start.middle);
    const double reach = placing.displacement + start.reach;
    if (height > reach) return SidesSeen::above;
    return height < -reach ? SidesSeen::below : SidesSeen::either;
}

bool Body::maySee(const ViewGeometry& geometry) {
    return sidesSeen(geometry) != SidesSeen::above || placing.maySee(geometry);
}

const char* Body::needsScene() const {
    const char* field = nullptr;
    for (const auto& [part, state] : has)
        if (part->needsScene) field = part->needsScene;
    return field;
}

Status Body::checkEye(const char* call, const ViewDesc& view, const ViewGeometry& geometry) {
    const bool isInverse = looksInverse(view);
    const glm::dvec3& eye = geometry.eye;
    const double depth = -heightOf(eye);
    const bool isBelow = !find<UnderwaterPart>() && !geometry.parallel && depth > placing.displacement &&
                         placing.covers(eye) && !isExcluded(exclusionVolumes, eye);
    if (!isBelow && !isInverse) return Status::ok;
    const double(&m)[16] = view.view;
    const glm::dvec3 other = frame.fromWorld(glm::dvec3(m[12], m[13], m[14]));
    if (isBelow && isInverse && heightOf(other) > 0)
        return context->device.fail(
            Status::invalidArgument,
            "%s: ViewDesc.view takes the camera to the world, expected world to view: its inverse", call);
    if (std::exchange(warnedOfEye, true)) return Status::ok;
    if (isBelow)
        context->device.warn(
            "%s: the eye is %.3g m under a body without BodyDesc.underwater, which is made to be "
            "seen from above; is ViewDesc.view world to view, of a world with y up?",
            call, depth);
    else
        context->device.warn(
            "%s: the camera of ViewDesc.view is rolled, and its inverse's is level; is it world to view?",
            call);
    return Status::ok;
}

} // namespace seaglass
