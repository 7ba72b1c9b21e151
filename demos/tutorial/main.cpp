// tutorial OUT.ppm [WIDTH HEIGHT]: draws a few frames and saves the last.
#include <cstdio>
#include <cstdlib>

#include "engine.h"

namespace {

/// 0 for what is not a size.
uint32_t readSize(const char* text) {
    const long value = std::strtol(text, nullptr, 10);
    return value > 0 && value <= 4096 ? static_cast<uint32_t>(value) : 0;
}

} // namespace

int main(int argc, char** argv) {
    VkExtent2D extent{1280, 720};
    if (argc == 4) extent = {readSize(argv[2]), readSize(argv[3])};
    if ((argc != 2 && argc != 4) || extent.width == 0 || extent.height == 0) {
        std::fprintf(stderr, "usage: tutorial OUT.ppm [WIDTH HEIGHT]\n");
        return 2;
    }
    Engine engine(extent);
    for (int frame = 0; frame < 5; ++frame) engine.draw();
    engine.savePicture(argv[1]);
    return 0;
}
