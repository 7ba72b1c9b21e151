"""diff_test.py: docs/integrating.md quotes demos/tutorial/water.diff hunk by hunk: every hunk once, in the diff's order or not,
word for word."""
import re
import sys

from blocks import SOURCE, all_blocks

DIFF = SOURCE / "demos/tutorial/water.diff"


def added(text):
    return [line for line in text.splitlines() if re.match(r"[-+](?![-+])", line) and line[1:].strip()]


def main():
    diff = DIFF.read_text()
    problems, quoted = [], []
    for block in all_blocks("diff"):
        if block.document != "docs/integrating.md":
            problems.append(f"{block}: a diff, which only docs/integrating.md is expected to quote")
            continue
        # Whole lines, one after another.
        if ("\n" + block.text) not in ("\n" + diff):
            problems.append(f"{block}: is not what {DIFF.name} says:\n{block.text}")
        quoted += added(block.text)
    missing = [line for line in added(diff) if line not in quoted]
    if missing:
        problems.append("docs/integrating.md leaves out of water.diff:\n" + "\n".join(missing))
    print("\n".join(problems))
    return 1 if problems else 0


sys.exit(main())
