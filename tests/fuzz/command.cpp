// Command lines: a word a line.
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "program/options.h"
#include "tests/fuzz/target.h"

namespace fuzz {

void readCommandLine(Bytes bytes) {
    constexpr size_t mostWords = 64;
    std::vector<std::string> words = {"seaglass"};
    words.emplace_back();
    for (const std::byte byte : bytes) {
        const char c = static_cast<char>(byte);
        if (c != '\n' && c != '\0')
            words.back() += c;
        else if (words.size() < mostWords)
            words.emplace_back();
    }
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());

    const std::ostringstream nowhere; // help is long
    std::streambuf* const out = std::cout.rdbuf(nowhere.rdbuf());
    demos::Error error;
    const auto options = demos::parseOptions(static_cast<int>(pointers.size()), pointers.data(), error);
    std::cout.rdbuf(out);
    if (!options && error.text.empty()) std::abort();
}

} // namespace fuzz
