"""clean_runs.py PROGRAM FOLDER [--runs N] [--from K] [--all] [--driver NAME]: draws golden pictures that nothing was changed of, over and
over, and says how often `seaglass compare --tolerant` cries all the same.

From run to run lavapipe has another number of threads and another width of its vectors. 20 pictures of scenes are drawn, with
--all every line of goldens.txt. With --driver the pictures come from another driver of scripts/drivers. What was drawn in the
last run lies in FOLDER. Exit code 1 if there was an alarm; with --driver, if there were more than one in a hundred.
"""
import argparse
import importlib.machinery
import importlib.util
import itertools
import json
import os
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PICTURES = 20
THREADS = (0, 1, 2, 3, 4, 8)
WIDTHS = (256, 128)   # bits of lavapipe's vectors; with 512 it crashes everywhere
KEYWORDS = ("QUALITY", "FRAMES", "AOVS", "OPTIONS")


class Golden:
    """A line of goldens.txt."""
    def __init__(self, line):
        _, scene, self.camera, self.special, self.size, *words = line.split()
        self.scene = ROOT / f"demos/scenes/{scene}.toml"
        self.name = f"{scene}_{self.camera}" + ("" if self.special == "-" else f"_{self.special}")
        self.given = {keyword: [] for keyword in KEYWORDS}
        for word in words:
            if word in KEYWORDS:
                now = self.given[word]
            else:
                now.append(word)

    def commands(self, program, out):
        """What seaglass_add_screenshot_test() makes of it."""
        begun = [program, "render", self.scene, "--camera", self.camera, "--size", self.size, "--plain", "--untimed", *self.given["OPTIONS"]]
        if self.given["QUALITY"]:
            begun += ["--quality", *self.given["QUALITY"]]
        if self.given["FRAMES"]:
            begun += ["--frames", *self.given["FRAMES"]]
        number = "_%04d" if self.given["FRAMES"] else ""
        for aov in self.given["AOVS"] or ["color"]:
            yield begun + (["-o", out / f"color{number}.png"] if aov == "color" else ["--aov", aov, "-o", out / f"{aov}{number}.exr"])


def goldens(every):
    """Of all scenes in turn, so that some of each are among the first."""
    lines = [Golden(line) for line in (HERE / "goldens.txt").read_text().splitlines() if line and not line.startswith("#")]
    if every:
        return lines
    scenes = {}
    for one in lines:
        if one.special == "-":
            scenes.setdefault(one.scene, []).append(one)
    turns = itertools.chain.from_iterable(itertools.zip_longest(*scenes.values()))
    return [one for one in turns if one][:PICTURES]


def of_driver(name, program):
    """The words before the program, and its environment."""
    if not name:
        return [], dict(os.environ)
    loader = importlib.machinery.SourceFileLoader("drivers", str(ROOT / "scripts/drivers"))
    drivers = importlib.util.module_from_spec(importlib.util.spec_from_loader("drivers", loader))
    sys.path.insert(0, str(ROOT / "scripts"))
    loader.exec_module(drivers)
    return drivers.started(next(driver for driver in drivers.DRIVERS if driver.name == name), program)


def varied(run, folder):
    """In the environment, from run to run another. Mesa's cache of shaders takes code for vectors of one width for that of another, which
    overruns its memory: so each width has a cache of its own."""
    width = WIDTHS[run // len(THREADS) % len(WIDTHS)]
    return {"LP_NUM_THREADS": str(THREADS[run % len(THREADS)]), "LP_NATIVE_VECTOR_WIDTH": str(width),
            "MESA_SHADER_CACHE_DIR": str(folder / f"cache_{width}")}


def draw(golden, program, before, environment, folder):
    out = folder / golden.name
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    for command in golden.commands(program, out):
        done = subprocess.run([*before, *command], env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{golden.name}: {done.stderr.strip()}")


def compared(golden, program, folder):
    """(name, verdict, why, mean FLIP) of each picture."""
    report = folder / f"{golden.name}.json"
    report.unlink(missing_ok=True)
    done = subprocess.run([program, "compare", HERE / "golden" / golden.name, folder / golden.name, "--tolerant", "--json", report],
                          capture_output=True, text=True)
    if not report.exists():
        sys.exit(f"{golden.name}: {done.stderr.strip()}")
    for picture in json.loads(report.read_text())["pictures"]:
        flip = ((picture["measures"] or {}).get("flip") or {}).get("mean", 0)
        yield f"{golden.name}/{picture['name']}", picture["verdict"], picture["why"], flip


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=len(THREADS) * len(WIDTHS))
    parser.add_argument("--from", dest="first", type=int, default=1)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--driver")
    arguments = parser.parse_args()
    try:
        before, environment = of_driver(arguments.driver, arguments.program)
    except Exception as why:
        sys.exit(str(why))
    count, alarms, greatest = 0, 0, ("", 0.0)
    for run in range(arguments.first, arguments.first + arguments.runs):
        for golden in goldens(arguments.all):
            way = {} if arguments.driver else varied(run, arguments.folder)
            draw(golden, arguments.program, before, environment | way, arguments.folder)
            for name, verdict, why, flip in compared(golden, arguments.program, arguments.folder):
                count += 1
                greatest = max(greatest, (name, flip), key=lambda one: one[1])
                if verdict != "same":
                    alarms += 1
                    print(f"run {run}, {way or arguments.driver}: {verdict}: {name}: {why}", flush=True)
        print(f"run {run}: {alarms} alarms in {count} pictures, the greatest mean FLIP {greatest[1]:.5f} of {greatest[0]}", flush=True)
    return 1 if alarms * (100 if arguments.driver else 1) > (count if arguments.driver else 0) else 0


if __name__ == "__main__":
    sys.exit(main())
