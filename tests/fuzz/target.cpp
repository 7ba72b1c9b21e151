#include "tests/fuzz/target.h"

#include <algorithm>

namespace fuzz {

namespace {

constexpr Target all[] = {
    {"api", callApi},
    {"command", readCommandLine},
    {"compare", comparePictures},
    {"csv", readCsv},
    {"exr", readExr},
    {"gltf", readGltf},
    {"hdr", readHdr},
    {"png", readPng},
    {"scene", readScene},
};

} // namespace

std::span<const Target> targets() {
    return all;
}

Target find(std::string_view name) {
    const auto* const found = std::ranges::find(all, name, &Target::name);
    return found == std::end(all) ? Target{} : *found;
}

} // namespace fuzz
