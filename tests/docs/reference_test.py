"""reference_test.py PROGRAM FOLDER: docs/reference is what the tables say now, and the headers do not say otherwise."""
import pathlib
import re
import subprocess
import sys

from blocks import SOURCE

PAGES = SOURCE / "docs" / "reference"
# Numbers of a description that no range holds to: any may be, or none alone says whether it may.
FREE = {
    "SeaDesc": {"seed"},
    "DeviceDesc": {"headerVersion"},
    "ViewDesc": {"view", "projection"},
    "LightingDesc": {"toSun"},
    "SunShadow": {"layers"},
    "TargetDesc": {"subpass"},
}
# What is no number: other descriptions, pointers and what only goes with them.
APART = re.compile(r"\*|\bDesc\b|Desc |WavesBackend|double plane\[4\]|spectrumTableCount|pointCount|indexCount|"
                   r"\b(Vk(?!SampleCount)|PFN_vk)\w+ |\b(Image|MemoryCallbacks|MessageCallback|PassCallback) ")

# As comments write a range, 0..0.5, and the pages a number.
RANGE = re.compile(r"(?<![\w.])(-?\d+(?:\.\d+)?(?:e\d+)?)\.\.(-?\d+(?:\.\d+)?(?:e\d+)?)")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def wrong_pages(program, folder):
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, folder], check=True)
    written = {page.name for page in folder.glob("*.md")}
    for name in sorted(written | {page.name for page in PAGES.glob("*.md")}):
        kept, made = PAGES / name, folder / name
        if not made.exists():
            yield f"docs/reference/{name} comes from no table"
        elif not kept.exists() or kept.read_text() != made.read_text():
            yield f"docs/reference/{name} is not what the tables say, run scripts/reference"


def tables(page):
    """Field names and their ranges, by description and header."""
    desc = header = None
    found = {}
    for line in page.splitlines():
        if line.startswith("## "):
            desc, header = line[3:], None
        elif header is None and (name := re.fullmatch(r"`(seaglass/\w+\.h)`", line)):
            header = name.group(1)
            found[desc] = (header, {})
        elif desc in found and (row := re.match(r"\| `(\w+)` \| ([^|]*) \|", line)):
            found[desc][1][row.group(1)] = row.group(2)
    return found


def members(desc, header):
    """Each member of a struct of the header, with its comment."""
    [path] = [folder / header for folder in SOURCE.glob("*/include") if (folder / header).exists()]
    body = re.search(rf"struct {desc} {{\n(.*?)\n}};", path.read_text(), re.S).group(1)
    above = ""
    for line in body.splitlines():
        code, _, comment = line.partition("///")
        if not code.strip():
            above += " " + comment
            continue
        if member := re.match(r"\s*([\w ]+?[ *]+)(\w+)(\[\w+\])?( = .*)?;", code):
            last = [member.group(2), code, above + " " + comment]
            above = ""
            yield last


def wrong_headers():
    for desc, (header, rows) in tables((PAGES / "settings.md").read_text()).items():
        names = []
        for name, code, comment in members(desc, header):
            if APART.search(code):
                continue
            names.append(name)
            if name not in rows and name not in FREE.get(desc, set()):
                yield f"{header}: {desc}::{name} is in no table"
            said = [tuple(map(float, ends)) for ends in RANGE.findall(comment)]
            numbers = [float(number) for number in NUMBER.findall(rows.get(name, ""))]
            if said and not set(said) & set(zip(numbers, numbers[1:])):
                yield f"{header}: {desc}::{name} says {said}, its table {rows.get(name)}"
        for name in rows:
            if name not in names:
                yield f"{header}: {desc} has no {name}, which its table names"


def main():
    problems = [*wrong_pages(sys.argv[1], pathlib.Path(sys.argv[2])), *wrong_headers()]
    print("\n".join(problems))
    return 1 if problems else 0


sys.exit(main())
