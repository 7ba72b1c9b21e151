#include "program/device/memory.h"

#include <cstdio>
#include <fstream>
#include <limits>

namespace demos {

namespace {

/// Linux says what could be had without swapping; elsewhere nothing is known, and nothing checked.
double availableBytes() {
    std::ifstream info("/proc/meminfo");
    for (std::string key, rest; info >> key && std::getline(info, rest);) {
        if (key == "MemAvailable:") return std::stod(rest) * 1024;
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

bool fitsMemory(const Size& size, double bytesAPixel, Error& error) {
    const double needed = bytesAPixel * size.width * size.height, available = availableBytes();
    if (needed <= available) return true;
    char text[160];
    std::snprintf(text, sizeof(text),
                  "--size is '%ux%u', which needs about %.1f GB, expected at most the %.1f GB free",
                  size.width, size.height, needed / 1e9, available / 1e9);
    error.text = text;
    return false;
}

} // namespace demos
