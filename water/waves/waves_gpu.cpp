#include "water/waves/waves_gpu.h"

#include <algorithm>
#include <array>
#include <complex>
#include <numbers>

#include "gpu/pipeline/constants.h"
#include "shaders/shared/waves_bindings.h"
#include "shaders/shared/waves_block.h"
#include "spirv/waves_columns.comp.h"
#include "spirv/waves_rows.comp.h"
#include "spirv/waves_rows_copied.comp.h"
#include "water/sea/phase.h"
#include "water/sea/sea.h"
#include "water/waves/wave_fields.h"

namespace seaglass {

namespace {

// Of transforms, in shaders/water/waves/fft.glsl.
constexpr uint32_t pointsHeld = 16; ///< by an invocation
constexpr uint32_t groupPoints = 1024;

/// How many transforms a group holds.
uint32_t linesHeld(uint32_t samples) {
    return std::max(groupPoints / samples, 1u);
}

struct WavesConstants {
#define CONSTANTS "shaders/shared/waves_constants.h"
#include "gpu/pipeline/constants.inl"
};

static_assert(std::size(WavesBlock{}.bands) == maxCascades);

uint32_t columnsOf(const Sea& sea, uint32_t band) {
    return static_cast<uint32_t>(sea.modes[band].reach) + 1;
}

uint32_t allColumns(const Sea& sea, uint32_t cascades) {
    uint32_t sum = 0;
    for (uint32_t c = 0; c < cascades; ++c) sum += columnsOf(sea, c);
    return sum;
}

size_t modeCount(const Sea& sea) {
    return size_t{allColumns(sea, sea.count)} * sea.desc.samples / 2;
}

VkDeviceSize amplitudeBytes(const Sea& sea) {
    constexpr VkDeviceSize alignment = 256; // the most that a device may ask of a storage buffer's offset
    return (modeCount(sea) * 4 * sizeof(float) + alignment - 1) / alignment * alignment;
}

VkDeviceSize modeBytes(const Sea& sea) {
    return amplitudeBytes(sea) + modeCount(sea) * sizeof(uint32_t);
}

VkDeviceSize columnBytes(const Sea& sea) {
    return VkDeviceSize{allColumns(sea, sea.count)} * waveColumnFields * sea.desc.samples * 2 * sizeof(float);
}

VkDeviceSize copiedBytes(const Sea& sea) {
    return WaveMaps::mip0Bytes(sea.desc.samples, sea.count);
}

constexpr VkBufferUsageFlags modeUsage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
constexpr VkBufferUsageFlags stagingUsage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
constexpr VkBufferUsageFlags columnUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
constexpr VkBufferUsageFlags copiedUsage =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;

/// h0(k) and conj(h0(-k)) of any k with m >= 0; in the half plane that is not stored they change places.
struct Amplitudes {
    std::complex<float> forward, backward;
    uint32_t frequency = 0;
};

Amplitudes amplitudesAt(const Modes& modes, int32_t m, int32_t n) {
    const bool stored = n > 0 || (n == 0 && m > 0);
    if (m > modes.reach || std::abs(n) > modes.reach || (m == 0 && n == 0)) return {};
    const size_t at = stored ? modes.at(m, n) : modes.at(-m, -n);
    const std::complex<float> forward(modes.forwardRe[at], modes.forwardIm[at]);
    const std::complex<float> backward(modes.backwardRe[at], modes.backwardIm[at]);
    if (stored) return {forward, backward, modes.frequency[at]};
    return {std::conj(backward), std::conj(forward), modes.frequency[at]};
}

/// In the order of shaders/water/waves/waves_columns.comp.
void writeModes(const Sea& sea, std::byte* out) {
    auto* amplitude = reinterpret_cast<float*>(out);
    auto* frequency = reinterpret_cast<uint32_t*>(out + amplitudeBytes(sea));
    const auto half = static_cast<int32_t>(sea.desc.samples / 2);
    for (uint32_t c = 0; c < sea.count; ++c)
        for (int32_t m = 0; m <= sea.modes[c].reach; ++m)
            for (int32_t slot = 0; slot < half; ++slot) {
                const Amplitudes a = amplitudesAt(sea.modes[c], m, slot < half / 2 ? slot : slot - half);
                const std::complex<float> sum = a.forward + a.backward, difference = a.forward - a.backward;
                for (const float value : {sum.real(), sum.imag(), difference.real(), difference.imag()})
                    *amplitude++ = value;
                *frequency++ = a.frequency;
            }
}

/// Of the first `cascades`.
WavesBlock blockOf(const Sea& sea, uint32_t cascades, const std::array<float, maxCascades>& packing,
                   double time) {
    WavesBlock block{};
    for (WaveBand& band : block.bands) band = {0, 1, ~0u, 0};
    block.now = loopPhase(time, sea.desc.loopPeriod);
    block.choppiness = sea.desc.choppiness;
    for (uint32_t c = 0; c < cascades; ++c) {
        block.bands[c].dk = static_cast<float>(2 * std::numbers::pi / sea.cascades[c].patch);
        block.bands[c].packing = packing[c];
        block.bands[c].firstColumn = block.allColumns;
        block.bands[c].columns = columnsOf(sea, c);
        block.allColumns += block.bands[c].columns;
    }
    return block;
}

constexpr gpu::BufferUse shaderRead = {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                       VK_ACCESS_2_SHADER_STORAGE_READ_BIT};
constexpr gpu::BufferUse shaderWritten = {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                          VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
constexpr gpu::BufferUse copyRead = {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr gpu::BufferUse modesCopied = {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};

/// Of a column's fields, how many a workgroup transforms: waves_columns.comp.
uint32_t fieldsAtOnce(const gpu::Device& device) {
    return device.isCpu() ? waveColumnFields : 1;
}

const gpu::Use& mapsFilled(const gpu::Device& device) {
    return device.isCpu() ? gpu::copyWritten : gpu::storageWritten;
}

/// What the rows' kernel stores a map to: the image, or its part of the buffer that is copied.
gpu::Resource mapResource(const WaveMaps& maps, uint32_t map, const gpu::Buffer& copied) {
    if (!copied.handle()) return gpu::storageImage(maps.images[map]);
    const VkDeviceSize bytes = copied.size() / waveMapCount;
    return gpu::storageBuffer(copied.handle(), bytes * map, bytes);
}

Status checkLimits(const gpu::Device& device, uint32_t samples, uint32_t invocations) {
    const VkDeviceSize shared = VkDeviceSize{invocations} * pointsHeld * 2 * sizeof(float);
    const VkPhysicalDeviceLimits& limits = device.limits();
    if (invocations <= limits.maxComputeWorkGroupInvocations &&
        invocations <= limits.maxComputeWorkGroupSize[0] && shared <= limits.maxComputeSharedMemorySize)
        return Status::ok;
    return device.fail(Status::unsupported,
                       "SeaDesc.samples is %u: workgroups need %u invocations and %llu shared bytes, the "
                       "device has %u and %u",
                       samples, invocations, static_cast<unsigned long long>(shared),
                       limits.maxComputeWorkGroupInvocations, limits.maxComputeSharedMemorySize);
}

/// Of what kernels read and write by one binding.
Status checkBindings(const gpu::Device& device, const Sea& sea) {
    const VkDeviceSize map = device.isCpu() ? copiedBytes(sea) / waveMapCount : 0;
    const VkDeviceSize wanted = std::max({modeBytes(sea), columnBytes(sea), map});
    if (wanted <= device.limits().maxStorageBufferRange) return Status::ok;
    return device.fail(
        Status::unsupported,
        "SeaDesc.samples is %u: %u cascades need a storage buffer of %llu bytes, the device has %u",
        sea.desc.samples, sea.count, static_cast<unsigned long long>(wanted),
        device.limits().maxStorageBufferRange);
}

} // namespace

Status buildWaves(const gpu::Device& device, const uint32_t& samples, WavePair& out) {
    const bool copied = device.isCpu();
    const uint32_t rowGroups = copied ? 1 : 2;
    WavesConstants given;
    given.samples = samples;
    given.onCpu = copied;
    given.invocations = linesHeld(samples) * samples / pointsHeld;
    if (const Status s = checkLimits(device, samples, given.invocations * rowGroups); s != Status::ok)
        return s;
    if (const Status s =
            out.columns.create(device, waves_columns_comp, "waves columns pipeline", given.constants());
        s != Status::ok)
        return s;
    given.invocations *= rowGroups;
    const std::span<const uint32_t> stores(waves_rows_comp), isCopied(waves_rows_copied_comp);
    return out.rows.create(device, copied ? isCopied : stores, "waves rows pipeline", given.constants());
}

VkImageUsageFlags ComputedWaves::mapUsage(const gpu::Device& device) {
    return device.isCpu() ? VK_IMAGE_USAGE_TRANSFER_DST_BIT : VK_IMAGE_USAGE_STORAGE_BIT;
}

VkDeviceSize ComputedWaves::bytes(const gpu::Device& device, const Sea& sea) {
    const VkDeviceSize copied = device.isCpu() ? copiedBytes(sea) : 0;
    return gpu::heldBytes(device, modeBytes(sea), modeUsage) +
           gpu::heldBytes(device, modeBytes(sea), stagingUsage) +
           gpu::heldBytes(device, columnBytes(sea), columnUsage) +
           gpu::heldBytes(device, copied, copiedUsage);
}

Status ComputedWaves::create(Context& context, const Sea& sea) {
    sea_ = &sea;
    if (const Status s = checkBindings(context.device, sea); s != Status::ok) return s;
    for (uint32_t c = 0; c < sea.count; ++c) packing_[c] = wavePacking(sea.modes[c]);
    if (const Status s = context.share(kernels_); s != Status::ok) return s;
    const WavePair* built = nullptr;
    if (const Status s = kernels_->get(sea.desc.samples, built); s != Status::ok) return s;
    const VkDeviceSize bytes = modeBytes(sea);
    if (const Status s = modes_.create(context.device, bytes, modeUsage, "wave modes"); s != Status::ok)
        return s;
    if (const Status s =
            staging_.createMapped(context.device, bytes, stagingUsage, "wave modes staging buffer");
        s != Status::ok)
        return s;
    writeModes(sea, static_cast<std::byte*>(staging_.mapped()));
    if (context.device.isCpu())
        if (const Status s = copied_.create(context.device, copiedBytes(sea), copiedUsage, "wave map buffer");
            s != Status::ok)
            return s;
    return columns_.create(context.device, columnBytes(sea), columnUsage, "wave columns");
}

Status ComputedWaves::describe(Context& context, const WaveMaps& maps, const WavePair& kernels,
                               uint32_t cascades, double time, Sets& out) const {
    const WavesBlock block = blockOf(*sea_, cascades, packing_, time);
    gpu::Slice slice;
    if (const Status s = context.frame().upload(block, slice); s != Status::ok) return s;
    const gpu::Resource uniform = gpu::uniformBuffer(slice);
    const gpu::Resource columns = gpu::storageBuffer(columns_.handle());
    const VkDeviceSize split = amplitudeBytes(*sea_);
    const gpu::Bound ofColumns[] = {
        {wavesBinding, uniform},
        {amplitudesBinding, gpu::storageBuffer(modes_.handle(), 0, split)},
        {frequenciesBinding, gpu::storageBuffer(modes_.handle(), split, modes_.size() - split)},
        {columnsBinding, columns},
    };
    const gpu::Bound ofRows[] = {
        {wavesBinding, uniform},
        {columnsBinding, columns},
        {displacementMapBinding, mapResource(maps, 0, copied_)},
        {derivativeMapBinding, mapResource(maps, 1, copied_)},
        {momentMapBinding, mapResource(maps, 2, copied_)},
    };
    if (const Status s = context.frame().allocateSet(kernels.columns.layout(), ofColumns, out.columns);
        s != Status::ok)
        return s;
    return context.frame().allocateSet(kernels.rows.layout(), ofRows, out.rows);
}

void ComputedWaves::recordUpload(Context& context, VkCommandBuffer commands) {
    if (uploaded_) return;
    uploaded_ = true;
    const VkBufferCopy region{0, 0, modes_.size()};
    context.device.vk().CmdCopyBuffer(commands, staging_.handle(), modes_.handle(), 1, &region);
    gpu::recordBarrier(context.device, commands, modesCopied, shaderRead);
    context.frame().retire(std::move(staging_));
}

Status ComputedWaves::record(Context& context, VkCommandBuffer commands, const WaveMaps& maps, double time) {
    if (const Status s = recordMaps(context, commands, maps, sea_->count, time); s != Status::ok) return s;
    return maps.recordMips(context, commands, mapsFilled(context.device));
}

Status ComputedWaves::recordFirst(Context& context, VkCommandBuffer commands, const WaveMaps& maps,
                                  uint32_t cascades, double time) {
    if (const Status s = recordMaps(context, commands, maps, cascades, time); s != Status::ok) return s;
    maps.recordNoMips(context.device, commands, mapsFilled(context.device));
    return Status::ok;
}

Status ComputedWaves::recordMaps(Context& context, VkCommandBuffer commands, const WaveMaps& maps,
                                 uint32_t cascades, double time) {
    const gpu::Device& device = context.device;
    const WavePair* kernels = nullptr;
    Sets sets;
    if (const Status s = kernels_->get(maps.samples, kernels); s != Status::ok) return s;
    if (const Status s = describe(context, maps, *kernels, cascades, time, sets); s != Status::ok) return s;

    recordUpload(context, commands);
    const uint32_t lines = linesHeld(maps.samples);
    const auto groups = [lines](uint32_t all) { return (all + lines - 1) / lines; };
    {
        const gpu::PassScope pass(device, commands, "waves");
        const gpu::BufferUse lastRead = {shaderRead.stage | copyRead.stage, VK_ACCESS_2_NONE};
        gpu::recordBarrier(device, commands, lastRead, shaderWritten);
        kernels->columns.dispatch(commands, sets.columns, groups(allColumns(*sea_, cascades)),
                                  waveColumnFields / fieldsAtOnce(device));
        maps.recordBegin(device, commands, mapsFilled(device));
        gpu::recordBarrier(device, commands, shaderWritten, shaderRead);
        kernels->rows.dispatch(commands, sets.rows, groups(maps.samples), cascades);
    }
    if (device.isCpu()) {
        const gpu::PassScope pass(device, commands, "waves_copy");
        gpu::recordBarrier(device, commands, shaderWritten, copyRead);
        maps.recordCopy(device, commands, copied_.handle(), cascades);
    }
    return Status::ok;
}

} // namespace seaglass
