"""project_test.py BUILD WORK: README's cmake block makes a project that links and runs, with Seaglass installed from BUILD."""
import pathlib
import shutil
import subprocess
import sys

from blocks import all_blocks

BEFORE = """cmake_minimum_required(VERSION 3.25)
project(game LANGUAGES CXX)
add_executable(game main.cpp)
"""
MAIN = """#include <seaglass/water.h>
int main() { return seaglass::version() == SEAGLASS_VERSION ? 0 : 1; }
"""


def main():
    build, work = (pathlib.Path(argument) for argument in sys.argv[1:])
    blocks = [block for block in all_blocks("cmake") if block.document == "README.md"]
    if len(blocks) != 1 or len(all_blocks("cmake")) != 1:
        print("expected one cmake block in all, README's")
        return 1
    shutil.rmtree(work, ignore_errors=True)
    game = work / "game"
    game.mkdir(parents=True)
    (game / "CMakeLists.txt").write_text(BEFORE + blocks[0].text)
    (game / "main.cpp").write_text(MAIN)
    for command in (["cmake", "--install", build, "--prefix", work / "prefix"],
                    ["cmake", "-S", game, "-B", work / "build", f"-DCMAKE_PREFIX_PATH={work / 'prefix'}",
                     "-DCMAKE_CXX_STANDARD=17"],
                    ["cmake", "--build", work / "build"],
                    [work / "build" / "game"]):
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            print(f"{blocks[0]}: {' '.join(map(str, command))} ended with {done.returncode}\n{done.stdout}{done.stderr}")
            return 1
    return 0


sys.exit(main())
