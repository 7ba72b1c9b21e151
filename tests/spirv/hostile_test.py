"""hostile_arithmetic.py changes what it says, in the functions of planted/arithmetic.comp, and leaves valid SPIR-V.

    hostile_test.py GLSLANG SPIRV-OPT SPIRV-VAL
"""
import pathlib
import subprocess
import sys
import tempfile

import hostile_arithmetic
from hostile_arithmetic import CONVERT, NCLAMP, NMAX, NMIN
from module import Op, read, text

SOURCE = pathlib.Path(__file__).parent / "planted" / "arithmetic.comp"
SATURATED = {Op.FOrdGreaterThanEqual: 1, Op.FOrdLessThanEqual: 1}
BY_NAN = {Op.IsNan: 2, Op.Select: 2}
# How often an operation is in a function, and in the mode alone that is named.
EXPECTED = {
    "fused": {CONVERT: 4},
    "fusedTwice": {CONVERT: 8},
    "kept": {CONVERT: 0, Op.IEqual: 2},    # but flushed, the product and the sum
    "dotted": {CONVERT: 12, Op.IEqual: 1},
    "least": {"other": {NMIN: 1}, "nan": BY_NAN},
    "most": {"other": {NMAX: 1}, "nan": BY_NAN},
    "held": {"other": {NCLAMP: 1}, "nan": {Op.IsNan: 4, Op.Select: 4}},
    "whole": SATURATED,
    "wholeOrMore": SATURATED,
}


def counts(path):
    """Of operations, and of GLSL's functions, by function."""
    names, found, here = {}, {}, None
    for op, *operands in read(path).instructions:
        if op == Op.Name:
            names[operands[0]] = text(operands[1:]).split("(")[0]
        elif op == Op.Function:
            here = found[names[operands[1]]] = {}
        elif here is not None:
            what = operands[3] if op == Op.ExtInst else op
            here[what] = here.get(what, 0) + 1
    return found


def main(glslang, optimizer, validator):
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for mode in ("other", "nan"):
            header, binary = f"{folder}/{mode}.h", f"{folder}/{mode}.spv"
            subprocess.run([glslang, "--quiet", "-V", "--target-env", "vulkan1.2", "--vn", "arithmetic_comp", "-o", header, SOURCE],
                           check=True)
            hostile_arithmetic.main(mode, optimizer, header)
            with open(binary, "wb") as file:
                file.write(read(header).words().tobytes())
            subprocess.run([validator, "--target-env", "vulkan1.2", binary], check=True)
            found = counts(binary)
            for function, expected in EXPECTED.items():
                for what, count in expected.get(mode, expected).items():
                    if found[function].get(what, 0) != count:
                        failed.append(f"{mode}: {function}() has {found[function].get(what, 0)} of operation {int(what)}, expected {count}")
    print("\n".join(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
