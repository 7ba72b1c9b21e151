"""prose_test.py PROGRAM: blocks are of kinds that are tested, links lead somewhere, and options, tests and shaders
that the prose names exist."""
import fnmatch
import re
import subprocess
import sys

from blocks import DOCUMENTS, SOURCE, all_blocks, lines_of_prose

# What tests each language. A block without one is a formula or a drawing: there is nothing to run.
TESTED = {
    "sh": "commands_test.py",
    "cpp": "code_test.py",
    "cmake": "code_test.py",
    "diff": "diff_test.py",
    "yaml": "recipes_test.py",
    "": None,
}
# Blocks without a language, by their first line: that none is forgotten which could be tested.
UNTESTED = {
    "H = S VP R (S VP)⁻¹": "a formula",
    "depth ──► scatter ──► keys ─────────────┐": "a drawing",
    "atomicMax(keys[mirrored pixel], bits of the mirrored depth)": "pseudo code",
    "log2( (c t + scatter max(t - clearDistance, 0)) / (s + t) * pixels a radian / downscale / 1.29 )": "a formula",
    "1 + H A S I": "a formula",
    "# scenes/pond.toml": "a scene",
    'field<&MeshDesc::cellsPerLevel>("cellsPerLevel", 128, 1024, "", "Cells until a twice coarser level takes over.")': "a row of a table",
}
# Options in the prose that are not the program's.
OTHERS = {"--preset", "--build", "--install", "--prefix", "--config", "--cflags", "--libs", "--parallel", "--target",
          "--gtest_filter", "--json", "--no-install", "--check", "--bless", "--label-exclude", "--overlay-ports",
          "--variable", "--list", "--large", "--replay"}
# Functions of CMake that make tests, and what the names of these begin with.
MADE = {"seaglass_spirv_test": "Spirv.", "seaglass_hostile": "Spirv.HostileArithmetic", "seaglass_checked_scenes": "CheckedScenes."}


def wrong_blocks():
    for block in all_blocks():
        if block.language not in TESTED:
            yield f"{block}: a block of '{block.language}', expected one of {sorted(filter(None, TESTED))} or none"
        elif block.language == "" and block.text.split("\n")[0] not in UNTESTED:
            yield f"{block}: a block without a language that UNTESTED does not list"


def anchors(document):
    """Of its headings, as GitHub makes them: in small letters, without punctuation, hyphens for spaces."""
    headings = (re.match(r"#+ (.*)", line) for _, line in lines_of_prose(document))
    return {re.sub(r"[^\w\- ]", "", heading.group(1).lower()).replace(" ", "-") for heading in headings if heading}


def wrong_links():
    for document in DOCUMENTS:
        for number, line in lines_of_prose(document):
            for target in re.findall(r"\]\(([^)\s]+)\)", line):
                if re.match(r"\w+:", target):
                    continue
                path, _, anchor = target.partition("#")
                page = document.parent / path if path else document
                if not page.exists() or (anchor and page.suffix == ".md" and anchor not in anchors(page)):
                    yield f"{document.relative_to(SOURCE)}:{number}: {target} leads nowhere"


def known_options(program):
    """Of each sub-command, and of all together under ''."""
    def read(*command):
        text = subprocess.run([program, *command, "--help"], capture_output=True, text=True, check=True).stdout
        return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text)), text
    everything, text = read()
    commands = re.findall(r"^  ([a-z]+) {2,}", text, re.M)
    assert "render" in commands, text
    options = {name: read(name)[0] for name in commands}
    options[""] = everything.union(*options.values())
    return options


def wrong_options(program):
    options = known_options(program)
    for document in DOCUMENTS:
        for number, line in lines_of_prose(document):
            for code in re.findall(r"`([^`]+)`", line):
                command = re.match(r"seaglass ([a-z]+)", code)
                name = command.group(1) if command else ""
                if name not in options:
                    yield f"{document.relative_to(SOURCE)}:{number}: there is no seaglass {name}"
                    continue
                for option in re.findall(r"(?<![\w-])--[a-z_][a-z_-]*", code):
                    if option not in options[name] and (command or option not in OTHERS):
                        yield f"{document.relative_to(SOURCE)}:{number}: {option} is no option of seaglass {name}"


def known_tests():
    sources = "\n".join(path.read_text() for path in (SOURCE / "tests").rglob("*_test.cpp"))
    lists = "\n".join(path.read_text() for path in (SOURCE / "tests").rglob("CMakeLists.txt"))
    made = re.findall(rf"^\s*({'|'.join(MADE)})\((\w+)", lists, re.M)
    return {".".join(names) for names in re.findall(r"TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", sources)} | {
        MADE[function] + name for function, name in made} | set(re.findall(r"add_test\(NAME (\w+\.\w+)", lists))


def wrong_tests():
    """Tests that a page says hold something; with * for any."""
    tests = known_tests()
    for document in DOCUMENTS:
        if document.name not in ("domain.md", "portability.md", "reliability.md"):
            continue
        for number, line in lines_of_prose(document):
            for name in re.findall(r"`([A-Z]\w+\.(?:[A-Z]\w+)?\*?)`", line):
                if not fnmatch.filter(tests, name):
                    yield f"{document.relative_to(SOURCE)}:{number}: there is no test {name}"


def wrong_shaders():
    """Shaders that the rules of portability are said to matter in. Other pages name variants and shaders that were."""
    document = SOURCE / "docs/portability.md"
    shaders = {path.name for path in (SOURCE / "shaders").rglob("*")}
    for number, line in lines_of_prose(document):
        for name in re.findall(r"`(\w+\.(?:glsl|comp|frag|vert))`", line):
            if name not in shaders:
                yield f"{document.relative_to(SOURCE)}:{number}: there is no shader {name}"


def main():
    problems = [*wrong_blocks(), *wrong_links(), *wrong_options(sys.argv[1]), *wrong_tests(),
                *wrong_shaders()]
    print("\n".join(problems))
    return 1 if problems else 0


sys.exit(main())
