"""project_test.py BUILD WORK: with Seaglass installed from BUILD, README's cmake block makes a project that links and runs, and
those of docs/screenshot-tests.md one that has the tests they speak of."""
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
    blocks = [(str(block.document), block.text) for block in all_blocks("cmake")]
    if [document for document, _ in blocks] != ["README.md", "docs/screenshot-tests.md", "docs/screenshot-tests.md"]:
        print("expected three cmake blocks in all, README's and the two of docs/screenshot-tests.md")
        return 1
    (_, game_block), *picture_blocks = blocks
    shutil.rmtree(work, ignore_errors=True)
    game = work / "game"
    pictures = work / "pictures"
    game.mkdir(parents=True)
    pictures.mkdir()
    (pictures / "CMakeLists.txt").write_text("".join(text for _, text in picture_blocks))
    (game / "CMakeLists.txt").write_text(BEFORE + game_block)
    (game / "main.cpp").write_text(MAIN)
    for command in (["cmake", "--install", build, "--prefix", work / "prefix"],
                    ["cmake", "-S", game, "-B", work / "build", f"-DCMAKE_PREFIX_PATH={work / 'prefix'}",
                     "-DCMAKE_CXX_STANDARD=17"],
                    ["cmake", "--build", work / "build"],
                    [work / "build" / "game"],
                    ["cmake", "-S", pictures, "-B", work / "tests", f"-DCMAKE_PREFIX_PATH={work / 'prefix'}"],
                    ["ctest", "--test-dir", work / "tests", "-N"]):
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            print(f"{' '.join(map(str, command))} ended with {done.returncode}\n{done.stdout}{done.stderr}")
            return 1
    if "Total Tests: 3" not in done.stdout:
        print(f"expected three screenshot tests:\n{done.stdout}")
        return 1
    return 0


sys.exit(main())
