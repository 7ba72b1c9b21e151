#include "gpu/without_binding.h"

#include <algorithm>

#include "gpu/spirv_words.h"

namespace seaglass::gpu {

namespace {

using namespace spirv;

/// 0: none, which is no id.
uint32_t variableAt(std::span<const Instruction> module, uint32_t binding) {
    for (const Instruction i : module)
        if (opOf(i) == opDecorate && i.size() == 4 && i[2] == decorationBinding && i[3] == binding)
            return i[1];
    return 0;
}

/// Of an opaque variable nothing but this is made.
bool loads(Instruction words, uint32_t variable) {
    return opOf(words) == opLoad && words[3] == variable;
}

/// Its variables are listed behind its name, which is text.
void appendEntryPoint(Instruction words, uint32_t without, std::vector<uint32_t>& out) {
    const size_t begin = out.size();
    out.insert(out.end(), words.begin(), words.end());
    const auto listed = std::find(out.begin() + static_cast<std::ptrdiff_t>(begin + 3), out.end(), without);
    if (listed != out.end()) out.erase(listed);
    out[begin] = static_cast<uint32_t>(out.size() - begin) << 16 | opEntryPoint;
}

/// `function`: from its head to its end.
void appendFunction(std::span<const Instruction> function, uint32_t without, std::vector<uint32_t>& out) {
    const bool reads = std::ranges::any_of(function, [&](Instruction i) { return loads(i, without); });
    bool hasLabel = false;
    for (const Instruction i : function) {
        const uint32_t op = opOf(i);
        const bool isHead = op == opFunction || op == opFunctionParameter;
        const bool isFirstLabel = op == opLabel && !hasLabel;
        if (reads && !isHead && !isFirstLabel && op != opFunctionEnd) continue;
        out.insert(out.end(), i.begin(), i.end());
        if (reads && isFirstLabel) out.push_back(1u << 16 | opUnreachable);
        hasLabel = hasLabel || op == opLabel;
    }
}

} // namespace

std::vector<uint32_t> withoutBinding(std::span<const uint32_t> spirv, uint32_t binding) {
    const std::vector<Instruction> list = instructionsOf(spirv);
    const std::span<const Instruction> module(list);
    const uint32_t id = variableAt(module, binding);
    if (id == 0) return {spirv.begin(), spirv.end()};
    std::vector<uint32_t> out(spirv.begin(), spirv.begin() + headerWords);
    for (size_t at = 0; at < module.size(); ++at) {
        const Instruction i = module[at];
        const uint32_t op = opOf(i);
        const bool describes = (op == opName || op == opDecorate) && i[1] == id;
        if (describes || (op == opVariable && i[2] == id)) continue;
        if (op == opEntryPoint) {
            appendEntryPoint(i, id, out);
        } else if (op == opFunction) {
            const size_t first = at;
            while (at + 1 < module.size() && opOf(module[at]) != opFunctionEnd) ++at;
            appendFunction(module.subspan(first, at + 1 - first), id, out);
        } else {
            out.insert(out.end(), i.begin(), i.end());
        }
    }
    return out;
}

} // namespace seaglass::gpu
