"""bounded_loops.py names every function of planted/endless.comp that loops, and none of planted/bounded.comp.

    planted_test.py GLSLANG
"""
import pathlib
import subprocess
import sys
import tempfile

from bounded_loops import Shader, unbounded_loops
from module import read

PLANTED = pathlib.Path(__file__).parent / "planted"


def main(glslang):
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for name, endless in (("endless", True), ("bounded", False)):
            built = f"{folder}/{name}.spv"
            subprocess.run([glslang, "--quiet", "-V", "--target-env", "vulkan1.2", "-o", built, PLANTED / f"{name}.comp"], check=True)
            shader = Shader(read(built))
            expected = {shader.name(function.id) for function in shader.functions.values() if function.loops and endless}
            count, lines = unbounded_loops(built)
            named = {line.split(": ")[1].split("()")[0] for line in lines}
            if count < 15:
                failed.append(f"{name}.comp: {count} loops found, expected 15 or more")
            failed += [f"{name}.comp: {function}() is not named, expected to be" for function in sorted(expected - named)]
            failed += [f"{name}.comp: {function}() is named, expected not to be" for function in sorted(named - expected)]
    print("\n".join(failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
