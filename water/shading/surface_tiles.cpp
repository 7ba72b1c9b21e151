#include "water/shading/surface_tiles.h"

#include "spirv/surface_tiles.comp.h"

namespace seaglass {

namespace {

constexpr VkBufferUsageFlags tilesUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                          VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                          VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

/// Of the lists, of what each tile needs, and of what each group of 64 has.
VkDeviceSize tilesBytes(VkExtent2D extent) {
    const VkDeviceSize tiles = tileCount(extent, 1), groups = (tiles + 63) / 64;
    return sizeof(FoundTilesHeader) + sizeof(uint32_t) * (tiles * (foundLists + 1) + groups * foundLists);
}

} // namespace

uint32_t tileCount(VkExtent2D view, uint32_t pixelsPerShading) {
    const uint32_t width = 8 * pixelsPerShading;
    return (view.width + width - 1) / width * ((view.height + 7) / 8);
}

bool TileSorting::uses(uint32_t list) const {
    const auto maybe = [&](uint32_t need, bool has, bool sorted) {
        return list & need ? has : !has || sorted;
    };
    return maybe(foundMirrors, hasReflection, mirrors) && maybe(foundSeesBed, hasRefraction, bed);
}

TileSorting tileSorting(const SurfaceVariant& variant) {
    TileSorting sorting{.hasReflection = variant.hasReflection,
                        .hasRefraction = variant.hasRefraction,
                        .pixelsPerShading = variant.pixelsPerShading};
    // How slopes turn rays is told of flat seas, of the eye above them, and of light alone.
    if (variant.onGlobe || variant.sidesSeen != static_cast<uint32_t>(SidesSeen::above) ||
        variant.surfaceOutput != static_cast<uint32_t>(SurfaceOutput::shaded))
        return sorting;
    sorting.mirrors = variant.hasReflection;
    sorting.bed = variant.hasRefraction && variant.bedDownscale == 0 && !variant.hasShore;
    return sorting;
}

Status buildListing(const gpu::Device& device, const TileSorting& sorting, TilesKernels& out) {
    TilesConstants constants;
    constants.hasReflection = sorting.hasReflection;
    constants.hasRefraction = sorting.hasRefraction;
    constants.sortsMirrors = sorting.mirrors;
    constants.sortsBed = sorting.bed;
    constants.pixelsPerShading = sorting.pixelsPerShading;
    for (uint32_t step = 0; step < out.size(); ++step) {
        constants.listingStep = step;
        if (const Status s =
                out[step].create(device, surface_tiles_comp, "surface tiles", constants.constants());
            s != Status::ok)
            return s;
    }
    return Status::ok;
}

Status SurfaceTiles::create(const gpu::Device& device, VkExtent2D extent) {
    return buffer_.create(device, tilesBytes(extent), tilesUsage, "surface tiles");
}

VkDeviceSize SurfaceTiles::bytes(const gpu::Device& device, VkExtent2D extent) {
    return gpu::heldBytes(device, tilesBytes(extent), tilesUsage);
}

VkDeviceSize SurfaceTiles::groupsOffset(uint32_t list) {
    return offsetof(FoundTilesHeader, groups) + list * sizeof(FoundTilesHeader::groups[0]);
}

Status SurfaceTiles::record(Context& context, VkCommandBuffer commands, const TilesKernels& kernels,
                            const Resources& resources, uint32_t tiles) const {
    const gpu::Device& device = context.device;
    std::array<VkDescriptorSet, std::tuple_size_v<TilesKernels>> sets{};
    for (size_t step = 0; step < sets.size(); ++step)
        if (const Status s = context.frame().allocateSet(kernels[step].layout(), resources, sets[step]);
            s != Status::ok)
            return s;
    const gpu::PassScope pass(device, commands, "surface_tiles");
    gpu::recordBuffersCleared(device, commands, {buffer_.handle()}, sizeof(FoundTilesHeader));
    for (size_t step = 0; step < sets.size(); ++step) {
        kernels[step].dispatchAlong(commands, sets[step], tiles);
        gpu::recordBarrier(device, commands,
                           {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                            VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT},
                           {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
                            VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
                                VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT});
    }
    return Status::ok;
}

} // namespace seaglass
