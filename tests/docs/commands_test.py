"""commands_test.py PROGRAM (quick | long): runs every command of the documents' sh blocks, as it stands but for smaller
pictures and fewer rounds. `quick` runs those of the documents that newcomers begin with. Of others, and of those that
measure, it has options, scenes, cameras and techniques read, and `long` runs them. Windows are opened by tests/view; here
too commands are only read. What is neither run nor excused below is an error."""
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time

from blocks import SOURCE, all_blocks

# Of an option given twice the last counts.
SMALLER = {
    "render": ["--size", "64x36"],
    "reference": ["--size", "64x36", "--spp", "1"],
    "compare": [],
    "bless": [],
    "measure": ["--size", "32x18", "--rounds", "1", "--spp", "1"],
    "sea": [],
    "devices": [],
}
# Pictures of different renderers differ.
EXPECTED = {"compare": {0, 1}}

# What `quick` runs.
FIRST_READ = {"README.md", "docs/screenshot-tests.md"}
# They refuse a device before they begin.
TAKE_A_DEVICE = {"render", "measure", "view"}

# Commands that are not run, and why. Each is still held to what `holds` says of it.
EXCUSED = {
    "scripts/demo": "builds, and renders at full size for minutes",
    "scripts/test": "runs this test",
    "scripts/gpu_check": "wants a GPU; tests/scripts runs it without",
    "scripts/setup --nightly": "installs packages",
    "scripts/drivers": "takes hours",
    "scripts/drivers swiftshader": "takes an hour",
    "ctest --preset release -L nightly": "takes hours",
    "ctest --preset release -R sea_tests.Spectrum": "runs tests, as does the one that would run it",
    "build/release/bin/sea_tests --gtest_filter=Spectrum.*": "likewise",
    "cmake --preset release -B build/nan -DSEAGLASS_HOSTILE_ARITHMETIC=nan": "Spirv.HostileArithmeticOfNaN does so",
    "cmake --build build/nan --target reflection_gpu_tests": "likewise",
    "build/nan/bin/reflection_gpu_tests --gtest_filter=-Atomics.*": "likewise",
    "cmake -S . -B build": "Consumer.FindPackage does so, with a project of its own",
    "ctest --test-dir build -L screenshot": "likewise",
    "ctest --test-dir build -L screenshot --output-on-failure": "likewise",
    "seaglass bless screenshots build/screenshots/out": "likewise",
    "seaglass bless screenshots build/screenshots/out --yes": "likewise",
    "rm -rf out && mkdir out && my_game --screenshot out/menu.png": "is a host's own program",
    "seaglass compare screenshots out --tolerant --junit screenshots.xml --report page": "wants its pictures; comparison_tests have some",
    "seaglass bless screenshots out --yes": "likewise",
    "build/release/bin/fault_tests": "is a test itself",
    "build/release/bin/fault_tests --gtest_filter=Faults.OfEachCallInTurn*": "takes half an hour",
    "scripts/fuzz": "takes ten minutes, and builds by clang",
    "scripts/fuzz gltf 600": "likewise",
    "scripts/fuzz --large": "Fuzz.LargeFiles does so",
    "scripts/mutants --list": "tests/scripts does so",
    "scripts/mutants globe_twists": "changes the sources meanwhile",
    "scripts/mutants": "likewise, for hours",
    "scripts/coverage": "builds apart and runs most tests, for an hour",
    "scripts/coverage --lines": "likewise",
    "scripts/mutants --of shader": "likewise",
    "seaglass=build/release/bin/seaglass": "names the program, which the test is told",
    "export VK_ADD_LAYER_PATH=$PWD/build/release/tests/checked/layers": "tests/checked does so",
    "export VK_INSTANCE_LAYERS=VK_LAYER_SEAGLASS_checked_shaders": "tests/checked does so",
}


def commands_of(block):
    """Its lines without comments, continued ones joined: (line, words)."""
    joined, begun = "", block.line
    for number, line in enumerate(block.text.splitlines(), block.line):
        if not joined:
            begun = number
        joined += line
        if joined.endswith("\\"):
            joined = joined[:-1]
            continue
        words = shlex.split(joined, comments=True)
        joined = ""
        if words:
            yield begun, words


def shrunk(words):
    words = words + SMALLER[words[1]]
    if words[1] == "measure" and "--camera" not in words:
        words = words + ["--quick"] + SMALLER["measure"]  # the first camera of each scene
    if "--frames" in words:
        words = words + ["--frames", "2"]
    return words


def excused(words):
    return " ".join(words) in EXCUSED


def holds(words):
    """Of what is not run: scripts are there and may be run."""
    script = SOURCE / words[0]
    return not words[0].startswith("scripts/") or os.access(script, os.X_OK)


def read_only(program, words, folder):
    """Scenes, cameras and options are looked at before there is no such device, or no display."""
    missing = "seaglass render draws" if words[1] == "view" else "no usable Vulkan device is named"
    command = [program, *words[1:], "--device", "of no such name"]
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment)
    return None if missing in done.stderr else f"is refused: {done.stderr.strip()}"


def run(program, words, folder):
    if words[1] not in SMALLER:
        return f"there is no seaglass {words[1]} that the test knows how to run"
    command = [program, *shrunk(words)[1:]]
    # lavapipe is everywhere, and the same everywhere.
    if words[1] in ("render", "measure"):
        command += ["--device", "llvmpipe"]
    started = time.monotonic()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    print(f"  {time.monotonic() - started:6.1f} s  {' '.join(words)}", flush=True)
    if done.returncode not in EXPECTED.get(words[1], {0}):
        return f"ended with {done.returncode}: {done.stderr.strip()}\n    run as {' '.join(command)}"
    return None


def is_quick(block, words):
    measures = words[1:2] == ["measure"] or "--stats" in words
    return block.document in FIRST_READ and not measures


def tried(program, words, folder, in_full):
    """What is wrong with a command of ours; None if nothing is."""
    if in_full and words[1] != "view":
        return run(program, words, folder)
    return read_only(program, words, folder) if words[1] in TAKE_A_DEVICE else None


def main():
    program, which = sys.argv[1:]
    problems, ran = [], 0
    for block in all_blocks("sh"):
        with tempfile.TemporaryDirectory() as folder:
            # The commands are those of somebody at the top of the tree; what they write stays out of it.
            for name in ("demos", "textures", "scripts"):
                (pathlib.Path(folder) / name).symlink_to(SOURCE / name)
            print(block, flush=True)
            for line, words in commands_of(block):
                ours = words[0] in ("seaglass", "$seaglass")
                quick = is_quick(block, words)
                if which == "long" and (quick or not ours):
                    continue
                if excused(words):
                    problem = None if holds(words) else "is not there, or cannot be run"
                elif ours:
                    problem = tried(program, words, folder, quick == (which == "quick"))
                    ran += 1
                else:
                    problem = "is neither run nor excused"
                if problem:
                    problems.append(f"{block.document}:{line}: {' '.join(words)}\n    {problem}")
    print("\n".join(problems))
    # That nothing passes because nothing was found.
    return 1 if problems or ran == 0 else 0


sys.exit(main())
