#include "tests/checked/spirv_module.h"

#include <cstring>

namespace tests {

namespace {

constexpr size_t headerWords = 5;

} // namespace

std::vector<uint32_t> SpirvModule::words() const {
    std::vector<uint32_t> out = header;
    for (const Instruction& i : instructions) {
        out.push_back(static_cast<uint32_t>(i.operands.size() + 1) << 16 | i.op);
        out.insert(out.end(), i.operands.begin(), i.operands.end());
    }
    return out;
}

std::optional<SpirvModule> readSpirv(std::span<const uint32_t> words) {
    if (words.size() < headerWords || words[0] != 0x07230203) return std::nullopt;
    SpirvModule module;
    module.header.assign(words.begin(), words.begin() + headerWords);
    for (size_t at = headerWords; at < words.size();) {
        const size_t count = words[at] >> 16;
        if (count == 0 || at + count > words.size()) return std::nullopt;
        const std::span<const uint32_t> operands = words.subspan(at + 1, count - 1);
        module.instructions.push_back({words[at] & 0xffffu, {operands.begin(), operands.end()}});
        at += count;
    }
    return module;
}

std::vector<uint32_t> literal(const std::string& text) {
    std::vector<uint32_t> words(text.size() / sizeof(uint32_t) + 1);
    std::memcpy(words.data(), text.data(), text.size());
    return words;
}

std::string text(std::span<const uint32_t> literal) {
    std::string out(literal.size_bytes(), '\0');
    std::memcpy(out.data(), literal.data(), out.size());
    return out.substr(0, out.find('\0'));
}

} // namespace tests
