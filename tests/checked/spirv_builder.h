// Puts new instructions into a module: finds or makes the types and constants that they want.
#pragma once

#include <map>
#include <unordered_map>

#include "tests/checked/spirv_module.h"

namespace tests {

class SpirvBuilder {
  public:
    explicit SpirvBuilder(SpirvModule& module) : module_(module) {}

    /// Of the module's own instructions, in their order.
    void read(const Instruction& i);

    /// Ids.
    uint32_t type(uint32_t op, std::vector<uint32_t> operands = {});
    uint32_t boolType() { return type(op::TypeBool); }
    uint32_t uintType() { return type(op::TypeInt, {32, 0}); }
    /// The scalar type, or a vector of it with as many components as a type has.
    uint32_t like(uint32_t shape, uint32_t scalar);
    uint32_t vectorOf(uint32_t scalar, uint32_t count);
    uint32_t constant(uint32_t word);
    uint32_t constant(uint32_t type, uint32_t word); ///< of 32 bits, the same in each component
    uint32_t zeroVariable();                         ///< a private uint

    /// Null where an id names no type.
    const Instruction* typeNamed(uint32_t id) const;
    const Instruction& typeOf(uint32_t value) const { return types_.at(typeIdOf(value)); }
    uint32_t typeIdOf(uint32_t value) const { return typeOf_.at(value); }
    uint32_t components(uint32_t type) const;
    bool isFloat32(uint32_t type) const { return isScalar(type, op::TypeFloat, 32); }
    bool isInt32(uint32_t type) const { return isScalar(type, op::TypeInt, 32); }
    /// None where it is not known while building.
    std::optional<uint32_t> constantWord(uint32_t id) const;

    uint32_t put(uint32_t op, uint32_t type, std::vector<uint32_t> operands);
    void putVoid(uint32_t op, std::vector<uint32_t> operands) { out.push_back({op, std::move(operands)}); }

    std::vector<Instruction> out;     ///< where instructions are put
    std::vector<Instruction> globals; ///< to stand before the first function
    std::vector<uint32_t> variables;  ///< that entry points have to name

  private:
    bool isScalar(uint32_t type, uint32_t op, uint32_t width) const;

    SpirvModule& module_;
    std::unordered_map<uint32_t, Instruction> types_; ///< without the id
    std::map<std::vector<uint32_t>, uint32_t> typeIds_, constantIds_;
    std::unordered_map<uint32_t, uint32_t> typeOf_, words_;
};

} // namespace tests
