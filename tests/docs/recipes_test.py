"""recipes_test.py PROGRAM: every yaml block of the documents, a recipe for CI, parses; its commands are programs that are here, and what
they hand to cmake, ctest and seaglass are options of these. Only as much YAML is read as recipes need: more is an error."""
import re
import shlex
import shutil
import subprocess
import sys

from blocks import all_blocks

# Programs of the machine that a recipe runs on, which need not be this one.
ELSEWHERE = {"apt-get"}


class Problem(Exception):
    pass


def scalar(text):
    if text.startswith("["):
        if not text.endswith("]"):
            raise Problem(f"'{text}' is never closed")
        return [scalar(word.strip()) for word in text[1:-1].split(",")]
    if re.search(r"^[{&*!%@`\"'|>]|: |:$| #", text):
        raise Problem(f"'{text}', expected plain words")
    return text


def items(lines, indent):
    """The lines of one level, each with those below it: [(text, [line...])]."""
    found = []
    for line in lines:
        spaces = len(line) - len(line.lstrip())
        if spaces == indent:
            found.append((line.strip(), []))
        elif spaces > indent and found:
            found[-1][1].append(line)
        else:
            raise Problem(f"'{line.strip()}' is {spaces} deep, expected {indent}")
    return found


def entry(text, below):
    """What is behind a colon or a dash."""
    if text:
        if below:
            raise Problem(f"'{text}' has lines below it")
        return scalar(text)
    return parse(below)


def parse(lines):
    if not lines:
        raise Problem("a key without a value")
    indent = len(lines[0]) - len(lines[0].lstrip())
    if lines[0].lstrip().startswith("- "):
        values = []
        for text, below in items(lines, indent):
            if not text.startswith("- "):
                raise Problem(f"'{text}' in a list, expected '- '")
            inner = text[2:]
            if re.match(r"[\w-]+:( |$)", inner):
                values.append(parse([" " * (indent + 2) + inner, *below]))
            else:
                values.append(entry(inner, below))
        return values
    mapping = {}
    for text, below in items(lines, indent):
        found = re.match(r"([\w-]+):(?: (.*))?$", text)
        if not found:
            raise Problem(f"'{text}', expected key: value")
        if found[1] in mapping:
            raise Problem(f"'{found[1]}' is given twice")
        mapping[found[1]] = entry((found[2] or "").strip(), below)
    return mapping


def commands(value):
    """What steps run: GitHub's `run`, GitLab's `script`."""
    if isinstance(value, list):
        for one in value:
            yield from commands(one)
    elif isinstance(value, dict):
        for key, one in value.items():
            if key in ("run", "script"):
                for line in [one] if isinstance(one, str) else one:
                    yield from (shlex.split(command) for command in line.split("&&"))
            else:
                yield from commands(one)


def help_of(words, program):
    command = [program, words[1], "--help"] if words[0] == "seaglass" else [words[0], "--help"]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else ""


def problem_of(words, program):
    if words[0] in ELSEWHERE:
        return None
    if words[0] != "seaglass" and not shutil.which(words[0]):
        return f"there is no program {words[0]}"
    said = help_of(words, program)
    unknown = [word for word in words if word.startswith("-") and word not in said]
    return f"{words[0]} has no {' '.join(unknown)}" if unknown else None


def main():
    problems, ran = [], 0
    for block in all_blocks("yaml"):
        try:
            recipe = parse([line for line in block.text.splitlines() if line.strip()])
        except Problem as problem:
            problems.append(f"{block}: {problem}")
            continue
        for words in commands(recipe):
            ran += 1
            if problem := problem_of(words, sys.argv[1]):
                problems.append(f"{block}: {' '.join(words)}: {problem}")
    print("\n".join(problems) or f"{ran} commands")
    return 1 if problems or ran == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
