// What is fuzzed: each takes bytes that anybody may have made, and must come back from them.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace fuzz {

using Bytes = std::span<const std::byte>;

struct Target {
    const char* name; ///< of its folder in corpus/
    void (*run)(Bytes bytes);
};

/// By name; `run` is null where there is none.
Target find(std::string_view name);
std::span<const Target> targets();

void callApi(Bytes bytes);
void readCommandLine(Bytes bytes);
void comparePictures(Bytes bytes);
void readCsv(Bytes bytes);
void readExr(Bytes bytes);
void readGltf(Bytes bytes);
void readHdr(Bytes bytes);
void readPng(Bytes bytes);
void readScene(Bytes bytes);

} // namespace fuzz
