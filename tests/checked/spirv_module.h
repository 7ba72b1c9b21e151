// SPIR-V as a list of instructions, as tests/spirv/module.py has it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tests {

/// Those that checked_shader.cpp reads or writes; numbers as in the SPIR-V specification, 3.52.
namespace op {
enum : uint32_t {
    Name = 5,
    String = 7,
    Line = 8,
    Extension = 10,
    ExtInstImport = 11,
    ExtInst = 12,
    MemoryModel = 14,
    EntryPoint = 15,
    Capability = 17,
    TypeVoid = 19,
    TypeBool = 20,
    TypeInt = 21,
    TypeFloat = 22,
    TypeVector = 23,
    TypeMatrix = 24,
    TypeArray = 28,
    TypeRuntimeArray = 29,
    TypeStruct = 30,
    TypePointer = 32,
    TypeFunction = 33,
    Constant = 43,
    ConstantComposite = 44,
    Function = 54,
    FunctionEnd = 56,
    FunctionCall = 57,
    Variable = 59,
    ImageTexelPointer = 60,
    Load = 61,
    Store = 62,
    AccessChain = 65,
    InBoundsAccessChain = 66,
    ArrayLength = 68,
    VectorExtractDynamic = 77,
    VectorInsertDynamic = 78,
    VectorShuffle = 79,
    CompositeConstruct = 80,
    CompositeExtract = 81,
    ImageSampleImplicitLod = 87,
    ImageSampleProjDrefExplicitLod = 94,
    ImageFetch = 95,
    ImageGather = 96,
    ImageDrefGather = 97,
    ImageRead = 98,
    ImageWrite = 99,
    ImageQuerySizeLod = 103,
    ImageQuerySize = 104,
    ImageQueryLevels = 106,
    ImageQuerySamples = 107,
    ConvertFToU = 109,
    ConvertFToS = 110,
    Bitcast = 124,
    IAdd = 128,
    UDiv = 134,
    SDiv = 135,
    UMod = 137,
    SRem = 138,
    SMod = 139,
    FRem = 140,
    FMod = 141,
    Any = 154,
    All = 155,
    LogicalOr = 166,
    LogicalAnd = 167,
    Select = 169,
    IEqual = 170,
    INotEqual = 171,
    UGreaterThan = 172,
    SGreaterThan = 173,
    UGreaterThanEqual = 174,
    SGreaterThanEqual = 175,
    ULessThan = 176,
    FOrdEqual = 180,
    FOrdGreaterThan = 186,
    FOrdGreaterThanEqual = 190,
    FUnordGreaterThanEqual = 191,
    ShiftRightLogical = 194,
    ShiftRightArithmetic = 195,
    ShiftLeftLogical = 196,
    BitwiseOr = 197,
    BitwiseAnd = 199,
    BitFieldInsert = 201,
    BitFieldSExtract = 202,
    BitFieldUExtract = 203,
    AtomicIAdd = 234,
    AtomicOr = 241,
    LoopMerge = 246,
    SelectionMerge = 247,
    Label = 248,
    Branch = 249,
    BranchConditional = 250,
    Kill = 252,
    Return = 253,
    NoLine = 317,
    TerminateInvocation = 4416,
    DemoteToHelperInvocation = 5380,
};
} // namespace op

struct Instruction {
    uint32_t op = 0;
    std::vector<uint32_t> operands;

    uint32_t operator[](size_t i) const { return operands[i]; }
};

struct SpirvModule {
    static constexpr uint32_t version1_4 = 0x00010400, version1_5 = 0x00010500;

    std::vector<uint32_t> header;
    std::vector<Instruction> instructions;

    uint32_t version() const { return header[1]; }
    uint32_t newId() { return header[3]++; }
    std::vector<uint32_t> words() const;
};

/// None where the words are no SPIR-V.
std::optional<SpirvModule> readSpirv(std::span<const uint32_t> words);

/// Literal strings, as words and from words.
std::vector<uint32_t> literal(const std::string& text);
std::string text(std::span<const uint32_t> literal);

} // namespace tests
