#include "water/below/bed.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "gpu/view/oblique.h"
#include "gpu/view/scene_formats.h"
#include "reflection/interface/drawn_images.h"

namespace seaglass {

namespace {

/// Whole pixels, so that a point of the surface has the same place in its pixel in both pictures.
glm::ivec2 marginOf(const BedDesc& desc, const glm::ivec2& size) {
    constexpr double rounding = 1e-3; // tenths are none as floats
    return glm::ivec2(glm::ceil(glm::dvec2(size) * double{desc.margin} - rounding));
}

/// As many pixels as show what `size` of the view and a `margin` on each side do.
glm::dvec2 pixelsOf(const glm::dvec2& size, const glm::ivec2& margin, uint32_t downscale) {
    return glm::ceil((size + 2.0 * glm::dvec2(margin)) / static_cast<double>(downscale));
}

/// `view` over what is larger by `margin` on each side, in a viewport of its own pixels with its corner at 0.
ViewDesc widened(const ViewDesc& view, const ViewGeometry& geometry, const glm::ivec2& margin,
                 uint32_t downscale) {
    ViewDesc out = view;
    const VkViewport& v = view.viewport;
    const double height = std::abs(double{v.height}), scale = downscale;
    const double top = v.height < 0 ? double{v.y} - height : double{v.y};
    const glm::dvec2 share(double{v.width} / (double{v.width} + 2 * margin.x),
                           height / (height + 2 * margin.y));
    const glm::dvec2 wide = pixelsOf(glm::dvec2(double{v.width}, height), margin, downscale);
    const glm::dvec2 corner = (glm::dvec2(double{v.x}, top) - glm::dvec2(geometry.regionOrigin)) / scale;
    out.viewport.x = static_cast<float>(corner.x);
    out.viewport.y = static_cast<float>(v.height < 0 ? corner.y + wide.y : corner.y);
    out.viewport.width = static_cast<float>(wide.x);
    out.viewport.height = static_cast<float>(v.height < 0 ? -wide.y : wide.y);
    for (int column = 0; column < 4; ++column) {
        out.projection[4 * column] *= share.x;
        out.projection[4 * column + 1] *= share.y;
    }
    return out;
}

/// How many times higher than the eye lies where a ray seems to come from that calm water bends, by its angle
/// from straight down.
double apparentRise(double incidence) {
    constexpr double index = 1.333;
    const double sine = std::sin(incidence);
    return std::sqrt(index * index - sine * sine) / std::cos(incidence);
}

/// Of parallel lines of sight their own. Else half as far below the horizon as the view's steepest ray, for
/// far water shows little of its bed. 80 degrees at most, for a level one comes from endlessly high.
double typicalIncidence(const ViewGeometry& geometry) {
    constexpr double most = glm::radians(80.0);
    if (geometry.parallel) return std::min(std::acos(std::clamp(-geometry.sight.y, 0.0, 1.0)), most);
    double steepest = 0;
    for (int i = 0; i < 9; ++i) {
        const glm::dvec2 at = 0.5 * glm::dvec2(i % 3, i / 3) * glm::dvec2(geometry.regionSize);
        const glm::dvec4 p = geometry.relativeFromPixel * glm::dvec4(at, 0.5, 1);
        const glm::dvec3 ray = glm::normalize(glm::dvec3(p) / p.w);
        steepest = std::max(steepest, std::asin(std::clamp(-ray.y, -1.0, 1.0)));
    }
    return std::min(glm::radians(90.0) - 0.5 * steepest, most);
}

/// Raises the eye to `rise` times its height over `plane`, and squeezes what it sees towards the plane, whose
/// points all keep their pixels.
void raise(ViewDesc& view, const glm::dvec4& plane, double rise) {
    const glm::dmat4 before = toMatrix(view.view), projection = toMatrix(view.projection);
    const glm::dvec3 up(plane), eye(glm::inverse(before)[3]);
    const double less = 1 / rise - 1;
    glm::dmat4 squeezed(glm::dmat3(1) + less * glm::outerProduct(up, up));
    squeezed[3] = glm::dvec4(less * plane.w * up, 1);
    const glm::dmat4 after = glm::translate(before, (1 - rise) * (glm::dot(up, eye) + plane.w) * up);
    toValues(after, view.view);
    toValues(projection * before * squeezed * glm::inverse(after), view.projection);
}

/// Cuts what lies above `plane`, of the world; false where the eye is too close to it.
bool cutAbove(ViewDesc& view, bool reversedDepth, const glm::dvec4& plane) {
    const glm::dvec4 below = -(plane * glm::inverse(toMatrix(view.view)));
    const ObliqueProjection cut = obliqueProjection(toMatrix(view.projection), reversedDepth, below);
    toValues(cut.projection, view.projection);
    return cut.oblique;
}

} // namespace

Status BedPicture::create(const gpu::Device& device, const DrawnDesc& drawn, VkExtent2D extent) {
    if (const Status s = color.create(device, drawnColorDesc(drawn, extent), "bed"); s != Status::ok)
        return s;
    if (const Status s = depth.create(device, drawnDepthDesc(drawn, extent), "bed's depth"); s != Status::ok)
        return s;
    if (drawn.samples.depth == VK_SAMPLE_COUNT_1_BIT) return Status::ok;
    if (const Status s = firstDepth.create(device, firstDepthDesc(extent), "bed's depth"); s != Status::ok)
        return s;
    if (drawn.samples.color == VK_SAMPLE_COUNT_1_BIT) return Status::ok;
    return firstColor.create(device, firstColorDesc(extent), "bed");
}

Status Bed::create(Context& context, Bed& made) {
    const DrawnDesc& drawn = made.desc.drawn;
    if (const Status s = checkDrawn(context.device, drawn, "BedDesc"); s != Status::ok) return s;
    if (drawn.samples.depth != VK_SAMPLE_COUNT_1_BIT)
        if (const Status s = context.share(made.firstDepth); s != Status::ok) return s;
    return drawn.samples.color == VK_SAMPLE_COUNT_1_BIT ? Status::ok : context.share(made.firstColor);
}

Status Bed::handOut(Context& context, const ViewDesc& view, const ViewGeometry& geometry,
                    const glm::dvec4& plane, const BodyFrame& frame, PlanarView& out) {
    const gpu::Device& device = context.device;
    const glm::ivec2 margin = marginOf(desc, geometry.regionSize);
    ViewDesc wide = widened(view, geometry, margin, downscale);
    raise(wide, plane, glm::mix(1.0, apparentRise(typicalIncidence(geometry)), distortion));
    out.obliqueClip = cutAbove(wide, geometry.reversedDepth, plane);

    BedPicture& picture = views[view.viewIndex];
    ViewGeometry camera;
    if (const FieldError bad = readCamera(frame.fromWorld(wide), camera))
        return device.fail(Status::invalidArgument, "bedView: %s", bad.text());
    const VkExtent2D extent = extentOf(camera);
    if (!picture.color.isOf(extent)) {
        BedPicture fresh;
        if (const Status s = fresh.create(device, desc.drawn, extent); s != Status::ok) return s;
        context.frame().replace(picture, std::move(fresh));
    }
    camera.sceneShift = glm::dvec2(0.5) - samplePlace(desc.drawn.samples.depth);
    picture.camera = camera;
    picture.handedOut = true;

    std::copy_n(wide.view, 16, out.view);
    std::copy_n(wide.projection, 16, out.projection);
    out.windingFlipped = false;
    out.viewport = wide.viewport;
    setImages(picture.color, picture.depth, geometry.farDepth, out);
    return Status::ok;
}

Status Bed::take(Context& context, VkCommandBuffer commands, uint32_t viewIndex) {
    if (viewIndex >= maxViews) return Status::ok;
    BedPicture& picture = views[viewIndex];
    if (!std::exchange(picture.handedOut, false)) return Status::ok;
    const VkImageMemoryBarrier2 barriers[] = {colorDrawn(picture.color, gpu::sampledByShaders),
                                              depthDrawn(picture.depth)};
    gpu::recordBarriers(context.device, commands, barriers, 2);
    if (firstDepth)
        if (const Status s = takeFirstSamples(context, commands, picture); s != Status::ok) return s;
    picture.taken = context.frameNumber;
    return Status::ok;
}

Status Bed::takeFirstSamples(Context& context, VkCommandBuffer commands, const BedPicture& picture) const {
    const ViewGeometry& camera = picture.camera;
    const gpu::PassScope scope(context.device, commands, "bed_single_sample");
    const auto take = [&](const gpu::Kernel& kernel, const gpu::OwnedImage& to, const gpu::OwnedImage& from) {
        const Image image = {from.view(), from.desc().format, from.desc().extent,
                             gpu::sampledByShaders.layout, from.desc().samples};
        return recordFirstSample(context, commands, kernel, camera, to, image);
    };
    const Status s = take(firstDepth->kernel, picture.firstDepth, picture.depth);
    if (s != Status::ok || !firstColor) return s;
    return take(firstColor->kernel, picture.firstColor, picture.color);
}

const BedPicture* Bed::of(const Context& context, uint32_t viewIndex) const {
    if (viewIndex >= maxViews) return nullptr;
    const BedPicture& picture = views[viewIndex];
    return picture.taken == context.frameNumber ? &picture : nullptr;
}

VkExtent2D Bed::pictureExtent(const BedDesc& desc, uint32_t downscale, VkExtent2D view) {
    const glm::ivec2 size(static_cast<int>(view.width), static_cast<int>(view.height));
    const glm::dvec2 pixels = pixelsOf(size, marginOf(desc, size), downscale);
    return {static_cast<uint32_t>(pixels.x), static_cast<uint32_t>(pixels.y)};
}

namespace {

bool isMany(VkSampleCountFlagBits samples) {
    return samples != VK_SAMPLE_COUNT_1_BIT;
}

} // namespace

VkDeviceSize Bed::bytes(const gpu::Device& device, const BedDesc& desc, uint32_t downscale, VkExtent2D view) {
    const VkExtent2D extent = pictureExtent(desc, downscale, view);
    VkDeviceSize sum = gpu::heldBytes(device, drawnColorDesc(desc.drawn, extent)) +
                       gpu::heldBytes(device, drawnDepthDesc(desc.drawn, extent));
    if (isMany(desc.drawn.samples.depth)) sum += gpu::heldBytes(device, firstDepthDesc(extent));
    if (isMany(desc.drawn.samples.color)) sum += gpu::heldBytes(device, firstColorDesc(extent));
    return sum;
}

uint32_t Bed::dispatches(const BedDesc& desc) {
    return (isMany(desc.drawn.samples.depth) ? 1 : 0) + (isMany(desc.drawn.samples.color) ? 1 : 0);
}

} // namespace seaglass
