#include "gpu/pipeline/specialized.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "gpu/pipeline/spirv_words.h"

namespace seaglass::gpu {

namespace {

using namespace spirv;

using Ids = std::unordered_set<uint32_t>;
using Values = std::unordered_map<uint32_t, uint32_t>;

bool isTerminator(Op op) {
    return (op >= opBranch && op <= opUnreachable) || op == opTerminateInvocation;
}

/// Of what stands in a function.
bool hasResult(Op op) {
    switch (op) {
    case opNop:
    case opLine:
    case opNoLine:
    case opStore:
    case opCopyMemory:
    case opImageWrite:
    case opControlBarrier:
    case opMemoryBarrier:
    case opAtomicStore:
    case opLoopMerge:
    case opSelectionMerge:
    case opLabel:
    case opDemote:
    case opFunctionEnd:
        return false;
    default:
        return !isTerminator(op);
    }
}

using Value = std::optional<uint32_t>;

/// Of two values that are both known.
Value valueOf(Op op, uint32_t a, uint32_t b) {
    const auto sa = static_cast<int32_t>(a), sb = static_cast<int32_t>(b);
    switch (op) {
    case opIAdd:
        return a + b;
    case opISub:
        return a - b;
    case opIMul:
        return a * b;
    case opBitwiseAnd:
        return a & b;
    case opLogicalOr:
        return a | b;
    case opLogicalAnd:
        return a & b;
    case opLogicalEqual:
    case opIEqual:
        return a == b;
    case opLogicalNotEqual:
    case opINotEqual:
        return a != b;
    case opUGreaterThan:
        return a > b;
    case opUGreaterThanEqual:
        return a >= b;
    case opULessThan:
        return a < b;
    case opULessThanEqual:
        return a <= b;
    case opSGreaterThan:
        return sa > sb;
    case opSGreaterThanEqual:
        return sa >= sb;
    case opSLessThan:
        return sa < sb;
    case opSLessThanEqual:
        return sa <= sb;
    default:
        return {};
    }
}

class Knowledge {
  public:
    Knowledge(std::span<const Instruction> head, std::span<const uint32_t> constants) {
        for (const Instruction i : head) learn(i, constants);
    }

    Value of(uint32_t id) const {
        const auto found = values_.find(id);
        return found == values_.end() ? Value() : Value(found->second);
    }
    void set(uint32_t id, uint32_t value) { values_[id] = value; }

    Value evaluate(Op op, Instruction operands) const {
        if (operands.empty()) return {};
        const Value a = of(operands[0]);
        if (op == opLogicalNot) return a ? Value(!*a) : a;
        if (operands.size() < 2) return {};
        const Value b = of(operands[1]);
        if (op == opSelect) return !a || operands.size() < 3 ? Value() : *a ? b : of(operands[2]);
        if (op == opLogicalAnd && ((a && !*a) || (b && !*b))) return 0;
        if (op == opLogicalOr && ((a && *a) || (b && *b))) return 1;
        return a && b ? valueOf(op, *a, *b) : Value();
    }

  private:
    void learn(Instruction i, std::span<const uint32_t> constants) {
        const auto specialised = [&](uint32_t usual) {
            const auto number = numbers_.find(i[2]);
            const bool given = number != numbers_.end() && number->second < constants.size();
            set(i[2], given ? constants[number->second] : usual);
        };
        switch (opOf(i)) {
        case opDecorate:
            if (i.size() == 4 && i[2] == decorationSpecId) numbers_[i[1]] = i[3];
            break;
        case opConstantTrue:
            set(i[2], 1);
            break;
        case opConstantFalse:
            set(i[2], 0);
            break;
        case opConstant:
            if (i.size() == 4) set(i[2], i[3]);
            break;
        case opSpecConstantTrue:
            specialised(1);
            break;
        case opSpecConstantFalse:
            specialised(0);
            break;
        case opSpecConstant:
            if (i.size() == 4) specialised(i[3]);
            break;
        case opSpecConstantOp:
            if (const Value v = evaluate(static_cast<Op>(i[3]), i.subspan(4))) set(i[2], *v);
            break;
        default:
            break;
        }
    }

    Values values_;
    Values numbers_; ///< of specialisation constants, by id
};

/// From a label to its terminator.
struct Block {
    std::span<const Instruction> code;
    bool live = false;
    uint32_t label() const { return code.front()[1]; }
};

struct Function {
    std::span<const Instruction> code; ///< from its head to its end
    std::span<const Instruction> head; ///< with its parameters
    std::vector<Block> blocks;
    bool live = false;
    uint32_t id() const { return code.front()[2]; }
};

Function functionOf(std::span<const Instruction> code) {
    Function f{code, code, {}, false};
    size_t start = code.size();
    for (size_t at = 0; at < code.size(); ++at) {
        if (opOf(code[at]) == opLabel) {
            if (f.blocks.empty()) f.head = code.first(at);
            start = at;
        } else if (start < at && isTerminator(opOf(code[at]))) {
            f.blocks.push_back({code.subspan(start, at + 1 - start), false});
            start = code.size();
        }
    }
    return f;
}

std::vector<uint32_t> targetsOf(Instruction end, const Knowledge& known) {
    switch (opOf(end)) {
    case opBranch:
        return {end[1]};
    case opBranchConditional: {
        const Value taken = known.of(end[1]);
        if (taken) return {*taken ? end[2] : end[3]};
        return {end[2], end[3]};
    }
    case opSwitch: {
        std::vector<uint32_t> all = {end[2]};
        for (size_t i = 4; i < end.size(); i += 2) all.push_back(end[i]);
        return all;
    }
    default:
        return {};
    }
}

/// Calls back with the ids that an instruction may use as pointers.
template<typename Use>
void forPointers(Instruction i, Use&& use) {
    const Op op = opOf(i);
    switch (op) {
    case opLoad:
    case opAccessChain:
    case opInBoundsAccessChain:
    case opArrayLength:
    case opImageTexelPointer:
    case opCopyObject:
        use(i[3]);
        return;
    case opStore:
    case opAtomicStore:
        use(i[1]);
        return;
    case opCopyMemory:
        use(i[1]);
        use(i[2]);
        return;
    case opFunctionCall:
        for (const uint32_t argument : i.subspan(4)) use(argument);
        return;
    case opExtInst:
        for (const uint32_t argument : i.subspan(5)) use(argument);
        return;
    default:
        if (op >= opAtomicLoad && op <= opAtomicXor) use(i[3]);
    }
}

/// What a shader is made of, and what of it is used.
struct Module {
    std::span<const Instruction> head; ///< all before the first function
    std::vector<Function> functions;
    Ids used; ///< variables
    Ids gone; ///< all else that is left out
};

Module moduleOf(std::span<const Instruction> list) {
    const auto first = std::ranges::find(list, opFunction, opOf);
    const auto heads = static_cast<size_t>(first - list.begin());
    Module module{list.first(heads), {}, {}, {}};
    for (size_t at = heads; at < list.size();) {
        size_t end = at;
        while (end + 1 < list.size() && opOf(list[end]) != opFunctionEnd) ++end;
        module.functions.push_back(functionOf(list.subspan(at, end + 1 - at)));
        at = end + 1;
    }
    return module;
}

/// Finds out which blocks constants let a shader reach, from its entry points on along calls.
class Reach {
  public:
    Reach(Module& module, const Knowledge& constants) : module_(module), constants_(constants) {
        for (Function& f : module.functions) byId_[f.id()] = &f;
        for (const Instruction i : module.head)
            if (opOf(i) == opEntryPoint) call(i[2]);
    }

  private:
    /// What it returns, if that hangs on constants alone. Shaders do not recurse.
    Value call(uint32_t id) {
        const auto found = byId_.find(id);
        if (found == byId_.end()) return {};
        const auto [entry, fresh] = returned_.try_emplace(id);
        if (!fresh) return entry->second;
        Function& function = *found->second;
        function.live = true;
        Knowledge known = constants_;
        const Value value = walk(function, known);
        return returned_[id] = value;
    }

    Value walk(Function& function, Knowledge& known) {
        const bool told = markLive(function, known);
        if (!told) {
            for (Block& block : function.blocks) {
                block.live = true;
                for (const Instruction i : block.code) use(i, known);
            }
            return {};
        }
        std::vector<Value> values;
        for (const Block& block : function.blocks)
            if (block.live && opOf(block.code.back()) == opReturnValue)
                values.push_back(known.of(block.code.back()[1]));
        const bool alike = !values.empty() && std::ranges::count(values, values.front()) ==
                                                  static_cast<std::ptrdiff_t>(values.size());
        return alike ? values.front() : Value();
    }

    /// False where one pass does not tell.
    bool markLive(Function& function, Knowledge& known) {
        std::unordered_map<uint32_t, size_t> places;
        for (size_t at = 0; at < function.blocks.size(); ++at) places[function.blocks[at].label()] = at;
        if (!function.blocks.empty()) function.blocks.front().live = true;
        for (size_t at = 0; at < function.blocks.size(); ++at) {
            if (!function.blocks[at].live) continue;
            for (const Instruction i : function.blocks[at].code) {
                if (opOf(i) == opPhi)
                    learnPhi(i, function, places, at, known);
                else
                    use(i, known);
            }
            for (const uint32_t target : targetsOf(function.blocks[at].code.back(), known)) {
                const size_t place = places[target];
                if (place <= at && !function.blocks[place].live) return false;
                function.blocks[place].live = true;
            }
        }
        return true;
    }

    /// Of what comes from blocks before it.
    static void learnPhi(Instruction phi, const Function& function,
                         const std::unordered_map<uint32_t, size_t>& places, size_t at, Knowledge& known) {
        std::optional<Value> all;
        for (size_t from = 4; from < phi.size(); from += 2) {
            const size_t place = places.at(phi[from]);
            if (place < at && !function.blocks[place].live) continue;
            const Value one = place < at ? known.of(phi[from - 1]) : Value();
            all = !all || *all == one ? one : Value();
            if (!*all) return;
        }
        if (all && *all) known.set(phi[2], **all);
    }

    void use(Instruction i, Knowledge& known) {
        forPointers(i, [&](uint32_t id) { module_.used.insert(id); });
        const Op op = opOf(i);
        const Value value = op == opFunctionCall            ? call(i[3])
                            : hasResult(op) && i.size() > 3 ? known.evaluate(op, i.subspan(3))
                                                            : Value();
        if (value) known.set(i[2], *value);
    }

    Module& module_;
    const Knowledge& constants_;
    std::unordered_map<uint32_t, Function*> byId_;
    std::unordered_map<uint32_t, Value> returned_;
};

/// Ids that what stays of a function still names, though their blocks are never reached.
Ids namedByRest(const Function& function) {
    Ids ids;
    for (const Block& block : function.blocks) {
        if (block.live) {
            for (const Instruction i : block.code)
                if (opOf(i) == opPhi)
                    for (size_t at = 3; at < i.size(); at += 2) ids.insert(i[at]);
        } else {
            const Instruction end = block.code.back();
            const Op op = opOf(end);
            if (op == opBranchConditional || op == opSwitch || op == opReturnValue) ids.insert(end[1]);
        }
    }
    return ids;
}

void append(std::vector<uint32_t>& out, Instruction words) {
    out.insert(out.end(), words.begin(), words.end());
}

void appendEmpty(const Block& block, const Ids& named, Ids& gone, std::vector<uint32_t>& out) {
    for (const Instruction i : block.code) {
        const Op op = opOf(i);
        if (op == opLabel || op == opLoopMerge || op == opSelectionMerge || isTerminator(op)) {
            append(out, i);
        } else if (hasResult(op) && named.contains(i[2])) {
            out.insert(out.end(), {3u << 16 | opUndef, i[1], i[2]});
        } else if (hasResult(op)) {
            gone.insert(i[2]);
        }
    }
}

void appendFunctions(Module& module, std::vector<uint32_t>& out) {
    for (const Function& f : module.functions) {
        if (!f.live) {
            for (const Instruction i : f.code) {
                if (hasResult(opOf(i))) module.gone.insert(i[2]);
                if (opOf(i) == opLabel) module.gone.insert(i[1]);
            }
            continue;
        }
        const Ids named = namedByRest(f);
        for (const Instruction i : f.head) append(out, i);
        for (const Block& block : f.blocks) {
            if (!block.live)
                appendEmpty(block, named, module.gone, out);
            else
                for (const Instruction i : block.code) append(out, i);
        }
        append(out, f.code.back());
    }
}

/// Its variables are listed behind its name, which is text.
void appendEntryPoint(Instruction words, const Ids& gone, std::vector<uint32_t>& out) {
    const size_t begin = out.size();
    const auto hasEnd = [](uint32_t word) {
        return (word & 0xffu) == 0 || (word & 0xff00u) == 0 || (word & 0xff0000u) == 0 || (word >> 24) == 0;
    };
    const auto nameEnds = std::find_if(words.begin() + 3, words.end(), hasEnd) + 1;
    out.insert(out.end(), words.begin(), nameEnds);
    std::copy_if(nameEnds, words.end(), std::back_inserter(out),
                 [&](uint32_t id) { return !gone.contains(id); });
    out[begin] = static_cast<uint32_t>(out.size() - begin) << 16 | opEntryPoint;
}

void appendHead(const Module& module, std::vector<uint32_t>& out) {
    const bool readsView = std::ranges::any_of(module.head, [&](Instruction i) {
        return opOf(i) == opDecorate && i.size() == 4 && i[2] == decorationBuiltIn &&
               i[3] == builtInViewIndex && !module.gone.contains(i[1]);
    });
    for (const Instruction i : module.head) {
        const Op op = opOf(i);
        const bool describes =
            op == opName || op == opMemberName || op == opDecorate || op == opMemberDecorate;
        if (describes && module.gone.contains(i[1])) continue;
        if (op == opVariable && module.gone.contains(i[2])) continue;
        if (op == opCapability && i[1] == capabilityMultiView && !readsView) continue; // it needs a feature
        if (op == opEntryPoint)
            appendEntryPoint(i, module.gone, out);
        else
            append(out, i);
    }
}

} // namespace

std::vector<uint32_t> specialized(std::span<const uint32_t> spirv, std::span<const uint32_t> constants) {
    const std::vector<Instruction> list = instructionsOf(spirv);
    Module module = moduleOf(list);
    const Knowledge known(module.head, constants);
    const Reach reach(module, known);
    for (const Instruction i : module.head)
        if (opOf(i) == opVariable && !module.used.contains(i[2])) module.gone.insert(i[2]);
    std::vector<uint32_t> functions;
    appendFunctions(module, functions);
    std::vector<uint32_t> out(spirv.begin(), spirv.begin() + headerWords);
    appendHead(module, out);
    append(out, functions);
    return out;
}

} // namespace seaglass::gpu
