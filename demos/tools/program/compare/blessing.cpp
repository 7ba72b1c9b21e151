#include "program/compare/blessing.h"

namespace demos {

namespace {

/// Quoted where a shell would take it for more than a word.
std::string shellWord(const std::string& text) {
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./@%:=,";
    if (!text.empty() && text.find_first_not_of(plain) == text.npos) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

} // namespace

std::string blessing(const std::filesystem::path& reference, const std::filesystem::path& test,
                     const std::string& what) {
    return "seaglass bless " + shellWord(reference.string()) + " " + shellWord(test.string()) + " " +
           shellWord(what);
}

} // namespace demos
