#include "tests/checked/spirv_builder.h"

namespace tests {

namespace {

constexpr uint32_t storagePrivate = 6;

std::vector<uint32_t> key(uint32_t op, std::span<const uint32_t> operands) {
    std::vector<uint32_t> out{op};
    out.insert(out.end(), operands.begin(), operands.end());
    return out;
}

} // namespace

void SpirvBuilder::read(const Instruction& i) {
    if (i.op >= op::TypeVoid && i.op <= op::TypeFunction) {
        const std::span<const uint32_t> rest = std::span(i.operands).subspan(1);
        types_[i[0]] = {i.op, {rest.begin(), rest.end()}};
        typeIds_.emplace(key(i.op, rest), i[0]);
        return;
    }
    // An operand that names a type is the first one, and the result the second.
    if (i.operands.size() < 2 || !types_.contains(i[0])) return;
    typeOf_[i[1]] = i[0];
    if (i.op != op::Constant || i.operands.size() != 3) return;
    words_[i[1]] = i[2];
    constantIds_.emplace(std::vector{i[0], i[2]}, i[1]);
}

uint32_t SpirvBuilder::type(uint32_t op, std::vector<uint32_t> operands) {
    const auto [at, isNew] = typeIds_.emplace(key(op, operands), 0);
    if (!isNew) return at->second;
    at->second = module_.newId();
    types_[at->second] = {op, operands};
    operands.insert(operands.begin(), at->second);
    globals.push_back({op, std::move(operands)});
    return at->second;
}

uint32_t SpirvBuilder::vectorOf(uint32_t scalar, uint32_t count) {
    return count == 1 ? scalar : type(op::TypeVector, {scalar, count});
}

uint32_t SpirvBuilder::like(uint32_t shape, uint32_t scalar) {
    return vectorOf(scalar, components(shape));
}

uint32_t SpirvBuilder::constant(uint32_t word) {
    return constant(uintType(), word);
}

uint32_t SpirvBuilder::constant(uint32_t type, uint32_t word) {
    const auto [at, isNew] = constantIds_.emplace(std::vector{type, word}, 0);
    if (!isNew) return at->second;
    uint32_t& id = at->second;
    const uint32_t count = components(type);
    if (count == 1) {
        id = module_.newId();
        globals.push_back({op::Constant, {type, id, word}});
        words_[id] = word;
    } else {
        const std::vector<uint32_t> each(count, constant(types_.at(type)[0], word));
        id = module_.newId();
        std::vector<uint32_t> operands{type, id};
        operands.insert(operands.end(), each.begin(), each.end());
        globals.push_back({op::ConstantComposite, std::move(operands)});
    }
    typeOf_[id] = type;
    return id;
}

uint32_t SpirvBuilder::zeroVariable() {
    const uint32_t pointer = type(op::TypePointer, {storagePrivate, uintType()});
    const uint32_t zero = constant(0);
    const uint32_t id = module_.newId();
    globals.push_back({op::Variable, {pointer, id, storagePrivate, zero}});
    variables.push_back(id);
    return id;
}

const Instruction* SpirvBuilder::typeNamed(uint32_t id) const {
    const auto at = types_.find(id);
    return at == types_.end() ? nullptr : &at->second;
}

uint32_t SpirvBuilder::components(uint32_t type) const {
    const Instruction& t = types_.at(type);
    return t.op == op::TypeVector ? t[1] : 1;
}

bool SpirvBuilder::isScalar(uint32_t type, uint32_t op, uint32_t width) const {
    const Instruction& t = types_.at(type);
    if (t.op == op::TypeVector) return isScalar(t[0], op, width);
    return t.op == op && t[0] == width;
}

std::optional<uint32_t> SpirvBuilder::constantWord(uint32_t id) const {
    const auto at = words_.find(id);
    return at == words_.end() ? std::nullopt : std::optional(at->second);
}

uint32_t SpirvBuilder::put(uint32_t op, uint32_t type, std::vector<uint32_t> operands) {
    const uint32_t id = module_.newId();
    operands.insert(operands.begin(), {type, id});
    out.push_back({op, std::move(operands)});
    typeOf_[id] = type;
    return id;
}

} // namespace tests
