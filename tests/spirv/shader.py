"""A module of SPIR-V as analyses walk it: functions, their blocks in order, and the loops of these."""
from module import Op, text

PRIVATE = 6
READ_ONLY = {0, 1, 9}    # UniformConstant, Input, PushConstant
UNIFORM, STORAGE_BUFFER = 2, 12
NON_WRITABLE, BUFFER_BLOCK = 24, 3    # decorations


class Function:
    def __init__(self, instruction):
        self.id, self.type = instruction[2], instruction[1]
        self.parameters = []
        self.blocks = {}    # by label, without it
        self.order = []     # as written; `sorted`: what leads to a block before it


class Shader:
    """By functions and their blocks."""

    def __init__(self, module):
        self.names, self.types, self.constants, self.variables, self.functions = {}, {}, {}, {}, {}
        self.type_of, self.unwritable, self.buffer_blocks = {}, set(), set()
        function, block = None, None
        for instruction in module.instructions:
            op = instruction[0]
            if op == Op.Name:
                self.names[instruction[1]] = text(instruction[2:])
            elif op == Op.MemberName:
                self.names[instruction[1], instruction[2]] = text(instruction[3:])
            elif op == Op.Decorate and instruction[2] == NON_WRITABLE:
                self.unwritable.add(instruction[1])
            elif op == Op.Decorate and instruction[2] == BUFFER_BLOCK:
                self.buffer_blocks.add(instruction[1])
            elif op == Op.MemberDecorate and instruction[3] == NON_WRITABLE:
                self.unwritable.add((instruction[1], instruction[2]))
            elif Op.TypeVoid <= op <= Op.TypeFunction:
                self.types[instruction[1]] = instruction
            elif op in (Op.ConstantTrue, Op.ConstantFalse, Op.Constant, Op.ConstantComposite, Op.ConstantNull, Op.Undef) or \
                    Op.SpecConstantTrue <= op <= Op.SpecConstantOp:
                if function is None:
                    self.constants[instruction[2]] = instruction
                else:
                    block.append(instruction)
            elif op == Op.Function:
                function = Function(instruction)
                self.functions[function.id] = function
            elif op == Op.FunctionParameter:
                function.parameters.append((instruction[2], instruction[1]))
                self.type_of[instruction[2]] = instruction[1]
            elif op == Op.FunctionEnd:
                function = None
            elif op == Op.Label:
                block = []
                function.blocks[instruction[1]] = block
                function.order.append(instruction[1])
            elif op == Op.Variable:
                self.type_of[instruction[2]] = instruction[1]
                if function is None:
                    self.variables[instruction[2]] = instruction
                else:
                    block.append(instruction)
            elif function is not None:
                block.append(instruction)
        self.shapes = {}
        for function in self.functions.values():
            self.connect(function)
        self.private_written = {}

    def name(self, id):
        return self.names.get(id, f"%{id}").split("(")[0]

    def shape(self, type):
        """Of what is followed: "int", "bool", a list of members, or None for all else."""
        if type not in self.shapes:
            op, _, *operands = self.types[type]
            shape = None
            if op == Op.TypeInt:
                shape = "int"
            elif op == Op.TypeBool:
                shape = "bool"
            elif op == Op.TypeVector:
                shape = [self.shape(operands[0])] * operands[1]
            elif op == Op.TypeStruct:
                shape = [self.shape(member) for member in operands]
            if isinstance(shape, list) and not any(shape):
                shape = None
            self.shapes[type] = shape
        return self.shapes[type]

    def pointee(self, type):
        return self.types[type][3]

    def is_constant(self, variable, path):
        """Whether nobody writes that part of it while the shader runs."""
        _, type, _, storage, *_ = self.variables[variable]
        type = self.pointee(type)
        if storage in READ_ONLY or storage == UNIFORM and type not in self.buffer_blocks:
            return True
        if storage not in (UNIFORM, STORAGE_BUFFER):
            return False
        return variable in self.unwritable or bool(path) and (type, path[0]) in self.unwritable

    def connect(self, function):
        """Orders the blocks so that all but the ends of rounds go forward, and finds each loop's own."""
        successors = {}
        for label, block in function.blocks.items():
            last = block[-1]
            if last[0] == Op.Branch:
                successors[label] = [last[1]]
            elif last[0] == Op.BranchConditional:
                successors[label] = list(last[2:4])
            elif last[0] == Op.Switch:
                successors[label] = [last[2], *last[4::2]]
            else:
                successors[label] = []
        function.successors = successors
        merges = {label: block[-2][1:3] for label, block in function.blocks.items()
                  if len(block) > 1 and block[-2][0] == Op.LoopMerge}
        seen, after = set(), []
        # What lies behind a loop is gone to first, and so comes last.
        stack = [(function.order[0], iter(self.first_merge(function, merges, function.order[0], successors)))]
        seen.add(function.order[0])
        while stack:
            label, following = stack[-1]
            next_one = next((to for to in following if to not in seen), None)
            if next_one is None:
                after.append(label)
                stack.pop()
            else:
                seen.add(next_one)
                stack.append((next_one, iter(self.first_merge(function, merges, next_one, successors))))
        function.sorted = after[::-1]
        function.place = place = {label: i for i, label in enumerate(function.sorted)}
        # All between a loop's head and its merge belongs to its construct.
        function.loops = {label: set(self.between(function, label, merge)) for label, (merge, _) in merges.items() if label in place}

    def between(self, function, head, merge):
        """The blocks of a construct, in order."""
        return function.sorted[function.place[head]:function.place.get(merge, len(function.sorted))]

    @staticmethod
    def first_merge(function, merges, label, successors):
        block = function.blocks[label]
        merge = [block[-2][1]] if len(block) > 1 and block[-2][0] in (Op.LoopMerge, Op.SelectionMerge) else []
        going_on = [block[-2][2]] if merge and block[-2][0] == Op.LoopMerge else []
        return merge + going_on + successors[label]

    def writes_private(self, function):
        """Which private variables it may write, or what it calls."""
        if function not in self.private_written:
            self.private_written[function] = written = set()
            chains = {}
            for block in self.functions[function].blocks.values():
                for instruction in block:
                    if instruction[0] in (Op.AccessChain, Op.InBoundsAccessChain):
                        chains[instruction[2]] = chains.get(instruction[3], instruction[3])
                    elif instruction[0] in (Op.Store, Op.CopyMemory):
                        root = chains.get(instruction[1], instruction[1])
                        if root in self.variables and self.variables[root][3] == PRIVATE:
                            written.add(root)
                    elif instruction[0] == Op.FunctionCall:
                        written |= self.writes_private(instruction[3])
                        for argument in instruction[4:]:
                            root = chains.get(argument, argument)
                            if root in self.variables and self.variables[root][3] == PRIVATE:
                                written.add(root)
        return self.private_written[function]
