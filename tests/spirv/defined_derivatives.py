"""Fails on what leaves derivatives of a fragment shader undefined.

    defined_derivatives.py FILE...      each a .spv, or a header that glslangValidator wrote; @FILE lists such

That is OpKill, after which neighbours go on alone, and derivatives, or looks that choose their level by them, under a condition that may
differ from pixel to pixel, or behind one under which some pixels have returned.

What may differ is found without regard to order: a variable may once anything is stored in it that may, or under a
condition that may. A condition's construct ends at its merge, but where it holds a return, a break or a continue: then with
the function, or the loop.
"""
import multiprocessing
import sys

from module import files, read
from shader import READ_ONLY, Op, Shader

# dFdx and its like, and looks with an implicit level or for it.
DERIVATIVES = set(range(207, 216)) | {87, 89, 91, 93, 105}
ENDINGS = {Op.Kill, 4416}
FRAGMENT, ENTRY_POINT, INPUT = 4, 15, 1


class Divergence:
    """Which values and blocks may differ between the pixels of a quad."""

    def __init__(self, shader):
        self.shader = shader
        self.values, self.blocks, self.functions, self.returned = set(), set(), set(), set()
        self.roots = {}    # of pointers
        for id, variable in shader.variables.items():
            self.roots[id] = id
            if variable[3] == INPUT or not (shader.is_constant(id, ()) or variable[3] in READ_ONLY | {6}):
                self.values.add(id)
        size = -1
        while size != self.size():
            size = self.size()
            for function in shader.functions.values():
                self.walk(function)

    def size(self):
        return sum(map(len, (self.values, self.blocks, self.functions, self.returned)))

    def differs(self, operands):
        return any(operand in self.values for operand in operands)

    def walk(self, function):
        if function.id in self.functions:
            self.blocks.update((function.id, label) for label in function.sorted)
        for label in function.sorted:
            for instruction in function.blocks[label]:
                self.instruction(function, label, instruction)
            self.branch(function, label)

    def instruction(self, function, label, instruction):
        op, *operands = instruction
        alone = (function.id, label) in self.blocks
        if op in (Op.Store, Op.CopyMemory):
            if alone or self.differs(operands):
                self.values.add(self.roots.get(operands[0], operands[0]))
        elif op == Op.ReturnValue:
            if alone or self.differs(operands):
                self.returned.add(function.id)
        elif op == Op.FunctionCall:
            callee = self.shader.functions[operands[2]]
            for (parameter, _), argument in zip(callee.parameters, operands[3:]):
                # Arguments are variables of the call's own, which the callee may write.
                root = self.roots.get(argument, argument)
                if self.differs((argument, root)):
                    self.values.add(parameter)
                if parameter in self.values and root in self.roots:
                    self.values.add(root)
            if alone:
                self.functions.add(callee.id)
            if callee.id in self.returned:
                self.values.add(operands[1])
        elif op in (Op.AccessChain, Op.InBoundsAccessChain):
            self.roots[operands[1]] = self.roots.get(operands[2], operands[2])
            if self.differs(operands[2:]) or self.roots[operands[1]] in self.values:
                self.values.add(operands[1])
        elif op == Op.Variable:
            self.roots[operands[1]] = operands[1]
        elif op == Op.Phi:
            # Of && and ||: which way led here may differ as what decided it does.
            if self.differs(operands[2:]) or alone or any((function.id, origin) in self.blocks for origin in operands[3::2]):
                self.values.add(operands[1])
        elif len(operands) > 1 and operands[0] in self.shader.types:
            skipped = 4 if op == Op.ExtInst else 2
            if self.differs(operands[skipped:]) or op == Op.Load and self.roots.get(operands[2], operands[2]) in self.values or op in DERIVATIVES:
                self.values.add(operands[1])

    def branch(self, function, label):
        block = function.blocks[label]
        if block[-1][0] not in (Op.BranchConditional, Op.Switch) or not self.differs([block[-1][1]]):
            return
        merge = block[-2][1] if len(block) > 1 and block[-2][0] in (Op.SelectionMerge, Op.LoopMerge) else None
        loops = sorted((head for head, construct in function.loops.items() if label in construct), key=lambda head: -function.place[head])
        if merge is None or block[-2][0] == Op.LoopMerge:
            alone = set(function.loops[loops[0]]) if loops else set(function.sorted[function.place[label]:])
        else:
            inside = self.shader.between(function, label, merge)[1:]
            alone = set(inside)
            for at in inside + [label]:
                last = function.blocks[at][-1][0]
                if last in (Op.Return, Op.ReturnValue):
                    alone |= set(function.sorted[function.place[label] + 1:])
                    for head in loops:
                        alone |= function.loops[head]
                for to in function.successors[at]:
                    if to != merge and to not in inside:
                        left = [head for head in loops if to not in function.loops[head]] or loops[:1]
                        for head in left:
                            alone |= function.loops[head]
        self.blocks.update((function.id, at) for at in alone)


def undefined_derivatives(path):
    module = read(path)
    if not any(i[0] == ENTRY_POINT and i[1] == FRAGMENT for i in module.instructions):
        return []
    shader = Shader(module)
    divergence = Divergence(shader)
    lines = []
    for function in shader.functions.values():
        name = shader.name(function.id)
        for label in function.sorted:
            for instruction in function.blocks[label]:
                if instruction[0] in ENDINGS:
                    lines.append(f"{path}: {name}() discards, expected `demote`")
                if instruction[0] in DERIVATIVES and (function.id, label) in divergence.blocks:
                    lines.append(f"{path}: {name}() takes a derivative, or looks without a level, where pixels may go different ways")
    return list(dict.fromkeys(lines))


def main(paths):
    if not paths:
        print("defined_derivatives.py: no file, expected SPIR-V or headers of it", file=sys.stderr)
        return 2
    with multiprocessing.Pool() as pool:
        lines = [line for each in pool.map(undefined_derivatives, files(paths), chunksize=1) for line in each]
    print("\n".join(lines + [f"{len(lines)} places in which derivatives are undefined"]))
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
