#include "measure/page/contact_sheet.h"

#include <algorithm>

namespace demos::measure {

namespace {
constexpr uint32_t columns = 2, gap = 4;
} // namespace

ContactSheet contactSheet(const ViewResult& view, uint32_t width, uint32_t height) {
    const auto count = static_cast<uint32_t>(view.pictures.size()) + 1;
    const uint32_t rows = (count + columns - 1) / columns;
    ContactSheet out;
    out.width = columns * width + (columns - 1) * gap;
    out.height = rows * height + (rows - 1) * gap;
    out.rgb.assign(size_t{out.width} * out.height * 3, 27);
    for (uint32_t i = 0; i < count; ++i) {
        const std::vector<uint8_t>& rgb = i == 0 ? view.reference : view.pictures[i - 1];
        const size_t x = size_t{i % columns} * (width + gap), y = size_t{i / columns} * (height + gap);
        for (size_t row = 0; row < height; ++row)
            std::copy_n(&rgb[row * width * 3], size_t{width} * 3, &out.rgb[((y + row) * out.width + x) * 3]);
    }
    return out;
}

} // namespace demos::measure
