"""additions_test.py PATCH: the diffs of docs/additions apply to this tree, touch as few files as CONTRIBUTING.md says, and no more
than they may.
  additions_test.py PATCH build CMAKE GENERATOR FOLDER: a copy of the tree with all of them builds, and its program runs them."""
import pathlib
import re
import shutil
import subprocess
import sys

from blocks import SOURCE

ADDITIONS = SOURCE / "docs" / "additions"
MOST_FILES = {"spectrum.diff": 4, "technique.diff": 4, "surface_effect.diff": 6}
PARTS = ("cmake", "demos", "gpu", "reflection", "shaders", "water", "docs", "textures")


def applied(patch, name, tree, *options):
    """What `patch` has to say, if it fails."""
    done = subprocess.run([patch, "--batch", "--fuzz=0", "--forward", "-p1", *options, "--directory", tree,
                           "--input", ADDITIONS / name], capture_output=True, text=True)
    return done.stdout + done.stderr if done.returncode != 0 else ""


def problems(patch):
    page = (SOURCE / "CONTRIBUTING.md").read_text()
    found = {path.name for path in ADDITIONS.glob("*")}
    if found != MOST_FILES.keys():
        yield f"docs/additions holds {sorted(found)}, expected {sorted(MOST_FILES)}"
    for name in sorted(found & MOST_FILES.keys()):
        files = len(re.findall(r"^\+\+\+ ", (ADDITIONS / name).read_text(), re.M))
        if files > MOST_FILES[name]:
            yield f"docs/additions/{name} touches {files} files, expected {MOST_FILES[name]} at the most"
        if not re.search(rf"\[`{name}`\]\(docs/additions/{name}\) \| {files} \|", page):
            yield f"CONTRIBUTING.md does not say that {name} touches {files} files"
        if said := applied(patch, name, SOURCE, "--dry-run"):
            yield f"docs/additions/{name} does not apply:\n{said}"


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\nended with {done.returncode}:\n{done.stdout[-4000:]}")
    return done.stdout


def pixels(program, folder, scene, *settings):
    """The bytes of a picture, which are the same where all its pixels are."""
    picture = folder / "picture.png"
    run(program, "render", folder / "tree/demos/scenes" / scene, "--size", "160x90", "--device", "llvmpipe", "-o", picture,
        *(word for setting in settings for word in ("--set", setting)))
    return picture.read_bytes()


def build(patch, cmake, generator, folder):
    shutil.rmtree(folder, ignore_errors=True)
    tree = folder / "tree"
    for part in PARTS:
        shutil.copytree(SOURCE / part, tree / part)
    shutil.copy(SOURCE / "CMakeLists.txt", tree)
    for name in MOST_FILES:
        if said := applied(patch, name, tree):
            raise SystemExit(said)
    run(cmake, "-G", generator, "-S", tree, "-B", folder / "build", "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
        "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2", "-DSEAGLASS_TESTS=OFF", "-DSEAGLASS_VIEWER=OFF", "-DSEAGLASS_WARNINGS_AS_ERRORS=ON")
    run(cmake, "--build", folder / "build", "--target", "seaglass")
    return folder / "build/bin/seaglass"


def differences(program, folder):
    """Each addition is seen where it is asked for, and one that is off is not there."""
    if "steep, 10 m/s" not in run(program, "sea", "--wind", "10", "--samples", "64", "--spectrum", "steep"):
        yield "seaglass sea does not name the spectrum"
    ocean, harbour = pixels(program, folder, "ocean.toml"), pixels(program, folder, "harbour.toml")
    for picture, scene, setting in ((ocean, "ocean.toml", "water.waves.spectrum=steep"), (ocean, "ocean.toml", "water.height_tint=1"),
                                    (harbour, "harbour.toml", "water.reflection.technique=plain")):
        if pixels(program, folder, scene, setting) == picture:
            yield f"{scene} looks the same with {setting}"
    if pixels(program, folder, "ocean.toml", "water.height_tint=0") != ocean:
        yield "a tint of 0 is seen"


def main():
    if len(sys.argv) == 2:
        wrong = list(problems(sys.argv[1]))
    else:
        _, patch, _, cmake, generator, folder = sys.argv
        folder = pathlib.Path(folder)
        wrong = list(differences(build(patch, cmake, generator, folder), folder))
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
