"""The fenced blocks and the links of the documents."""
import pathlib
import re
from dataclasses import dataclass

SOURCE = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ([SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", SOURCE / "CHANGELOG.md"]
             + sorted((SOURCE / "docs").glob("**/*.md")) + sorted((SOURCE / "demos").glob("*/*.md")))


@dataclass
class Block:
    document: str  # from the top of the tree
    line: int      # of its first line of text
    language: str
    text: str

    def __str__(self):
        return f"{self.document}:{self.line}"


def read_blocks(document):
    """Every ``` block of one document; one that is not closed is an error."""
    blocks, opened = [], None
    name = str(document.relative_to(SOURCE))
    for number, line in enumerate(document.read_text().splitlines(), 1):
        fence = re.match(r"\s*```(\w*)\s*$", line)
        if not fence:
            if opened:
                opened.text += line + "\n"
        elif opened:
            blocks.append(opened)
            opened = None
        else:
            opened = Block(name, number + 1, fence.group(1), "")
    if opened:
        raise SystemExit(f"{opened}: a block that is never closed")
    return blocks


def all_blocks(language=None):
    return [block for document in DOCUMENTS for block in read_blocks(document)
            if language is None or block.language == language]


def lines_of_prose(document):
    """Number and text of each line that is in no block."""
    inside = False
    for number, line in enumerate(document.read_text().splitlines(), 1):
        if re.match(r"\s*```", line):
            inside = not inside
        elif not inside:
            yield number, line
