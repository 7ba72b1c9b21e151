"""diff_test.py: docs/tutorial.md quotes the diffs of demos/tutorial hunk by hunk: every hunk once, in the diff's order or not,
word for word. They are as short as the page says."""
import difflib
import re
import sys

from blocks import SOURCE, all_blocks

DIFFS = [SOURCE / "demos/tutorial" / name for name in ("water.diff", "cove.diff", "mirrors.diff", "foam.diff", "dive.diff")]
MOST_LINES_TO_FIRST_WATER = 40
MOST_LINES_TO_ALL = 90


def added(text):
    return [line for line in text.splitlines() if re.match(r"[-+](?![-+])", line) and line[1:].strip()]


def lines_to_sea():
    return sum(line.startswith("+") for line in added((SOURCE / "demos/minimal/sea.diff").read_text()))


def lines_to_pond():
    """Of code, beside those of the triangle."""
    def code(name):
        lines = (line.strip() for line in (SOURCE / "demos/minimal" / name).read_text().splitlines())
        return [line for line in lines if line and not line.startswith("//")]
    return sum(line.startswith("+ ") for line in difflib.ndiff(code("triangle.cpp"), code("pond.cpp")))


def main():
    texts = {path.name: path.read_text() for path in DIFFS}
    problems, quoted = [], []
    for block in all_blocks("diff"):
        if block.document != "docs/tutorial.md":
            problems.append(f"{block}: a diff, which only docs/tutorial.md is expected to quote")
            continue
        # Whole lines, one after another.
        if not any(("\n" + block.text) in ("\n" + text) for text in texts.values()):
            problems.append(f"{block}: is what none of {', '.join(texts)} says:\n{block.text}")
        quoted += added(block.text)
    for name, text in texts.items():
        missing = [line for line in added(text) if line not in quoted]
        if missing:
            problems.append(f"docs/tutorial.md leaves out of {name}:\n" + "\n".join(missing))
    lines = {name: sum(line.startswith("+") for line in added(text)) for name, text in texts.items()}
    page = (SOURCE / "docs/tutorial.md").read_text()
    for name, count in lines.items():
        if not re.search(rf"\[`{name}`\]\(#[^)]*\) \| {count} \|", page):
            problems.append(f"docs/tutorial.md does not say that {name} takes {count} lines")
    if lines["water.diff"] > MOST_LINES_TO_FIRST_WATER:
        problems.append(f"water.diff adds {lines['water.diff']} lines, expected {MOST_LINES_TO_FIRST_WATER} at the most")
    if sum(lines.values()) > MOST_LINES_TO_ALL:
        problems.append(f"all diffs add {sum(lines.values())} lines, expected {MOST_LINES_TO_ALL} at the most")
    sea, pond = lines_to_sea(), lines_to_pond()
    if sea > MOST_LINES_TO_FIRST_WATER or f"sea.diff` in {sea} lines" not in page:
        problems.append(f"demos/minimal/sea.diff adds {sea} lines, which docs/tutorial.md is expected to say")
    if pond > MOST_LINES_TO_ALL or f"pond.cpp` in {pond}" not in page:
        problems.append(f"demos/minimal/pond.cpp has {pond} lines beside triangle.cpp's, which docs/tutorial.md is expected to say")
    print("\n".join(problems))
    return 1 if problems else 0


sys.exit(main())
