#include "reflection/after/temporal.h"

#include <algorithm>
#include <cstddef>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "reflection/core/mirror.h"
#include "reflection/planar/planar.h"
#include "shaders/shared/reflection_bindings.h"
#include "shaders/shared/temporal_block.h"
#include "spirv/temporal.comp.h"

namespace seaglass {

namespace {

glm::dmat4 movedBy(const glm::dvec3& offset) {
    return glm::translate(glm::dmat4(1), offset);
}

LastFrame frameOf(const ReflectPass& pass) {
    const ViewGeometry& view = pass.geometry;
    LastFrame frame;
    frame.count = 1;
    frame.bent = pass.view.surfaceNormals != nullptr;
    frame.eye = view.eye;
    frame.facing = glm::dvec3(planeFacing(pass.plane, view));
    frame.pixelFromRelative = movedBy({-view.jitter, 0}) * view.pixelFromRelative;
    frame.reversedDepth = view.reversedDepth;
    return frame;
}

/// Whether the one can be looked up in the other.
bool follows(const LastFrame& frame, const LastFrame& last) {
    return last.count > 0 && frame.bent == last.bent && frame.reversedDepth == last.reversedDepth &&
           frame.facing == last.facing;
}

TemporalBlock blockOf(const ReflectPass& pass, const LastFrame& last) {
    TemporalBlock out{};
    const glm::dvec3 moved = pass.geometry.eye - last.eye;
    out.lastFromRelative = glm::mat4(last.pixelFromRelative * movedBy(moved));
    out.relativeFromLast = glm::mat4(movedBy(-moved) * glm::inverse(last.pixelFromRelative));
    out.jitter = glm::vec2(pass.geometry.jitter);
    // The mean of the first frames, until that is steadier than what is asked for.
    const auto count = static_cast<float>(last.count);
    out.share = std::min(pass.desc.temporal, count / (count + 1));
    out.kept = pass.desc.temporal;
    return out;
}

} // namespace

Status TemporalKernel::create(Context& context) {
    if (const Status s = columns.create(context); s != Status::ok) return s;
    if (const Status s = shareUnseenTiles(context, unseen); s != Status::ok) return s;
    return kernel.create(context.device, temporal_comp, "temporal pipeline");
}

Status TemporalScratch::create(const gpu::Device& device, VkExtent2D extent, const ReflectionDesc& desc) {
    if (const Status s = found.create(device, extent, 0, drawnInPlace(desc)); s != Status::ok) return s;
    return other.create(device, extent, desc.blurLevels, false);
}

VkDeviceSize TemporalScratch::bytes(const gpu::Device& device, VkExtent2D extent,
                                    const ReflectionDesc& desc) {
    return OwnedReflection::bytes(device, extent, 0, drawnInPlace(desc)) +
           OwnedReflection::bytes(device, extent, desc.blurLevels, false);
}

Status recordTemporal(const ReflectPass& pass, const TemporalKernel& temporal, const gpu::Buffer& tiles,
                      TemporalScratch& scratch, OwnedReflection& images) {
    Context& context = pass.context;
    LastFrame frame = frameOf(pass);
    const bool known = !pass.view.cut && follows(frame, scratch.last);
    const TemporalBlock block = known ? blockOf(pass, scratch.last) : TemporalBlock{};
    if (known) frame.count += std::min(scratch.last.count, 1000u);
    // Until all is recorded there is none.
    scratch.last = {};
    std::swap(scratch.other, images);

    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;
    const VkSampler nearest = context.samplers.nearestClamp();
    const OwnedReflection& found = scratch.found;
    // What nobody reads needs something to point at.
    const OwnedReflection& last = known ? scratch.other : found;
    const gpu::Bound resources[] = {
        {mirrorBinding, gpu::uniformBuffer(pass.mirror)},
        {settingsBinding, gpu::uniformBuffer(slice)},
        {foundColorBinding, gpu::sampledImage(nearest, found.color.view())},
        {foundInfoBinding, gpu::sampledImage(nearest, found.info.view())},
        {lastColorBinding, gpu::sampledImage(nearest, last.color.view())},
        {lastInfoBinding, gpu::sampledImage(nearest, last.info.view())},
        {reflectionColorBinding, gpu::storageImage(images.color)},
        {reflectionInfoBinding, gpu::storageImage(images.info)},
        {tilesBinding, gpu::storageBuffer(tiles.handle())},
    };
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (const Status s = context.frame().allocateSet(temporal.kernel.layout(), resources, set);
        s != Status::ok)
        return s;
    if (const Status s = recordUnseenTiles(pass, temporal.unseen.get(), tiles, images); s != Status::ok)
        return s;
    const gpu::PassScope scope(context.device, pass.commands, "reflection_temporal");
    if (const Status s = recordSeenColumns(pass, temporal.columns, tiles); s != Status::ok) return s;
    const VkImageMemoryBarrier2 read =
        gpu::imageBarrier(found.color.handle(), gpu::storageWritten, gpu::sampledByShaders);
    gpu::recordBarriers(context.device, pass.commands, &read, 1);
    temporal.kernel.dispatchIndirect(pass.commands, set, tiles.handle(), offsetof(TileHeader, columnGroups));
    images.recordInfoSampled(context.device, pass.commands);
    scratch.last = frame;
    return Status::ok;
}

} // namespace seaglass
