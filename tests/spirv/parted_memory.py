"""Fails on memory that a workgroup shares and that no barrier parts: what one invocation reads while another may yet write it, or
writes while another may yet read it.

    parted_memory.py FILE...      each a .spv, or a header that glslangValidator wrote; @FILE lists such

Devices that run a workgroup's invocations one after another, as CPU devices do, show nothing of a barrier that is missing. What may
have been done to a variable since the last barrier is followed along all paths, calls included. A variable is taken as a whole;
of an array of two, of which one is written while the other is read, it is not asked that reads are over before it is written.
"""
import multiprocessing
import sys

from module import Op, files, read
from shader import Shader

WORKGROUP = 4
CONTROL_BARRIER = 224
READ, WRITTEN = 1, 2


class Analysis:
    def __init__(self, shader):
        self.shader = shader
        self.shared = [id for id, (_, _, _, storage, *_) in shader.variables.items() if storage == WORKGROUP]
        self.known, self.faults = {}, {}

    def turns(self, variable):
        """Whether it is an array of two."""
        op, _, *operands = self.shader.types[self.shader.pointee(self.shader.type_of[variable])]
        return op == Op.TypeArray and self.shader.constants[operands[1]][3] == 2

    def access(self, function, variable, kind, state):
        before = state[variable]
        if kind == READ and before & WRITTEN:
            self.faults[function.id, variable, "read before all have written it"] = True
        if kind == WRITTEN and before & READ and not self.turns(variable):
            self.faults[function.id, variable, "written before all have read it"] = True
        state[variable] = before | kind

    def block(self, function, block, state, roots):
        """The state behind it; pointers into shared variables are noted in `roots`."""
        for instruction in block:
            op = instruction[0]
            if op in (Op.AccessChain, Op.InBoundsAccessChain) and instruction[3] in roots:
                roots[instruction[2]] = roots[instruction[3]]
            elif op == Op.Load and instruction[3] in roots:
                self.access(function, roots[instruction[3]], READ, state)
            elif op == Op.Store and instruction[1] in roots:
                self.access(function, roots[instruction[1]], WRITTEN, state)
            elif op == CONTROL_BARRIER:
                state = dict.fromkeys(state, 0)
            elif op == Op.FunctionCall:
                state = self.function(self.shader.functions[instruction[3]], state)
        return state

    def function(self, function, entry):
        """The state where it returns."""
        key = function.id, tuple(sorted(entry.items()))
        if key in self.known:
            return dict(self.known[key])
        roots = {variable: variable for variable in self.shared}
        before = {function.order[0]: entry}
        returned = dict.fromkeys(entry, 0)
        waiting = [function.order[0]]
        while waiting:
            label = waiting.pop()
            after = self.block(function, function.blocks[label], dict(before[label]), roots)
            if function.blocks[label][-1][0] in (Op.Return, Op.ReturnValue):
                returned = {variable: returned[variable] | after[variable] for variable in returned}
            for to in function.successors[label]:
                joined = {variable: before.get(to, after)[variable] | after[variable] for variable in after}
                if before.get(to) != joined:
                    before[to] = joined
                    waiting.append(to)
        self.known[key] = returned
        return dict(returned)


def unparted_memory(path):
    """A line for each function that reads or writes too early."""
    shader = Shader(read(path))
    analysis = Analysis(shader)
    if not analysis.shared:
        return []
    called = {i[3] for f in shader.functions.values() for block in f.blocks.values() for i in block if i[0] == Op.FunctionCall}
    for function in shader.functions.values():
        if function.id not in called:
            analysis.function(function, dict.fromkeys(analysis.shared, 0))
    return [f"{path}: {shader.name(function)}(): {shader.name(variable)} is {why}" for function, variable, why in analysis.faults]


def main(paths):
    if not paths:
        print("parted_memory.py: no file, expected SPIR-V or headers of it", file=sys.stderr)
        return 2
    paths = files(paths)
    with multiprocessing.Pool() as pool:
        lines = [line for each in pool.map(unparted_memory, paths, chunksize=1) for line in each]
    print("\n".join(lines + [f"{len(paths)} shaders, {len(lines)} places without a barrier"]))
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
