"""Fails on a loop of a shader that no integer bounds.

    bounded_loops.py FILE...      each a .spv, or a header that glslangValidator wrote; @FILE lists such

A loop is bounded where a round ends in another one only under a comparison of an integer variable with a value that the loop
leaves alone, and where each round moves the variable towards that value by at least one. What floats say may end a loop
sooner, but never keeps it going.

It is an abstract interpretation. An integer is known as a symbol plus an interval, a boolean by the comparisons that hold where
it is true, and where it is false. At the head of a loop each variable that the loop writes is a symbol of its own. The paths to the
end of a round then say how far the variable has moved and which comparisons hold. Calls are followed. Memory other than a
function's own and a shader's private variables is taken for unknown, unless nobody can write it.
"""
import multiprocessing
import sys
from collections import namedtuple

from module import files, read
from shader import PRIVATE, Op, Shader

INFINITE = float("inf")
# An integer: a symbol, 0 being none, plus what lies in [low, high].
Int = namedtuple("Int", "symbol low high")
# A boolean: facts where it is true, facts where it is false. EVERYTHING where it cannot be.
Bool = namedtuple("Bool", "true false")
Pointer = namedtuple("Pointer", "root path exact")
# left + low relation right: of symbols' values in one round.
Fact = namedtuple("Fact", "symbol offset relation signed bound")
EVERYTHING = None
NOTHING = frozenset()

FLIPPED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
NEGATED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "holds": "fails", "fails": "holds"}
COMPARISONS = {
    Op.UGreaterThan: (">", False), Op.SGreaterThan: (">", True), Op.UGreaterThanEqual: (">=", False),
    Op.SGreaterThanEqual: (">=", True), Op.ULessThan: ("<", False), Op.SLessThan: ("<", True),
    Op.ULessThanEqual: ("<=", False), Op.SLessThanEqual: ("<=", True)}
# Conversions from floats, arithmetic, shifts and bits.
PURE = {109, 110} | set(range(126, 136)) | set(range(137, 143)) | set(range(194, 206)) | {Op.SpecConstantOp}
MINIMA, MAXIMA, CLAMPS = {38, 39}, {41, 42}, {44, 45}    # UMin and so on, of GLSL.std.450


def union(a, b):
    """What holds where both do."""
    if a is EVERYTHING or b is EVERYTHING:
        return EVERYTHING
    few, many = (a, b) if len(a) < len(b) else (b, a)
    if any(fact._replace(relation=NEGATED[fact.relation]) in many for fact in few):
        return EVERYTHING
    return a | b


def unknown_bool(key):
    return Bool(frozenset([Fact(key, 0, "holds", False, None)]), frozenset([Fact(key, 0, "fails", False, None)]))


def common(a, b):
    return b if a is EVERYTHING else a if b is EVERYTHING else a & b


def named(value, key):
    """With the fact that it is true, or false: where that is known, the other cannot be."""
    name = unknown_bool(key)
    return Bool(union(value.true, name.true), union(value.false, name.false))


class State:
    """At one place of a path: what variables hold, and the facts."""

    def __init__(self, memory, facts):
        self.memory, self.facts = memory, facts

    def copy(self):
        return State(dict(self.memory), self.facts)


class Analysis:
    def __init__(self, shader):
        self.shader = shader
        self.symbols, self.info = {}, [None]
        self.loops = ()    # that are being walked, calls included
        self.unbounded = []
        self.values = {}
        for id in shader.variables:
            self.values[id] = Pointer(id, (), True)
        for id in shader.constants:
            self.values[id] = self.constant(id)

    # ---- values

    def symbol(self, key, loops, limits=((), ())):
        """The same for the same key. `loops`: in whose rounds its value may differ; `limits`: what it is at most, at least."""
        if key not in self.symbols:
            self.symbols[key] = len(self.info)
            self.info.append((frozenset(loops), limits))
        return self.symbols[key]

    def unknown(self, shape, key, loops):
        if shape == "int":
            return Int(self.symbol(key, loops), 0, 0)
        if shape == "bool":
            return unknown_bool(key)
        if shape is None:
            return None
        return tuple(self.unknown(member, (key, i), loops) for i, member in enumerate(shape))

    def constant(self, id):
        op, type, _, *operands = self.shader.constants[id]
        shape = self.shader.shape(type)
        if op == Op.Constant and shape == "int":
            value = operands[0]
            signed = self.shader.types[type][3] == 1
            return Int(0, *[value - (1 << 32) if signed and value >> 31 else value] * 2)
        if op == Op.ConstantTrue:
            return Bool(NOTHING, EVERYTHING)
        if op == Op.ConstantFalse:
            return Bool(EVERYTHING, NOTHING)
        if op in (Op.ConstantComposite, Op.SpecConstantComposite) and isinstance(shape, list):
            return tuple(self.constant(part) if kind else None for part, kind in zip(operands, shape))
        if op == Op.ConstantNull and shape:
            return self.zero(shape)
        return self.unknown(shape, ("constant", id), ())

    def zero(self, shape):
        if isinstance(shape, list):
            return tuple(self.zero(member) for member in shape)
        return {"int": Int(0, 0, 0), "bool": Bool(EVERYTHING, NOTHING), None: None}[shape]

    def exact(self, value):
        return isinstance(value, Int) and value.low == value.high

    def varies(self, symbol):
        return self.info[symbol][0] if symbol else NOTHING

    def join(self, values, facts, key):
        """Of what holds one value or another, depending on the path by which it is come to."""
        first = values[0]
        if all(value is first or value == first for value in values[1:]):
            return first
        if any(value is None for value in values):
            return None
        if isinstance(first, Int):
            if all(value.symbol == first.symbol for value in values):
                return Int(first.symbol, min(v.low for v in values), max(v.high for v in values))
            return Int(self.symbol(key, self.loops), 0, 0)
        if isinstance(first, Bool):
            true, false = EVERYTHING, EVERYTHING
            for value, also in zip(values, facts):
                true, false = common(true, union(value.true, also)), common(false, union(value.false, also))
            return named(Bool(true, false), key)
        if isinstance(first, tuple) and not isinstance(first, Pointer):
            return tuple(self.join(parts, facts, (key, i)) for i, parts in enumerate(zip(*values)))
        return None

    def merged(self, states, key):
        states = [state for state in states if state is not None and state.facts is not EVERYTHING]
        if not states:
            return None
        if len(states) == 1:
            return states[0].copy()
        facts = states[0].facts
        for state in states[1:]:
            facts = facts & state.facts
        also = [state.facts for state in states]
        memory = {}
        for variable in states[0].memory:
            if all(variable in state.memory for state in states[1:]):
                memory[variable] = self.join([state.memory[variable] for state in states], also, (key, variable))
        return State(memory, facts)

    # ---- comparisons

    def compared(self, relation, signed, left, right):
        """What is known where it holds."""
        if not (isinstance(left, Int) and isinstance(right, Int)):
            return NOTHING
        facts = set()
        for a, b, way in ((left, right, relation), (right, left, FLIPPED[relation])):
            offset = a.low if way in ("<", "<=") else a.high
            bounds = [b]
            limits = self.info[b.symbol][1][0 if way in ("<", "<=") else 1] if b.symbol else ()
            bounds += [Int(limit.symbol, limit.low + b.low, limit.high + b.high) for limit in limits]
            for bound in bounds:
                far = bound.high if way in ("<", "<=") else bound.low
                if a.symbol and abs(offset) != INFINITE and abs(far) != INFINITE:
                    facts.add(Fact(a.symbol, offset, way, signed, (bound.symbol, far)))
        return frozenset(facts)

    def comparison(self, op, left, right):
        relation, signed = COMPARISONS[op]
        if self.exact(left) and self.exact(right) and left.symbol == right.symbol == 0:
            holds = {"<": left.low < right.low, "<=": left.low <= right.low, ">": left.low > right.low,
                     ">=": left.low >= right.low}[relation]
            return Bool(NOTHING, EVERYTHING) if holds else Bool(EVERYTHING, NOTHING)
        return Bool(self.compared(relation, signed, left, right), self.compared(NEGATED[relation], signed, left, right))

    # ---- instructions

    def added(self, a, b, sign):
        if not (isinstance(a, Int) and isinstance(b, Int)):
            return None
        if sign < 0 and b.symbol == a.symbol:
            return Int(0, a.low - b.high, a.high - b.low)
        if a.symbol == 0 and sign > 0:
            a, b = b, a
        if b.symbol != 0:
            return None
        if a.symbol and b.low == b.high >= 1 << 31:
            b = Int(0, b.low - (1 << 32), b.high - (1 << 32))    # of an unsigned, it is less that is added
        low, high = (b.low, b.high) if sign > 0 else (-b.high, -b.low)
        return Int(a.symbol, a.low + low, a.high + high)

    def pure(self, key, operands, shape):
        """Of the same operands the same: no loop changes what it does not change in them."""
        if isinstance(shape, list):
            return tuple(self.pure((key, i), [operand[i] if isinstance(operand, tuple) and not isinstance(operand, Int) else operand
                                              for operand in operands], part) for i, part in enumerate(shape))
        if shape != "int" or not all(isinstance(operand, Int) for operand in operands):
            return None
        loops = frozenset().union(*(self.varies(operand.symbol) for operand in operands))
        return Int(self.symbol(("pure", key, tuple(operands)), loops), 0, 0)

    def each(self, function, a, b, sign):
        if isinstance(a, tuple) and not isinstance(a, Int):
            parts = tuple(self.each(function, x, y, sign) for x, y in zip(a, b))
            return parts if all(part is not None for part in parts) else None
        return function(a, b, sign)

    def limited(self, kind, operands, shape):
        """min, max and clamp of integers, which are at most or at least something."""
        if isinstance(shape, list):
            parts = [self.limited(kind, [operand[i] if operand is not None else None for operand in operands], part)
                     for i, part in enumerate(shape)]
            return tuple(parts)
        known = [operand for operand in operands if isinstance(operand, Int)]
        at_most = known if kind in MINIMA else [operands[2]] if kind in CLAMPS and isinstance(operands[2], Int) else []
        at_least = known if kind in MAXIMA else [operands[1]] if kind in CLAMPS and isinstance(operands[1], Int) else []
        loops = frozenset().union(*(self.varies(operand.symbol) for operand in known)) if len(known) == len(operands) else self.loops
        return Int(self.symbol(("limited", kind, tuple(operands), () if len(known) == len(operands) else self.place), loops,
                               (tuple(at_most), tuple(at_least))), 0, 0)

    def part(self, value, path):
        for index in path:
            if not isinstance(value, tuple) or isinstance(value, (Int, Bool, Pointer)):
                return None
            value = value[index]
        return value

    def with_part(self, value, path, new):
        if not path:
            return new
        if not isinstance(value, tuple) or isinstance(value, (Int, Bool, Pointer)):
            return value
        return value[:path[0]] + (self.with_part(value[path[0]], path[1:], new),) + value[path[0] + 1:]

    def shape_at(self, type, path):
        for index in path:
            op, _, *operands = self.shader.types[type]
            type = operands[index] if op == Op.TypeStruct else operands[0]
        return self.shader.shape(type)

    def load(self, pointer, shape, state):
        if isinstance(pointer, Pointer):
            if pointer.root in state.memory:
                value = self.part(state.memory[pointer.root], pointer.path) if pointer.exact else None
                if value is not None:
                    return value
            elif pointer.root in self.shader.variables and self.shader.is_constant(pointer.root, pointer.path):
                if all(isinstance(index, int) or not self.varies(index.symbol) for index in pointer.path):
                    # A float, too, may be made an integer, a loop's bound.
                    return self.unknown(shape or "int", ("read only", pointer.root, pointer.path), ())
        return self.unknown(shape, self.place, self.loops)

    def store(self, pointer, value, state):
        if not isinstance(pointer, Pointer) or pointer.root not in state.memory:
            return
        old = state.memory[pointer.root]
        if old is None:
            return
        shape = self.shape_of_value(self.part(old, pointer.path))
        if value is None or not pointer.exact:
            value = self.unknown(shape, self.place, self.loops)
        state.memory[pointer.root] = self.with_part(old, pointer.path, value)

    def shape_of_value(self, value):
        if isinstance(value, Int):
            return "int"
        if isinstance(value, Bool):
            return "bool"
        if isinstance(value, tuple) and not isinstance(value, Pointer):
            return [self.shape_of_value(part) for part in value]
        return None

    def filled(self, value, shape):
        """With symbols where an instruction leaves unknown what is followed."""
        if shape is None:
            return None
        if value is None:
            return self.unknown(shape, self.place, self.loops)
        if isinstance(shape, list):
            outer, parts = self.place, []
            for i, (part, kind) in enumerate(zip(value, shape)):
                self.place = (outer, i)
                parts.append(self.filled(part, kind))
            self.place = outer
            return tuple(parts)
        return value

    def evaluate(self, instruction, context, state):
        op, type, id, *operands = instruction
        values = self.values
        self.place = (context, id)
        if op == Op.Variable:
            root = (context, id)
            shape = self.shader.shape(self.shader.pointee(type))
            state.memory[root] = self.unknown(shape, (root, "undefined"), self.loops)
            if len(operands) > 1:
                state.memory[root] = values.get(operands[1], state.memory[root])
            return Pointer(root, (), True)
        if op in (Op.AccessChain, Op.InBoundsAccessChain):
            return self.chained(values.get(operands[0]), operands[1:])
        if op == Op.FunctionCall:
            return self.called(type, operands[0], [values.get(operand) for operand in operands[1:]], state)
        shape = self.shader.shape(type)
        if op == Op.Load:
            return self.load(values.get(operands[0]), shape, state)
        if shape is None:
            return None
        if op == Op.Phi:
            return values.get(id)    # the edges' work
        given = [values.get(operand) for operand in operands]
        return self.filled(self.computed(op, given, operands, shape), shape)

    def computed(self, op, given, operands, shape):
        if op in (Op.IAdd, Op.ISub):
            sum = self.each(self.added, *given, 1 if op == Op.IAdd else -1) if None not in given else None
            return sum if sum is not None else self.pure(op, given, shape)
        if op in (Op.Bitcast, Op.CopyObject):
            return given[0] if self.shape_of_value(given[0]) == shape else None
        if op in COMPARISONS and shape == "bool":
            return self.comparison(op, *given)
        if op == Op.LogicalNot and shape == "bool":
            return Bool(given[0].false, given[0].true)
        if op == Op.LogicalAnd and shape == "bool":
            return named(Bool(union(given[0].true, given[1].true), common(given[0].false, given[1].false)), self.place)
        if op == Op.LogicalOr and shape == "bool":
            return named(Bool(common(given[0].true, given[1].true), union(given[0].false, given[1].false)), self.place)
        if op == Op.Select and isinstance(given[0], Bool):
            return self.join(given[1:], (given[0].true, given[0].false), self.place)
        if op == Op.CompositeConstruct:
            parts = []
            for value in given:
                # Vectors may be made of vectors.
                parts += value if len(given) < len(shape) and self.shape_of_value(value).__class__ is list else [value]
            return tuple(parts) if len(parts) == len(shape) else None
        if op == Op.CompositeExtract:
            return self.part(given[0], operands[1:])
        if op == Op.CompositeInsert:
            return self.with_part(given[1], operands[2:], given[0])
        if op == Op.VectorShuffle and None not in given[:2]:
            both = given[0] + given[1]
            return tuple(both[i] if i < len(both) else None for i in operands[2:])
        if op == Op.ExtInst and operands[1] in MINIMA | MAXIMA | CLAMPS:
            return self.limited(operands[1], given[2:], shape)
        if op in PURE:
            return self.pure(op, given, shape)
        return None

    def chained(self, base, indices):
        if not isinstance(base, Pointer):
            return None
        path, exact = list(base.path), base.exact
        for index in indices:
            value = self.values.get(index)
            if self.exact(value) and value.symbol == 0:
                path.append(int(value.low))
            elif base.root in self.shader.variables and self.shader.variables[base.root][3] != PRIVATE and isinstance(value, Int):
                path.append(value)
            else:
                exact = False    # the whole of what is indexed
                break
        # Of arrays nothing is followed.
        return Pointer(base.root, tuple(path), exact)

    # ---- control flow

    def called(self, type, callee, arguments, state):
        place = self.place
        function = self.shader.functions[callee]
        shape = self.shader.shape(type)
        pointers = [argument for argument in arguments if isinstance(argument, Pointer) and argument.root in state.memory
                    and state.memory[argument.root] is not None]
        privates = [root for root in self.shader.writes_private(callee) if state.memory.get(root) is not None]
        if self.loops and (shape is not None or pointers or privates):
            saved = dict(self.values)
            for (parameter, _), argument in zip(function.parameters, arguments):
                self.values[parameter] = argument
            after, value = self.walk(function, place, state)
            self.values, self.place = saved, place
            if after is None:
                state.facts = EVERYTHING
            else:
                # What was the callee's own is gone.
                state.memory = {root: after.memory.get(root, old) for root, old in state.memory.items()}
                state.facts = after.facts
            return self.filled(value, shape)
        for pointer in pointers:
            self.place = (place, pointer)
            self.store(pointer, None, state)
        for root in privates:
            self.place = (place, root)
            self.store(Pointer(root, (), True), None, state)
        self.place = place
        return self.unknown(shape, place, self.loops)

    def walk(self, function, context, state):
        """Through a whole function; the state and the value where it returns."""
        edges, returns = {(None, function.sorted[0]): state.copy()}, []
        self.region(function, function.sorted, None, context, edges, returns)
        merged = self.merged([after for after, _ in returns], (context, "return"))
        live = [(after, value) for after, value in returns if after.facts is not EVERYTHING]
        if merged is None:
            return None, None
        return merged, self.join([value for _, value in live], [after.facts for after, _ in live], (context, "returned"))

    def region(self, function, blocks, head, context, edges, returns):
        done = set()
        for label in blocks:
            if label in done:
                continue
            if label in function.loops and label != head:
                self.loop(function, label, context, edges, returns)
                done |= function.loops[label]
                continue
            self.block(function, label, context, edges, returns)

    def incoming(self, label, edges, without=()):
        return [(origin, state) for (origin, to), state in edges.items() if to == label and origin not in without]

    def block(self, function, label, context, edges, returns):
        incoming = [(origin, state) for origin, state in self.incoming(label, edges) if state.facts is not EVERYTHING]
        block = function.blocks[label]
        if len(incoming) > 1 and block[0][0] == Op.Phi and block[-1][0] == Op.BranchConditional:
            # The end of && or ||: each way that leads here decides for itself where it leads on to.
            ways = []
            for way in incoming:
                ways.append({})
                self.straight(function, label, context, [way], ways[-1], returns)
            for to in set(function.successors[label]):
                state = self.merged([way.get((label, to)) for way in ways], (context, label, to))
                if state is not None:
                    edges[label, to] = state
            edges = {}
        self.straight(function, label, context, incoming, edges, returns)

    def straight(self, function, label, context, incoming, edges, returns):
        state = self.merged([state for _, state in incoming], (context, label))
        if state is None:
            return
        for instruction in function.blocks[label]:
            op = instruction[0]
            if op == Op.Store:
                self.place = (context, label, instruction)
                self.store(self.values.get(instruction[1]), self.values.get(instruction[2]), state)
            elif op == Op.CopyMemory:
                self.place = (context, label, instruction)
                self.store(self.values.get(instruction[1]), None, state)
            elif op == Op.Phi:
                self.values[instruction[2]] = self.phi(instruction, context, incoming)
            elif op in (Op.Return, Op.ReturnValue):
                returns.append((state, self.values.get(instruction[1]) if op == Op.ReturnValue else None))
            elif op == Op.Branch:
                edges[label, instruction[1]] = state
            elif op == Op.BranchConditional:
                condition = self.values.get(instruction[1])
                condition = condition if isinstance(condition, Bool) else unknown_bool((context, instruction[1]))
                for to, facts in ((instruction[2], condition.true), (instruction[3], condition.false)):
                    edges[label, to] = State(dict(state.memory), union(state.facts, facts))
            elif op == Op.Switch:
                for to in set(function.successors[label]):
                    edges[label, to] = state.copy()
            elif len(instruction) > 2 and op not in (Op.LoopMerge, Op.SelectionMerge) and instruction[1] in self.shader.types:
                self.values[instruction[2]] = self.evaluate(instruction, context, state)
                if state.facts is EVERYTHING:
                    return

    def phi(self, instruction, context, incoming):
        _, type, id, *pairs = instruction
        states = dict(incoming)
        came = [(self.values.get(value), states[origin].facts) for value, origin in zip(pairs[::2], pairs[1::2])
                if states.get(origin) is not None and states[origin].facts is not EVERYTHING]
        self.place = (context, id)
        if not came or any(value is None for value, _ in came):
            return self.filled(None, self.shader.shape(type))
        return self.join([value for value, _ in came], [facts for _, facts in came], self.place)

    def loop(self, function, head, context, edges, returns):
        construct = function.loops[head]
        blocks = [label for label in function.sorted if label in construct]
        entry = self.merged([state for origin, state in self.incoming(head, edges) if origin not in construct], (context, head, "entry"))
        if entry is None:
            return
        name = (context, head)
        outside = {edge: state for edge, state in edges.items()}
        varied = set()
        self.loops += (name,)
        while True:
            start = State({root: self.headed(value, (name, root), varied) for root, value in entry.memory.items()}, entry.facts)
            inside = {(None, head): start}
            left = []
            self.region(function, blocks, head, context, inside, left)
            back = self.merged([state for origin, state in self.incoming(head, inside, (None,))], (context, head, "back"))
            found = set()
            if back is not None:
                for root, value in start.memory.items():
                    self.changed(value, back.memory.get(root), (name, root), found)
            if found <= varied:
                break
            varied |= found
        self.loops = self.loops[:-1]
        moved = {}
        if back is not None:
            for root, value in start.memory.items():
                self.moves(value, back.memory.get(root), entry.memory[root], (name, root), moved)
            if context == () and not self.is_bounded(name, moved, back.facts):
                self.unbounded.append((function.id, head, self.why(function, name, moved, back.facts)))
        # Behind the loop a variable that only rose is what it was, or more.
        for edge, state in inside.items():
            if edge[0] is not None and edge[1] not in construct:
                outside[edge] = self.settled(state, moved)
        returns += [(self.settled(state, moved), value) for state, value in left]
        edges.update(outside)

    def headed(self, value, key, varied):
        if isinstance(value, Int):
            return Int(self.symbol(key, self.loops), 0, 0) if key in varied else value
        if isinstance(value, Bool):
            return unknown_bool(key) if key in varied else value
        if isinstance(value, tuple) and not isinstance(value, Pointer):
            return tuple(self.headed(part, (key, i), varied) for i, part in enumerate(value))
        return value

    def changed(self, before, after, key, found):
        if isinstance(before, (Int, Bool)):
            if before != after:
                found.add(key)
        elif isinstance(before, tuple) and not isinstance(before, Pointer):
            for i, (x, y) in enumerate(zip(before, after)):
                self.changed(x, y, (key, i), found)

    def moves(self, before, after, entry, key, moved):
        """By how much a round moves each variable that it moves by something known."""
        if isinstance(before, Int):
            if before.symbol == self.symbols.get(key) and isinstance(after, Int) and after.symbol == before.symbol:
                moved[before.symbol] = (after.low, after.high, entry)
        elif isinstance(before, tuple) and not isinstance(before, (Bool, Pointer)):
            for i, (x, y, z) in enumerate(zip(before, after, entry)):
                self.moves(x, y, z, (key, i), moved)

    def settled(self, state, moved):
        def of(value):
            if isinstance(value, Int) and value.symbol in moved:
                low, high, entry = moved[value.symbol]
                if low >= 0:
                    return Int(entry.symbol, entry.low + value.low, INFINITE)
                if high <= 0:
                    return Int(entry.symbol, -INFINITE, entry.high + value.high)
            elif isinstance(value, tuple) and not isinstance(value, (Int, Bool, Pointer)):
                return tuple(of(part) for part in value)
            return value
        return State({root: of(value) for root, value in state.memory.items()}, state.facts)

    # ---- the verdict

    def is_bounded(self, name, moved, facts):
        if facts is EVERYTHING:
            return True
        return any(self.bounds(name, moved, fact) for fact in facts)

    def bounds(self, name, moved, fact):
        if fact.symbol not in moved:
            return False
        symbol, far = fact.bound
        if name in self.varies(symbol):
            return False
        low, high, _ = moved[fact.symbol]
        if fact.relation in ("<", "<="):
            most = 2**31 - 1 if fact.signed else 2**32 - 1
            return low > 0 and not (symbol == 0 and fact.relation == "<=" and far >= most)
        if not fact.signed:
            # Unsigned, it must not step over 0.
            return high == low == -1 and fact.offset >= 0 and (fact.relation == ">" or symbol == 0 and far > 0)
        return high < 0 and not (symbol == 0 and fact.relation == ">=" and far <= -2**31)

    def why(self, function, name, moved, facts):
        told = []
        for fact in sorted((fact for fact in facts if fact.bound), key=str):
            variable = next((key for key, symbol in self.symbols.items() if symbol == fact.symbol and key[0] == name or
                             symbol == fact.symbol and isinstance(key[0], tuple) and key[0] and key[0][0] == name), None)
            if variable is None:
                continue
            called = self.called_by_name(variable)
            if fact.symbol not in moved:
                told.append(f"{called} is compared, but not moved by a constant on every path")
            elif name in self.varies(fact.bound[0]):
                told.append(f"{called} is compared with what changes in the loop")
            else:
                low, high, _ = moved[fact.symbol]
                told.append(f"{called} has to be {fact.relation} its bound, but moves by {low}" + (f" to {high}" if high > low else ""))
        return "; ".join(dict.fromkeys(told)) or "no comparison of an integer that the loop moves is needed for another round"

    def called_by_name(self, key):
        """Of a variable, or of what of it, as the source has it."""
        path = []
        while not (isinstance(key[0], tuple) and len(key[0]) == 2 and key[0][0] == ()):
            path.append(key[1])
            key = key[0]
        root = key[1][1] if isinstance(key[1], tuple) else key[1]
        name, type = self.shader.name(root), self.shader.pointee(self.shader.type_of[root])
        for index in reversed(path):
            op, _, *members = self.shader.types[type]
            name += "." + (str(self.shader.names.get((type, index), index)) if op == Op.TypeStruct else "xyzw"[index])
            type = members[index] if op == Op.TypeStruct else members[0]
        return name

    def function(self, function):
        memory = {}
        for id, (_, type, _, storage, *_) in self.shader.variables.items():
            if storage == PRIVATE:
                memory[id] = self.unknown(self.shader.shape(self.shader.pointee(type)), ("private", id), ())
        for id, type in function.parameters:
            if self.shader.types[type][0] == Op.TypePointer:
                shape = self.shader.shape(self.shader.pointee(type))
                memory[(), id] = self.unknown(shape, ("parameter", id), ())
                self.values[id] = Pointer(((), id), (), True)
            else:
                self.values[id] = self.unknown(self.shader.shape(type), ("parameter", id), ())
        self.walk(function, (), State(memory, NOTHING))


def unbounded_loops(path):
    """How many loops there are, and a line for each that is not bounded."""
    shader = Shader(read(path))
    count, lines = 0, []
    for function in shader.functions.values():
        if not function.loops:
            continue
        analysis = Analysis(shader)
        analysis.function(function)
        heads = [label for label in function.order if label in function.loops]
        count += len(heads)
        told = {head: why for _, head, why in analysis.unbounded}
        for i, head in enumerate(heads):
            if head in told:
                which = f"loop {i + 1} of {len(heads)}" if len(heads) > 1 else "the loop"
                lines.append(f"{path}: {shader.name(function.id)}(), {which}: {told[head]}")
    return count, lines


def main(paths):
    if not paths:
        print("bounded_loops.py: no file, expected SPIR-V or headers of it", file=sys.stderr)
        return 2
    paths = files(paths)
    with multiprocessing.Pool() as pool:
        results = pool.map(unbounded_loops, paths, chunksize=1)
    lines = [line for _, each in results for line in each]
    print("\n".join(lines + [f"{sum(count for count, _ in results)} loops in {len(paths)} shaders, {len(lines)} not bounded"]))
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
