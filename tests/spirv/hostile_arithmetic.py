"""Makes of a shader one whose arithmetic is as unlike a CPU device's as Vulkan lets it be.

    hostile_arithmetic.py MODE SPIRV-OPT HEADER      HEADER is what glslangValidator wrote, and is written anew

- A product that is added is fused, unless `precise`; dot products and those of matrices with vectors, too. Doubles stand for
  that: CPU devices take a fused multiply-add apart.
- What is subnormal is zero.
- min, max and clamp that are given a NaN are the other operand (MODE other) or the NaN (MODE nan).
- Floats outside the range of integers become the last of these, NaN becomes 0, as on GPUs.
"""
import os
import subprocess
import sys
import tempfile

from module import Module, Op, read, text

NO_CONTRACTION, FLOAT64 = 42, 10
FMIN, FMAX, FCLAMP, NMIN, NMAX, NCLAMP = 37, 40, 43, 79, 80, 81
EXP, EXP2, POW = 27, 29, 26
CONVERT_TO_U, CONVERT_TO_S, CONVERT, EXTRACT = 109, 110, 115, Op.CompositeExtract
FLUSHED = {Op.FAdd, Op.FSub, Op.FMul, Op.FDiv, Op.VectorTimesScalar, Op.MatrixTimesVector, Op.Dot}


class Hostile:
    def __init__(self, module, mode):
        self.module, self.mode = module, mode
        self.types, self.type_of, self.constants, self.exact, self.products = {}, {}, {}, set(), {}
        self.globals, self.decorations = [], []
        self.glsl = next(i[1] for i in module.instructions if i[0] == 11 and text(i[2:]) == "GLSL.std.450") \
            if any(i[0] == 11 for i in module.instructions) else None
        for i in module.instructions:
            if Op.TypeVoid <= i[0] <= Op.TypeMatrix:
                self.types.setdefault((i[0], *i[2:]), i[1])
                self.types[i[1]] = i
            elif i[0] in (Op.Constant, Op.ConstantComposite):
                self.constants.setdefault((i[0], i[1], *i[3:]), i[2])
            elif i[0] == Op.Decorate and i[2] == NO_CONTRACTION:
                self.exact.add(i[1])

    # ---- ids

    def id(self):
        self.module.header[3] += 1
        return self.module.header[3] - 1

    def type(self, op, *operands):
        if (op, *operands) not in self.types:
            id = self.types[(op, *operands)] = self.id()
            self.types[id] = (op, id, *operands)
            self.globals.append((op, id, *operands))
        return self.types[(op, *operands)]

    def like(self, type, op, *operands):
        """The scalar of that kind, or a vector of as many as the type has."""
        scalar = self.type(op, *operands)
        count = self.count(type)
        return scalar if count == 1 else self.type(Op.TypeVector, scalar, count)

    def count(self, type):
        return self.types[type][3] if self.types[type][0] == Op.TypeVector else 1

    def is_float(self, type):
        kind = self.types.get(type)
        return kind is not None and (kind[0] == Op.TypeFloat and kind[2] == 32 or
                                     kind[0] == Op.TypeVector and self.is_float(kind[2]))

    def constant(self, type, word):
        count = self.count(type)
        scalar = type if count == 1 else self.types[type][2]
        key = (Op.Constant, scalar, word)
        if key not in self.constants:
            self.constants[key] = self.id()
            self.globals.append((Op.Constant, scalar, self.constants[key], word))
        if count == 1:
            return self.constants[key]
        vector = (Op.ConstantComposite, type, *[self.constants[key]] * count)
        if vector not in self.constants:
            self.constants[vector] = self.id()
            self.globals.append((Op.ConstantComposite, type, self.constants[vector], *vector[2:]))
        return self.constants[vector]

    # ---- what is put in

    def put(self, op, type, *operands, id=None):
        id = id or self.id()
        self.out.append((op, type, id, *operands))
        self.type_of[id] = type
        return id

    def splat(self, type, scalar):
        return self.put(Op.CompositeConstruct, type, *[scalar] * self.count(type))

    def flushed(self, type, value, id):
        words = self.like(type, Op.TypeInt, 32, 0)
        bits = self.put(Op.Bitcast, words, value)
        exponent = self.put(Op.BitwiseAnd, words, bits, self.constant(words, 0x7F800000))
        small = self.put(Op.IEqual, self.like(type, Op.TypeBool), exponent, self.constant(words, 0))
        zero = self.put(Op.BitwiseAnd, words, bits, self.constant(words, 0x80000000))
        self.put(Op.Bitcast, type, self.put(Op.Select, words, small, zero, bits), id=id)

    def double(self, type, value):
        return self.put(CONVERT, self.like(type, Op.TypeFloat, 64), value)

    def fused(self, type, a, b, c, sign=1, product_sign=1):
        doubles = self.like(type, Op.TypeFloat, 64)
        product = self.put(Op.FMul, doubles, self.double(type, a), self.double(type, b))
        addend = self.double(type, c)
        if product_sign < 0:
            sum = self.put(Op.FSub, doubles, addend, product)
        else:
            sum = self.put(Op.FAdd if sign > 0 else Op.FSub, doubles, product, addend)
        return self.put(CONVERT, type, sum)

    def chain(self, type, pairs):
        """Of products, each added to those before it."""
        sum = self.put(Op.FMul, type, *pairs[0])
        for a, b in pairs[1:]:
            sum = self.fused(type, a, b, sum)
        return sum

    def factors(self, type, id):
        """Of a product that may be fused."""
        if id not in self.products:
            return None
        a, b, scaled = self.products[id]
        return a, self.splat(type, b) if scaled else b

    def parts(self, id):
        type = self.type_of[id]
        return [self.put(EXTRACT, self.types[type][2], id, i) for i in range(self.count(type))]

    def sum(self, op, type, a, b):
        """Fused, or None."""
        factors = self.factors(type, a)
        if factors:
            return self.fused(type, *factors, b, 1 if op == Op.FAdd else -1)
        factors = self.factors(type, b)
        if factors:
            return self.fused(type, *factors, a, 1, 1 if op == Op.FAdd else -1)
        return None

    def dot(self, type, a, b):
        return self.chain(type, list(zip(self.parts(a), self.parts(b))))

    def matrix_times_vector(self, type, matrix, vector):
        kind = self.types[self.type_of[matrix]]
        columns = [self.put(EXTRACT, kind[2], matrix, i) for i in range(kind[3])]
        return self.chain(type, [(column, self.splat(type, x)) for column, x in zip(columns, self.parts(vector))])

    def chosen(self, type, way, a, b, id=None):
        """min or max, or NaN if either is."""
        flags = self.like(type, Op.TypeBool)
        less = self.put(Op.FOrdLessThan, flags, *((b, a) if way == FMIN else (a, b)))
        nan = self.put(Op.LogicalOr, flags, self.put(Op.IsNan, flags, a), self.put(Op.IsNan, flags, b))
        return self.put(Op.Select, type, nan, self.put(Op.FAdd, type, a, b), self.put(Op.Select, type, less, b, a), id=id)

    def converted(self, op, type, id, value):
        """Saturated. The largest float that is an integer of 32 bits is less than the largest of these."""
        source = self.type_of[value]
        signed = op == CONVERT_TO_S
        flags = self.like(type, Op.TypeBool)
        low, high = (0xCF000000, 0x4F000000) if signed else (0, 0x4F800000)
        least, most = (0x80000000, 0x7FFFFFFF) if signed else (0, 0xFFFFFFFF)
        over = self.put(Op.FOrdGreaterThanEqual, flags, value, self.constant(source, high))
        inside = self.put(Op.LogicalAnd, flags, self.put(Op.FOrdGreaterThan, flags, value, self.constant(source, low)),
                          self.put(Op.LogicalNot, flags, over))
        safe = self.put(Op.Select, source, inside, value, self.constant(source, 0))
        whole = self.put(op, type, safe)
        under = self.put(Op.FOrdLessThanEqual, flags, value, self.constant(source, low))
        whole = self.put(Op.Select, type, under, self.constant(type, least), whole)
        self.put(Op.Select, type, over, self.constant(type, most), whole, id=id)

    # ---- the walk

    def instruction(self, i):
        op, type, id, *operands = i
        self.type_of[id] = type
        if op in (CONVERT_TO_U, CONVERT_TO_S) and self.is_float(self.type_of[operands[0]]):
            return self.converted(op, type, id, operands[0])
        if not self.is_float(type):
            return self.out.append(i)
        if op == Op.ExtInst and operands[0] == self.glsl:
            return self.function(i)
        if op not in FLUSHED:
            return self.out.append(i)
        value = None
        if id not in self.exact:
            if op in (Op.FMul, Op.VectorTimesScalar):
                self.products[id] = (*operands, op == Op.VectorTimesScalar)
            elif op in (Op.FAdd, Op.FSub):
                value = self.sum(op, type, *operands)
            elif op == Op.Dot:
                value = self.dot(type, *operands)
            elif op == Op.MatrixTimesVector:
                value = self.matrix_times_vector(type, *operands)
        if value is None:
            value = self.put(op, type, *operands)
            if id in self.exact:
                self.decorations.append((Op.Decorate, value, NO_CONTRACTION))
        self.flushed(type, value, id)

    def function(self, i):
        _, type, id, _, which, *operands = i
        if which in (EXP, EXP2, POW):
            return self.flushed(type, self.put(Op.ExtInst, type, self.glsl, which, *operands), id)
        if which not in (FMIN, FMAX, FCLAMP):
            return self.out.append(i)
        if self.mode == "other":
            other = {FMIN: NMIN, FMAX: NMAX, FCLAMP: NCLAMP}[which]
            return self.put(Op.ExtInst, type, self.glsl, other, *operands, id=id)
        if which == FCLAMP:
            return self.chosen(type, FMIN, self.chosen(type, FMAX, *operands[:2]), operands[2], id)
        return self.chosen(type, which, *operands, id)

    def run(self):
        before, inside, function = [], [], False
        for i in self.module.instructions:
            function = function or i[0] == Op.Function
            if not function:
                before.append(i)
                if Op.ConstantTrue <= i[0] <= Op.SpecConstantOp or i[0] == Op.Undef or i[0] == Op.Variable:
                    self.type_of[i[2]] = i[1]
                continue
            self.out = inside
            if i[0] == Op.FunctionParameter or i[0] == Op.Function or i[0] == Op.Phi:
                self.type_of[i[2]] = i[1]
                inside.append(i)
            elif len(i) > 2 and i[1] in self.types:
                self.instruction(i)
            else:
                if len(i) > 2:
                    self.type_of.setdefault(i[2], i[1])
                inside.append(i)
        capability = [] if (17, FLOAT64) in before else [(17, FLOAT64)]
        last_decoration = max((n for n, i in enumerate(before) if i[0] in (Op.Decorate, Op.MemberDecorate)), default=-1)
        if last_decoration < 0:
            last_decoration = next(n for n, i in enumerate(before) if Op.TypeVoid <= i[0] <= Op.TypeFunction) - 1
        self.module.instructions = capability + before[:last_decoration + 1] + self.decorations + before[last_decoration + 1:] + \
            self.globals + inside
        return self.module


def main(mode, optimizer, header):
    if mode not in ("other", "nan"):
        print(f"hostile_arithmetic.py: {mode} is not known, expected other or nan", file=sys.stderr)
        return 2
    with open(header) as file:
        name = file.read().split("const uint32_t ")[1].split("[")[0]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "shader.spv")
        with open(path, "wb") as file:
            file.write(read(header).words().tobytes())
        # What is stored and loaded again within a function is one value, as it is to a driver's compiler.
        subprocess.run([optimizer, "--convert-local-access-chains", "--eliminate-local-single-block", "--eliminate-local-single-store",
                        path, "-o", path], check=True)
        words = Hostile(read(path), mode).run().words()
    with open(header, "w") as file:
        file.write(f"#pragma once\nconst uint32_t {name}[] = {{\n" + ",".join(f"0x{word:08x}" for word in words) + "};\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
