"""What is planted is named, and what only looks like it is not: functions of planted/ are either all at fault, or none of them; so
are the members of its blocks, but for the first of each.

    planted_test.py GLSLANG
"""
import pathlib
import subprocess
import sys
import tempfile

from bounded_loops import unbounded_loops
from defined_derivatives import undefined_derivatives
from module import Op, read, text
from packed_blocks import holes_of
from parted_memory import unparted_memory

PLANTED = pathlib.Path(__file__).parent / "planted"
# Which look for faults, and those that the functions but for these have.
FILES = [
    ("endless.comp", lambda path: unbounded_loops(path)[1], {"main", "look", "moveIt"}),
    ("bounded.comp", lambda path: unbounded_loops(path)[1], None),
    ("undefined.frag", undefined_derivatives, {"main", "stop"}),
    ("defined.frag", undefined_derivatives, None),
    ("unparted.comp", unparted_memory, {"main"}),
    ("parted.comp", unparted_memory, None),
]
BLOCKS = [("holes.comp", {"begins", "columns", "ends", "elements"}), ("packed.comp", set())]


def build(glslang, file, folder):
    built = f"{folder}/{file}.spv"
    subprocess.run([glslang, "--quiet", "-V", "--target-env", "vulkan1.2", "-o", built, PLANTED / file], check=True)
    return built


def main(glslang):
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for file, holes in BLOCKS:
            named = {line.split(": ")[1].split(".")[1] for line in holes_of(build(glslang, file, folder))}
            if named != holes:
                failed.append(f"{file}: names {sorted(named)}, expected {sorted(holes)}")
        for file, faults, but in FILES:
            built = build(glslang, file, folder)
            instructions = read(built).instructions
            names = {i[1]: text(i[2:]).split("(")[0] for i in instructions if i[0] == Op.Name}
            expected = {names[i[2]] for i in instructions if i[0] == Op.Function} - but if but else set()
            named = {line.split(": ")[1].split("()")[0] for line in faults(built)}
            failed += [f"{file}: {function}() is not named, expected to be" for function in sorted(expected - named)]
            failed += [f"{file}: {function}() is named, expected not to be" for function in sorted(named - expected)]
    print("\n".join(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
