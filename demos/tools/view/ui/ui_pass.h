// Draws what Dear ImGui laid out, by dynamic rendering as the host's own passes: its own Vulkan backend of
// this version knows render passes alone, and calls functions that are linked, where the host's are loaded.
#pragma once

#include "host/vulkan/one_texture.h"

struct ImDrawData;

namespace demos {

class UiPass {
  public:
    /// After ImGui's context was made: its font becomes a texture. `target` is what it draws into.
    bool create(Device& device, VkFormat target, Error& error);
    /// Takes over a frame's layout, before any of it is recorded; the one before is done.
    bool upload(const ImDrawData& data, Error& error);
    /// Over an image that is an attachment, and stays one.
    void record(VkCommandBuffer commands, const ImDrawData& data, const Image& target) const;

  private:
    Device* device_ = nullptr;
    OneTexture drawing_; ///< of the font
    Image font_;
    Buffer vertices_, indices_;
};

} // namespace demos
