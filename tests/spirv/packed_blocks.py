"""Names members of uniform blocks before which std140 leaves a hole: C++, which shares the blocks (shaders/shared), leaves none.

    packed_blocks.py FILE...   SPIR-V, headers of it, or @LIST
"""
import sys

from module import Op, files, read, text

UNIFORM = 2
ARRAY_STRIDE, MATRIX_STRIDE, OFFSET = 6, 7, 35


class Layout:
    """Of one module: how large types are, and where members lie."""

    def __init__(self, module):
        self.types, self.names, self.decorations, self.constants, self.blocks = {}, {}, {}, {}, {}
        for op, *operands in module.instructions:
            if op == Op.Name:
                self.names[operands[0]] = text(operands[1:])
            elif op == Op.MemberName:
                self.names[operands[0], operands[1]] = text(operands[2:])
            elif op == Op.Decorate:
                self.decorations[operands[0], operands[1]] = operands[2:]
            elif op == Op.MemberDecorate:
                self.decorations[operands[0], operands[1], operands[2]] = operands[3:]
            elif Op.TypeVoid <= op <= Op.TypeFunction:
                self.types[operands[0]] = (op, *operands[1:])
            elif op == Op.Constant:
                self.constants[operands[1]] = operands[2]
            elif op == Op.Variable and operands[2] == UNIFORM:
                self.blocks[operands[1]] = self.types[operands[0]][2]

    def size(self, type, columns=None):
        """In bytes, without what fills it up. `columns`: how far those of a matrix lie apart."""
        op, *operands = self.types[type]
        if op in (Op.TypeInt, Op.TypeFloat):
            return operands[0] // 8
        if op == Op.TypeVector:
            return self.size(operands[0]) * operands[1]
        if op == Op.TypeMatrix:
            return columns * operands[1]
        if op == Op.TypeArray:
            return self.decorations[type, ARRAY_STRIDE][0] * self.constants[operands[1]]
        assert op == Op.TypeStruct, op
        return max(self.offset(type, i) + self.member(type, i) for i in range(len(operands)))

    def offset(self, struct, index):
        return self.decorations[struct, index, OFFSET][0]

    def columns(self, struct, index):
        return self.decorations.get((struct, index, MATRIX_STRIDE), [None])[0]

    def member(self, struct, index):
        return self.size(self.types[struct][1 + index], self.columns(struct, index))

    def holes(self, type, name, columns=None):
        """Lines, one a hole. `columns`: how far those of a matrix lie apart."""
        op, *operands = self.types[type]
        if op == Op.TypeMatrix and columns != self.size(operands[0]):
            yield f"{name}: columns of {self.size(operands[0])} bytes lie {columns} apart"
        if op == Op.TypeArray:
            element, stride = self.size(operands[0], columns), self.decorations[type, ARRAY_STRIDE][0]
            if stride != element:
                yield f"{name}: elements of {element} bytes lie {stride} apart"
            yield from self.holes(operands[0], name, columns)
        if op == Op.TypeStruct:
            yield from self.holes_of_members(type, name)

    def holes_of_members(self, struct, name):
        end = 0
        for i, member in enumerate(self.types[struct][1:]):
            called = f"{name}.{self.names.get((struct, i), i)}"
            if self.offset(struct, i) != end:
                yield f"{called}: begins at {self.offset(struct, i)}, the one before it ends at {end}"
            yield from self.holes(member, called, self.columns(struct, i))
            end = self.offset(struct, i) + self.member(struct, i)
        if end % 16 != 0:
            yield f"{name}: ends at {end}, expected a multiple of 16"


def holes_of(path):
    layout = Layout(read(path))
    blocks = list(layout.blocks.values())
    return [f"{path}: {line}" for type in blocks for line in layout.holes(type, layout.names.get(type, f"%{type}"))]


def main(paths):
    if not paths:
        print("packed_blocks.py: no file, expected SPIR-V or headers of it", file=sys.stderr)
        return 2
    paths = files(paths)
    lines = [line for path in paths for line in holes_of(path)]
    print("\n".join(lines + [f"{len(paths)} shaders, {len(lines)} holes"]))
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
