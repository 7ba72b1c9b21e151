// The picture as a display shows it: light and other outputs brought to 8 bits on the device, as the
// program's PNGs are on the CPU.
#pragma once

#include "host/host.h"
#include "host/vulkan/one_texture.h"

namespace demos {

/// How values become colours; shaders/display.frag knows them by their numbers.
enum class Tone : uint32_t {
    light,      ///< tone-mapped, `scale` applied before
    asIs,       ///< colours already
    grey,       ///< the first channel
    signedGrey, ///< the first channel around mid grey, black and white at -scale and scale
    direction,  ///< a normal, black where there is none
};

/// How an output is shown, with an exposure for light and what is white of a height.
struct Look {
    Tone tone = Tone::light;
    float scale = 1;
};
Look lookOf(Aov aov, double exposureEv, double whiteHeightM);

class Display {
  public:
    static constexpr VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;

    bool create(Device& device, Error& error);
    /// Anew, with nothing in it, where the size is another.
    bool resize(VkExtent2D extent, Error& error);

    /// Draws over a part of it what attachments wrote into a picture of the same size.
    void show(VkCommandBuffer commands, const Image& picture, const Look& look, const VkRect2D& part);
    /// The same of a picture that shaders read already.
    void showTexture(VkCommandBuffer commands, const Image& picture, const Look& look, const VkRect2D& part);
    /// Leaves it as what copies read.
    void finish(VkCommandBuffer commands);
    const Image& image() const { return image_; }

    /// RGB bytes, rows from the top, of what finish() left.
    bool read(std::vector<uint8_t>& rgb, Error& error);

  private:
    Device* device_ = nullptr;
    OneTexture drawing_; ///< of a picture
    Image image_;
    VkImageLayout now_ = VK_IMAGE_LAYOUT_UNDEFINED;
};

} // namespace demos
