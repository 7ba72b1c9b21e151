"""SPIR-V as lists of instructions: read from what glslangValidator wrote, .spv or a C array."""
import array
import re
from enum import IntEnum


class Op(IntEnum):
    Undef = 1
    Name, MemberName = 5, 6
    ExtInst = 12
    TypeVoid, TypeBool, TypeInt, TypeFloat, TypeVector, TypeMatrix = 19, 20, 21, 22, 23, 24
    TypeImage = 25
    TypeArray, TypeRuntimeArray, TypeStruct = 28, 29, 30
    TypePointer, TypeFunction = 32, 33
    ConstantTrue, ConstantFalse, Constant, ConstantComposite, ConstantNull = 41, 42, 43, 44, 46
    SpecConstantTrue, SpecConstantFalse, SpecConstant, SpecConstantComposite, SpecConstantOp = 48, 49, 50, 51, 52
    Function, FunctionParameter, FunctionEnd, FunctionCall = 54, 55, 56, 57
    Variable = 59
    Load, Store, CopyMemory = 61, 62, 63
    AccessChain, InBoundsAccessChain = 65, 66
    Decorate, MemberDecorate = 71, 72
    VectorExtractDynamic, VectorInsertDynamic, VectorShuffle = 77, 78, 79
    CompositeConstruct, CompositeExtract, CompositeInsert, CopyObject = 80, 81, 82, 83
    Bitcast = 124
    IAdd, ISub = 128, 130
    FAdd, FSub, FMul, FDiv = 129, 131, 133, 136
    VectorTimesScalar, MatrixTimesVector, Dot = 142, 145, 148
    IsNan = 156
    LogicalOr, LogicalAnd, LogicalNot, Select = 166, 167, 168, 169
    IEqual, INotEqual = 170, 171
    UGreaterThan, SGreaterThan, UGreaterThanEqual, SGreaterThanEqual = 172, 173, 174, 175
    ULessThan, SLessThan, ULessThanEqual, SLessThanEqual = 176, 177, 178, 179
    FOrdLessThan, FOrdGreaterThan, FOrdLessThanEqual, FOrdGreaterThanEqual = 184, 186, 188, 190
    BitwiseAnd = 199
    Phi, LoopMerge, SelectionMerge, Label, Branch, BranchConditional, Switch = 245, 246, 247, 248, 249, 250, 251
    Kill, Return, ReturnValue, Unreachable = 252, 253, 254, 255


class Module:
    def __init__(self, words):
        if len(words) < 5 or words[0] != 0x07230203:
            raise ValueError("no SPIR-V, expected the magic number 07230203")
        self.header = list(words[:5])
        self.instructions = []
        at = 5
        while at < len(words):
            count = words[at] >> 16
            if count == 0 or at + count > len(words):
                raise ValueError(f"word {at}: an instruction of {count} words, expected 1 to {len(words) - at}")
            self.instructions.append((words[at] & 0xFFFF, *words[at + 1:at + count]))
            at += count

    def words(self):
        out = array.array("I", self.header)
        for op, *operands in self.instructions:
            out.append((len(operands) + 1) << 16 | op)
            out.extend(operands)
        return out


def read(path):
    """Of a header that glslangValidator wrote with --vn, or of a binary."""
    if not str(path).endswith(".h"):
        words = array.array("I")
        with open(path, "rb") as file:
            words.frombytes(file.read())
        return Module(words)
    with open(path) as file:
        return Module(array.array("I", [int(word, 16) for word in re.findall(r"\b0x([0-9a-f]{8})\b", file.read())]))


def text(words):
    """A literal string."""
    return b"".join(word.to_bytes(4, "little") for word in words).split(b"\0")[0].decode()


def files(arguments):
    """Those named, and those listed in files that are named with an @."""
    paths = []
    for argument in arguments:
        if argument.startswith("@"):
            with open(argument[1:]) as file:
                paths += file.read().split()
        else:
            paths.append(argument)
    return paths
