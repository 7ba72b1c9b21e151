"""Each file that shaders include compiles alone: it declares, includes or is given whatever it names.

    headers_alone.py GLSLANG FOLDER
"""
import pathlib
import subprocess
import sys
import tempfile

PLANTED = pathlib.Path(__file__).parent / "planted"
EXTENSIONS = ("GL_GOOGLE_include_directive", "GL_EXT_control_flow_attributes", "GL_EXT_demote_to_helper_invocation")
# What hosts declare before shore_wetness.glsl, by which they read a buffer of their own.
OF_HOSTS = "vec4 seaglass_shoreRow(int row) { return vec4(0.0); }"


def faults_of(glslang, header, folders, work):
    """Of the stage that comes farthest: some files know what only one of them has."""
    text = ["#version 450", *(f"#extension {e} : require" for e in EXTENSIONS), OF_HOSTS, f'#include "{header.name}"',
            "void main() {}", ""]
    fewest = None
    for stage in ("comp", "frag", "vert"):
        shader = pathlib.Path(work, f"alone.{stage}")
        shader.write_text("\n".join(text))
        done = subprocess.run([glslang, "-V", "--target-env", "vulkan1.2", *folders, "-o", f"{work}/alone.spv", shader],
                              capture_output=True, text=True)
        faults = [line for line in done.stdout.splitlines() if line.startswith("ERROR")]
        if done.returncode == 0:
            return []
        if fewest is None or len(faults) < len(fewest):
            fewest = faults
    return fewest


def main(glslang, folder):
    root = pathlib.Path(folder)
    folders = [f"-I{path}" for path in (root, PLANTED, *sorted(root.rglob("*"))) if path.is_dir()]
    headers = sorted(root.rglob("*.glsl"))
    with tempfile.TemporaryDirectory() as work:
        needy = {header.name: faults for header in headers if (faults := faults_of(glslang, header, folders, work))}
        if not faults_of(glslang, PLANTED / "needy.glsl", folders, work):
            needy["needy.glsl"] = ["takes what it does not declare, and is not seen"]
    for name, faults in needy.items():
        print(name, *faults[:2], sep="\n    ")
    print(f"{len(headers)} files, {len(needy)} of which do not stand alone")
    return 1 if needy or not headers else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
