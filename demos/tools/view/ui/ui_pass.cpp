#include "view/ui/ui_pass.h"

#include <algorithm>
#include <cstring>

#include <imgui.h>

#include "host/vulkan/rendering.h"
#include "spirv/ui.frag.h"
#include "spirv/ui.vert.h"

namespace demos {

namespace {

constexpr VkPipelineStageFlags2 colorOutput = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;

constexpr VkVertexInputBindingDescription binding = {0, sizeof(ImDrawVert), VK_VERTEX_INPUT_RATE_VERTEX};
constexpr VkVertexInputAttributeDescription attributes[] = {
    {0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, pos)},
    {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, uv)},
    {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ImDrawVert, col)},
};

/// As in shaders/ui.vert.
struct UiConstants {
    float scale[2], offset[2];
};

bool grow(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, Buffer& out, Error& error) {
    if (bytes <= out.size) return true;
    out = {};
    return createBuffer(device, bytes + bytes / 2, usage, BufferPlace::upload, out, error);
}

/// Empty where nothing of it is within the picture.
VkRect2D scissorOf(const ImDrawCmd& command, VkExtent2D extent) {
    const auto within = [](float at, uint32_t size) {
        return static_cast<int32_t>(std::clamp(at, 0.0f, static_cast<float>(size)));
    };
    const int32_t left = within(command.ClipRect.x, extent.width);
    const int32_t top = within(command.ClipRect.y, extent.height);
    const int32_t right = within(command.ClipRect.z, extent.width);
    const int32_t bottom = within(command.ClipRect.w, extent.height);
    return {
        {left, top},
        {static_cast<uint32_t>(std::max(right - left, 0)), static_cast<uint32_t>(std::max(bottom - top, 0))}};
}

} // namespace

bool UiPass::create(Device& device, VkFormat target, Error& error) {
    device_ = &device;
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImageDesc font;
    font.format = VK_FORMAT_R8G8B8A8_UNORM;
    font.extent = {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
    const std::span<const std::byte> level =
        std::as_bytes(std::span(pixels, size_t(4) * font.extent.width * font.extent.height));
    if (!createSampledImage(device, font, {&level, 1}, font_, error)) return false;
    VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &binding;
    input.vertexAttributeDescriptionCount = 3;
    input.pVertexAttributeDescriptions = attributes;
    PipelineDesc desc;
    desc.vertex = ui_vert;
    desc.fragment = ui_frag;
    desc.meshVertices = false;
    desc.vertices = &input;
    desc.blends = true;
    desc.colorFormat = target;
    if (!drawing_.create(device, desc, sizeof(UiConstants), error)) return false;
    drawing_.point(device, font_.view.get());
    return true;
}

bool UiPass::upload(const ImDrawData& data, Error& error) {
    const auto vertexCount = static_cast<size_t>(data.TotalVtxCount);
    const auto indexCount = static_cast<size_t>(data.TotalIdxCount);
    if (!grow(*device_, vertexCount * sizeof(ImDrawVert), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, vertices_,
              error) ||
        !grow(*device_, indexCount * sizeof(ImDrawIdx), VK_BUFFER_USAGE_INDEX_BUFFER_BIT, indices_, error))
        return false;
    auto* vertex = static_cast<ImDrawVert*>(vertices_.mapped);
    auto* index = static_cast<ImDrawIdx*>(indices_.mapped);
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        vertex = std::copy_n(list.VtxBuffer.Data, list.VtxBuffer.Size, vertex);
        index = std::copy_n(list.IdxBuffer.Data, list.IdxBuffer.Size, index);
    }
    return true;
}

void UiPass::record(VkCommandBuffer commands, const ImDrawData& data, const Image& target) const {
    if (data.TotalVtxCount == 0) return;
    imageBarrier(commands, target, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                 VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, colorOutput,
                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, colorOutput,
                 VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
    beginRendering(commands, target.extent, target.view.get(), VK_ATTACHMENT_LOAD_OP_LOAD, VK_NULL_HANDLE,
                   VK_ATTACHMENT_LOAD_OP_DONT_CARE, 0);
    drawing_.bind(commands);
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices_.buffer.get(), &offset);
    vkCmdBindIndexBuffer(commands, indices_.buffer.get(), 0,
                         sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
    const UiConstants constants = {{2 / data.DisplaySize.x, 2 / data.DisplaySize.y}, {-1, -1}};
    drawing_.push(commands, std::as_bytes(std::span(&constants, 1)));
    uint32_t firstIndex = 0;
    int32_t firstVertex = 0;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const VkRect2D scissor = scissorOf(command, target.extent);
            if (scissor.extent.width == 0 || scissor.extent.height == 0) continue;
            vkCmdSetScissor(commands, 0, 1, &scissor);
            vkCmdDrawIndexed(commands, command.ElemCount, 1, firstIndex + command.IdxOffset,
                             firstVertex + static_cast<int32_t>(command.VtxOffset), 0);
        }
        firstIndex += static_cast<uint32_t>(list.IdxBuffer.Size);
        firstVertex += list.VtxBuffer.Size;
    }
    vkCmdEndRendering(commands);
}

} // namespace demos
