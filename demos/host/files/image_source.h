// The one way in which pictures are read from files: the header first, so that nothing is allocated for what
// will be refused, then rows of linear Rec. 709 as they lie in the file.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "host/files/image_header.h"
#include "host/files/image_layers.h"
#include "scene/input_limits.h"

namespace demos {

/// Pixels of one row or column of the picture. The first is that of (x, y), each next one a step on.
struct ImageRow {
    std::span<const glm::vec4> rgba; ///< grey is spread; alpha is 1 where there is none
    int x = 0, y = 0, stepX = 1, stepY = 0;
};

/// How the error ends where a picture has more pixels than its file's bytes allow.
constexpr const char* unpacksFar = " pixels for so many bytes";

class ImageSource {
  public:
    /// Null with `error`, which names the file, for what is no flat picture of 1 to 16384 pixels each way,
    /// has more pixels than its bytes allow, or says of itself what would be read wrong.
    static std::optional<ImageSource> open(const std::filesystem::path& file, const LayerChoice& choice,
                                           const limits::Allowance& pixels, Error& error);
    ImageSource(ImageSource&&) noexcept;
    ~ImageSource();

    const ImageHeader& header() const;
    /// What lies outside of the display window is passed over.
    bool read(const std::function<void(const ImageRow&)>& visit, Error& error);

  private:
    struct Opened;
    explicit ImageSource(std::unique_ptr<Opened> opened);

    std::unique_ptr<Opened> opened_;
};

} // namespace demos
