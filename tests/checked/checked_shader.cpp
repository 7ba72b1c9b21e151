#include "tests/checked/checked_shader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tests/checked/spirv_builder.h"

namespace tests {

namespace {

// As the specifications number them: SPIR-V, and its extended instructions for GLSL.
constexpr uint32_t physicalStorageBuffer = 5349, physicalAddressing = 5348, physicalAddresses = 5347;
constexpr uint32_t imageQuery = 50;
constexpr uint32_t vulkanMemoryModel = 3, scopeDevice = 1, scopeQueueFamily = 5, relaxed = 0;
namespace glsl {
enum : uint32_t {
    Sin = 13,
    Cos = 14,
    Tan = 15,
    Asin = 16,
    Acos = 17,
    Atan2 = 25,
    Pow = 26,
    Exp = 27,
    Log = 28,
    Exp2 = 29,
    Log2 = 30,
    Sqrt = 31,
    InverseSqrt = 32,
    FMin = 37,
    FMax = 40,
    FClamp = 43,
    UClamp = 44,
    SClamp = 45,
    Step = 48,
    SmoothStep = 49,
    Normalize = 69,
};
}

// Floats as bits: comparisons of integers know nothing of what a driver assumes of NaN.
constexpr uint32_t bitsOfOne = 0x3f800000, bitsOf2To31 = 0x4f000000, bitsOf2To32 = 0x4f800000;
constexpr uint32_t bitsOfInfinity = 0x7f800000, signBit = 0x80000000;
// Of pi and a ten-thousandth: what is folded to pi rounds a little beyond it.
constexpr uint32_t bitsOfPi = 0x40491500;
/// The powers of e and of 2 that a float just holds, or does no longer.
constexpr uint32_t bitsOfLargestExp = 0x42b17217, bitsOfExp2Beyond = 0x43000000;

const char* stageName(uint32_t model) {
    constexpr std::array names = {
        "vertex", "tessellation control", "tessellation evaluation", "geometry", "fragment", "compute"};
    return model < names.size() ? names[model] : "other";
}

enum : uint32_t { dim1D, dim2D, dim3D, dimCube, dimRect, dimBuffer, dimSubpass };

class Checker {
  public:
    Checker(SpirvModule& module, const ReserveNotes& reserve)
        : module_(module), b_(module), reserve_(reserve) {}

    bool run(CheckedShader& out);

  private:
    // Of a scalar or of each component; then whether any is.
    uint32_t bits(uint32_t value);
    uint32_t magnitude(uint32_t value);
    uint32_t compare(uint32_t op, uint32_t a, uint32_t b);
    uint32_t than(uint32_t op, uint32_t value, uint32_t word) {
        return compare(op, value, b_.constant(b_.typeIdOf(value), word));
    }
    uint32_t either(uint32_t a, uint32_t b) { return b_.put(op::LogicalOr, b_.typeIdOf(a), {a, b}); }
    uint32_t both(uint32_t a, uint32_t b) { return b_.put(op::LogicalAnd, b_.typeIdOf(a), {a, b}); }
    uint32_t isNan(uint32_t value) { return than(op::UGreaterThan, magnitude(value), bitsOfInfinity); }
    uint32_t isNegativeOrNan(uint32_t value) {
        return either(than(op::UGreaterThan, bits(value), signBit), isNan(value));
    }
    uint32_t isZero(uint32_t value) { return than(op::IEqual, magnitude(value), 0); }
    uint32_t beyond(uint32_t index, uint32_t count);

    void place(const char* violation, uint32_t condition);
    void anyNan(const char* violation, std::span<const uint32_t> values);

    void check(const Instruction& i);
    void function(const Instruction& i);
    void conversion(const Instruction& i);
    void division(const Instruction& i);
    void remainder(const Instruction& i);
    void chain(const Instruction& i);
    void sample(const Instruction& i);
    void fetch(const Instruction& i);
    void texel(uint32_t image, uint32_t coordinate);
    void outside(const Instruction& imageType, uint32_t coordinate,
                 const std::function<uint32_t(uint32_t)>& size);
    void round();
    bool leaves(const Instruction& i) const;
    void flush();

    void readGlobal(const Instruction& i);

    SpirvModule& module_;
    SpirvBuilder b_;
    const ReserveNotes& reserve_;
    CheckedShader shader_;
    std::vector<uint32_t> flags_; ///< private words, a bit for each place
    uint32_t rounds_ = 0, flush_ = 0, entry_ = 0, entries_ = 0, glsl_ = 0, scope_ = 0;
    bool queries_ = false;
    std::unordered_map<uint32_t, std::string> names_;
    std::string function_, line_;
    uint32_t functionId_ = 0;
};

uint32_t Checker::bits(uint32_t value) {
    const uint32_t words = b_.like(b_.typeIdOf(value), b_.uintType());
    return b_.typeIdOf(value) == words ? value : b_.put(op::Bitcast, words, {value});
}

uint32_t Checker::magnitude(uint32_t value) {
    const uint32_t words = bits(value), type = b_.typeIdOf(words);
    return b_.put(op::BitwiseAnd, type, {words, b_.constant(type, ~signBit)});
}

uint32_t Checker::compare(uint32_t op, uint32_t a, uint32_t b) {
    return b_.put(op, b_.like(b_.typeIdOf(a), b_.boolType()), {a, b});
}

/// Of an index as Vulkan takes it, signed or not.
uint32_t Checker::beyond(uint32_t index, uint32_t count) {
    return compare(op::UGreaterThanEqual, bits(index), bits(count));
}

void Checker::place(const char* violation, uint32_t condition) {
    const size_t index = shader_.places.size();
    shader_.places.push_back({violation, function_, line_});
    if (index % 32 == 0) flags_.push_back(b_.zeroVariable());
    const uint32_t flags = flags_.back(), type = b_.uintType();
    if (b_.components(b_.typeIdOf(condition)) > 1) condition = b_.put(op::Any, b_.boolType(), {condition});
    const uint32_t bit = b_.put(op::Select, type, {condition, b_.constant(1u << index % 32), b_.constant(0)});
    const uint32_t before = b_.put(op::Load, type, {flags});
    b_.putVoid(op::Store, {flags, b_.put(op::BitwiseOr, type, {before, bit})});
}

void Checker::anyNan(const char* violation, std::span<const uint32_t> values) {
    uint32_t found = 0;
    for (const uint32_t value : values) {
        if (b_.constantWord(value)) continue;
        const uint32_t nan = isNan(value);
        found = found ? either(found, nan) : nan;
    }
    if (found) place(violation, found);
}

void Checker::conversion(const Instruction& i) {
    const uint32_t value = i[2];
    if (!b_.isFloat32(b_.typeIdOf(value)) || !b_.isInt32(i[0])) return;
    if (i.op == op::ConvertFToS) {
        const uint32_t large = than(op::UGreaterThanEqual, magnitude(value), bitsOf2To31);
        return place("a float beyond the range of int, or NaN, is made one",
                     both(large, than(op::INotEqual, bits(value), signBit | bitsOf2To31)));
    }
    // What is cut off towards zero may have been as little as -1.
    const uint32_t words = bits(value);
    const uint32_t negative = than(op::UGreaterThanEqual, words, signBit | bitsOfOne);
    const uint32_t large =
        both(than(op::UGreaterThanEqual, words, bitsOf2To32), than(op::ULessThan, words, signBit));
    place("a float beyond the range of uint, or NaN, is made one", either(negative, large));
}

void Checker::division(const Instruction& i) {
    if (!b_.isInt32(i[0])) return;
    if (b_.constantWord(i[3]).value_or(0) == 0)
        place("an integer is divided by zero", than(op::IEqual, bits(i[3]), 0));
    if (i.op != op::SRem && i.op != op::SMod) return;
    const uint32_t signs = b_.put(op::BitwiseOr, b_.typeIdOf(bits(i[2])), {bits(i[2]), bits(i[3])});
    place("the remainder of a negative integer is taken", than(op::UGreaterThanEqual, signs, signBit));
}

void Checker::remainder(const Instruction& i) {
    if (b_.isFloat32(i[0]) && b_.constantWord(i[3]).value_or(0) == 0)
        place("the remainder of a division by zero is taken", isZero(i[3]));
}

void Checker::function(const Instruction& i) {
    if (i[2] != glsl_) return;
    const uint32_t which = i[3];
    const std::span<const uint32_t> x = std::span(i.operands).subspan(4);
    if (which == glsl::UClamp || which == glsl::SClamp) {
        const bool known = b_.constantWord(x[1]) && b_.constantWord(x[2]);
        if (!known && b_.isInt32(i[0]))
            place("clamp has limits in the wrong order",
                  compare(which == glsl::UClamp ? op::UGreaterThan : op::SGreaterThan, x[1], x[2]));
        return;
    }
    if (!b_.isFloat32(i[0])) return;
    switch (which) {
    case glsl::Sin:
    case glsl::Cos:
    case glsl::Tan:
        return place("sin, cos or tan is of an angle beyond pi, or NaN",
                     than(op::UGreaterThan, magnitude(x[0]), bitsOfPi));
    case glsl::Asin:
    case glsl::Acos:
        return place("asin or acos is of more than 1, or NaN",
                     than(op::UGreaterThan, magnitude(x[0]), bitsOfOne));
    case glsl::Atan2:
        return place("atan is of zero and zero", both(isZero(x[0]), isZero(x[1])));
    case glsl::Pow:
        return place(
            "pow is of a negative base, NaN, or zero to the power of zero or less",
            either(isNegativeOrNan(x[0]), both(isZero(x[0]), either(isNegativeOrNan(x[1]), isZero(x[1])))));
    // As an integer a negative float is one.
    case glsl::Exp:
        return place("exp is of more than 88.7, or NaN",
                     than(op::SGreaterThan, bits(x[0]), bitsOfLargestExp));
    case glsl::Exp2:
        return place("exp2 is of 128 or more, or NaN",
                     than(op::SGreaterThanEqual, bits(x[0]), bitsOfExp2Beyond));
    case glsl::Log:
    case glsl::Log2:
        return place("log is of zero, a negative number or NaN", either(isNegativeOrNan(x[0]), isZero(x[0])));
    case glsl::Sqrt:
        return place("sqrt is of a negative number or NaN", isNegativeOrNan(x[0]));
    case glsl::InverseSqrt:
        return place("inversesqrt is of zero, a negative number or NaN",
                     either(isNegativeOrNan(x[0]), isZero(x[0])));
    case glsl::Normalize: {
        const uint32_t zero = isZero(x[0]);
        return place("normalize is of zero",
                     b_.components(i[0]) > 1 ? b_.put(op::All, b_.boolType(), {zero}) : zero);
    }
    case glsl::FMin:
    case glsl::FMax:
    case glsl::Step:
        return anyNan("min, max or step is given NaN", x);
    case glsl::FClamp:
        anyNan("clamp is given NaN", x);
        if (!b_.constantWord(x[1]) || !b_.constantWord(x[2]))
            place("clamp has limits in the wrong order", compare(op::FOrdGreaterThan, x[1], x[2]));
        return;
    case glsl::SmoothStep:
        anyNan("smoothstep is given NaN", x);
        if (!b_.constantWord(x[0]) || !b_.constantWord(x[1]))
            place("smoothstep has edges in the wrong order", compare(op::FOrdGreaterThanEqual, x[0], x[1]));
        return;
    default:
        return;
    }
}

/// Walks the types that an access chain goes down.
void Checker::chain(const Instruction& i) {
    constexpr size_t firstIndex = 3;
    uint32_t type = b_.typeOf(i[2])[1];
    for (size_t at = firstIndex; at < i.operands.size(); ++at) {
        const Instruction& t = *b_.typeNamed(type);
        const uint32_t index = i[at];
        const std::optional<uint32_t> known = b_.constantWord(index);
        uint32_t count = 0;
        switch (t.op) {
        case op::TypeStruct:
            type = t[*known];
            continue;
        case op::TypeArray:
            if (!known || !b_.constantWord(t[1])) count = t[1];
            break;
        case op::TypeRuntimeArray:
            // The array's block has to be what the chain begins at.
            if (at == firstIndex + 1)
                count = b_.put(op::ArrayLength, b_.uintType(), {i[2], *b_.constantWord(i[firstIndex])});
            break;
        case op::TypeVector:
        case op::TypeMatrix:
            if (!known) count = b_.constant(t[1]);
            break;
        default:
            return;
        }
        type = t[0];
        if (count) place("an index is beyond its array or vector", beyond(index, count));
    }
}

void Checker::sample(const Instruction& i) {
    const uint32_t coordinate = i[3];
    if (b_.isFloat32(b_.typeIdOf(coordinate)))
        place("an image is sampled at NaN or infinity",
              than(op::UGreaterThanEqual, magnitude(coordinate), bitsOfInfinity));
}

void Checker::outside(const Instruction& imageType, uint32_t coordinate,
                      const std::function<uint32_t(uint32_t)>& size) {
    const uint32_t dim = imageType[1], arrayed = imageType[3];
    if (dim == dimCube || dim == dimSubpass) return;
    const uint32_t count = (dim == dim1D || dim == dimBuffer ? 1u : dim == dim3D ? 3u : 2u) + arrayed;
    const uint32_t words = b_.vectorOf(b_.uintType(), count);
    uint32_t at = bits(coordinate);
    if (b_.components(b_.typeIdOf(at)) > count) {
        std::vector<uint32_t> operands{at};
        if (count > 1) operands.push_back(at);
        for (uint32_t c = 0; c < count; ++c) operands.push_back(c);
        at = b_.put(count > 1 ? op::VectorShuffle : op::CompositeExtract, words, operands);
    }
    queries_ = true;
    place("a texel outside its image is read or written", beyond(at, size(words)));
}

void Checker::fetch(const Instruction& i) {
    enum : uint32_t { lodOperand = 2, offsetOperands = 8 | 16, sampleOperand = 64 };
    const uint32_t image = i[2], operands = i.operands.size() > 4 ? i[4] : 0;
    const Instruction type = b_.typeOf(image);
    uint32_t coordinate = i[3];
    size_t next = 5;
    uint32_t lod = 0;
    if (operands & lodOperand) {
        queries_ = true;
        const uint32_t levels = b_.put(op::ImageQueryLevels, b_.uintType(), {image});
        const uint32_t asked = i[next++], wrong = beyond(asked, levels);
        place("a mip level is read that its image does not have", wrong);
        lod = b_.put(op::Select, b_.uintType(), {wrong, b_.constant(0), bits(asked)});
    }
    if (operands & offsetOperands) {
        const uint32_t offset = i[next++];
        coordinate = b_.put(op::IAdd, b_.typeIdOf(coordinate), {coordinate, offset});
    }
    if (operands & sampleOperand) {
        queries_ = true;
        const uint32_t samples = b_.put(op::ImageQuerySamples, b_.uintType(), {image});
        place("a sample is read that its image does not have", beyond(i[next], samples));
    }
    const bool multisampled = type[4], buffer = type[1] == dimBuffer;
    if (!lod && !multisampled && !buffer) lod = b_.constant(0);
    outside(type, coordinate, [&](uint32_t words) {
        return lod ? b_.put(op::ImageQuerySizeLod, words, {image, lod})
                   : b_.put(op::ImageQuerySize, words, {image});
    });
}

void Checker::texel(uint32_t image, uint32_t coordinate) {
    const Instruction type = b_.typeOf(image);
    outside(type, coordinate, [&](uint32_t words) { return b_.put(op::ImageQuerySize, words, {image}); });
}

void Checker::round() {
    if (!rounds_) rounds_ = b_.zeroVariable();
    const uint32_t before = b_.put(op::Load, b_.uintType(), {rounds_});
    const uint32_t now = b_.put(op::IAdd, b_.uintType(), {before, b_.constant(1)});
    b_.putVoid(op::Store, {rounds_, now});
    place("loops go round too often", than(op::UGreaterThan, now, mostRounds));
}

void Checker::check(const Instruction& i) {
    if (i.op >= op::ImageSampleImplicitLod && i.op <= op::ImageSampleProjDrefExplicitLod) return sample(i);
    if (i.op >= op::FOrdEqual && i.op <= op::FUnordGreaterThanEqual) {
        if (b_.isFloat32(b_.typeIdOf(i[2]))) anyNan("NaN is compared", std::array{i[2], i[3]});
        return;
    }
    switch (i.op) {
    case op::ConvertFToU:
    case op::ConvertFToS:
        return conversion(i);
    case op::UDiv:
    case op::SDiv:
    case op::UMod:
    case op::SRem:
    case op::SMod:
        return division(i);
    case op::FRem:
    case op::FMod:
        return remainder(i);
    case op::ExtInst:
        return function(i);
    case op::AccessChain:
    case op::InBoundsAccessChain:
        return chain(i);
    case op::VectorExtractDynamic:
        return place("an index is beyond its array or vector",
                     beyond(i[3], b_.constant(b_.components(b_.typeIdOf(i[2])))));
    case op::VectorInsertDynamic:
        return place("an index is beyond its array or vector",
                     beyond(i[4], b_.constant(b_.components(b_.typeIdOf(i[2])))));
    case op::ImageGather:
    case op::ImageDrefGather:
        return sample(i);
    case op::ImageFetch:
        return fetch(i);
    case op::ImageRead:
        return texel(i[2], i[3]);
    case op::ImageWrite:
        return texel(i[0], i[1]);
    case op::ImageTexelPointer:
        return texel(b_.put(op::Load, b_.typeOf(i[2])[1], {i[2]}), i[3]);
    case op::ShiftRightLogical:
    case op::ShiftRightArithmetic:
    case op::ShiftLeftLogical:
        if (b_.isInt32(i[0]) && !b_.constantWord(i[3]))
            place("an integer is shifted by 32 bits or more", than(op::UGreaterThanEqual, bits(i[3]), 32));
        return;
    case op::BitFieldInsert:
    case op::BitFieldSExtract:
    case op::BitFieldUExtract: {
        const size_t at = i.op == op::BitFieldInsert ? 4 : 3;
        if (b_.constantWord(i[at]) && b_.constantWord(i[at + 1])) return;
        const uint32_t end = b_.put(op::IAdd, b_.uintType(), {bits(i[at]), bits(i[at + 1])});
        return place("a bit field ends beyond 32 bits", than(op::UGreaterThan, end, 32));
    }
    case op::LoopMerge:
        return round();
    default:
        return;
    }
}

/// What ends an invocation, or its right to write.
bool Checker::leaves(const Instruction& i) const {
    return (i.op == op::Return && functionId_ == entry_) || i.op == op::Kill ||
           i.op == op::TerminateInvocation || i.op == op::DemoteToHelperInvocation;
}

/// Writes what was noted: once an invocation, and only where there is something.
void Checker::flush() {
    const uint32_t nothing = b_.type(op::TypeVoid), type = b_.uintType();
    const uint32_t functionType = b_.type(op::TypeFunction, {nothing});
    b_.out.push_back({op::Function, {nothing, flush_, 0, functionType}});
    b_.putVoid(op::Label, {module_.newId()});
    const uint64_t address = reserve_(shader_.noteWords());
    const uint32_t pointerType = b_.type(op::TypePointer, {physicalStorageBuffer, type});
    const uint32_t pair = b_.vectorOf(type, 2);
    const auto pointer = [&](size_t word) {
        const uint64_t at = address + word * sizeof(uint32_t);
        const std::vector<uint32_t> halves{b_.constant(static_cast<uint32_t>(at)),
                                           b_.constant(static_cast<uint32_t>(at >> 32))};
        const uint32_t whole = b_.put(op::CompositeConstruct, pair, halves);
        return b_.put(op::Bitcast, pointerType, {whole});
    };
    std::vector<uint32_t> noted;
    uint32_t all = b_.constant(0);
    for (const uint32_t flags : flags_) {
        noted.push_back(b_.put(op::Load, type, {flags}));
        all = b_.put(op::BitwiseOr, type, {all, noted.back()});
    }
    const uint32_t some = than(op::INotEqual, all, 0), write = module_.newId(), end = module_.newId();
    b_.putVoid(op::SelectionMerge, {end, 0});
    b_.putVoid(op::BranchConditional, {some, write, end});
    b_.putVoid(op::Label, {write});
    const uint32_t scope = b_.constant(scope_), semantics = b_.constant(relaxed);
    b_.put(op::AtomicIAdd, type, {pointer(0), scope, semantics, b_.constant(1)});
    for (size_t word = 0; word < noted.size(); ++word)
        b_.put(op::AtomicOr, type, {pointer(1 + word), scope, semantics, noted[word]});
    b_.putVoid(op::Branch, {end});
    b_.putVoid(op::Label, {end});
    b_.putVoid(op::Return, {});
    b_.putVoid(op::FunctionEnd, {});
}

void Checker::readGlobal(const Instruction& i) {
    const std::span<const uint32_t> operands = i.operands;
    switch (i.op) {
    case op::ExtInstImport:
        if (text(operands.subspan(1)) == "GLSL.std.450") glsl_ = i[0];
        return;
    case op::MemoryModel:
        scope_ = i[1] == vulkanMemoryModel ? scopeQueueFamily : scopeDevice;
        return;
    case op::EntryPoint:
        ++entries_;
        shader_.stage = stageName(i[0]);
        entry_ = i[1];
        return;
    case op::Name:
    case op::String:
        names_[i[0]] = text(operands.subspan(1));
        return;
    default:
        b_.read(i);
    }
}

bool Checker::run(CheckedShader& out) {
    const std::vector<Instruction>& all = module_.instructions;
    const auto firstFunction =
        std::ranges::find_if(all, [](const Instruction& i) { return i.op == op::Function; });
    std::for_each(all.begin(), firstFunction, [&](const Instruction& i) { readGlobal(i); });
    if (entries_ != 1) return false;
    flush_ = module_.newId();
    const uint32_t nothing = b_.type(op::TypeVoid);
    std::for_each(firstFunction, all.end(), [&](const Instruction& i) {
        if (i.op == op::Function) {
            functionId_ = i[1];
            function_ = names_[functionId_].substr(0, names_[functionId_].find('('));
        }
        if (i.op == op::Line) line_ = names_[i[0]] + ":" + std::to_string(i[1]);
        if (i.op == op::Function || i.op == op::NoLine) line_.clear();
        check(i);
        if (leaves(i)) b_.put(op::FunctionCall, nothing, {flush_});
        b_.read(i);
        b_.out.push_back(i);
    });
    if (shader_.places.empty()) {
        out = std::move(shader_);
        return true;
    }
    flush();

    std::vector<Instruction> whole{{op::Capability, {physicalAddresses}}};
    if (queries_) whole.push_back({op::Capability, {imageQuery}});
    bool capabilities = true;
    for (Instruction i : std::span(all.begin(), firstFunction)) {
        if (i.op != op::Capability && std::exchange(capabilities, false) &&
            module_.version() < SpirvModule::version1_5)
            whole.push_back({op::Extension, literal("SPV_KHR_physical_storage_buffer")});
        if (i.op == op::MemoryModel) i.operands[0] = physicalAddressing;
        if (i.op == op::EntryPoint && module_.version() >= SpirvModule::version1_4)
            i.operands.insert(i.operands.end(), b_.variables.begin(), b_.variables.end());
        whole.push_back(std::move(i));
    }
    whole.insert(whole.end(), b_.globals.begin(), b_.globals.end());
    whole.insert(whole.end(), b_.out.begin(), b_.out.end());
    module_.instructions = std::move(whole);
    shader_.spirv = module_.words();
    out = std::move(shader_);
    return true;
}

} // namespace

std::optional<CheckedShader> checkedShader(std::span<const uint32_t> spirv, const ReserveNotes& reserve) {
    std::optional<SpirvModule> module = readSpirv(spirv);
    CheckedShader out;
    if (!module || !Checker(*module, reserve).run(out)) return std::nullopt;
    if (out.spirv.empty()) out.spirv.assign(spirv.begin(), spirv.end());
    return out;
}

} // namespace tests
