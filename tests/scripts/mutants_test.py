"""mutants_test.py: scripts/mutants over a tree of one source and two shaders, whose test program reads them."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MUTANTS = ROOT / "scripts/mutants"

# Sees a sign that is turned; what it is asked for beside fails without any mutant, too.
PROGRAM = f"""#!{sys.executable}
import os, pathlib, sys
text = "".join((pathlib.Path(__file__).parents[2] / name).read_text() for name in ("a.cpp", "demos/a.frag"))
if "SEAGLASS_SWAPPED_SHADERS" in os.environ:
    text = (pathlib.Path(os.environ["SEAGLASS_SWAPPED_SHADERS"]) / "a.comp.spv").read_text()
wanted = next(word for word in sys.argv if word.startswith("--gtest_filter=")).split("=")[1]
if wanted == "None.*":
    print("[==========] Running 0 tests from 0 test suites.")
elif wanted.startswith("Broken.") or (wanted.startswith("Sign.") and "+" in text):
    print("[  FAILED  ] " + wanted.replace("*", "IsSeen") + ", where (1 ms)")
    sys.exit(1)
print("[  PASSED  ] 1 test.")
"""
# Words are the text of what is included.
NINJA = f"""#!{sys.executable}
import pathlib, sys
root = pathlib.Path(sys.argv[2]).parent.resolve()
print(f"cd x && glslang -I{{root}}/shaders --depfile d --vn a_comp -o h {{root}}/shaders/a.comp && cmake -E more")
"""
GLSLANG = f"""#!{sys.executable}
import pathlib, sys
text = (pathlib.Path(sys.argv[1][2:]) / "a.glsl").read_text()
if "!" in text:
    print("ERROR: a.glsl:1: what is that")
    sys.exit(1)
pathlib.Path(sys.argv[sys.argv.index("-o") + 1]).write_text(text)
"""
MAKE = f"""#!{sys.executable}
import pathlib, sys
if sys.argv[1] == "-S":
    sys.exit(0)
text = (pathlib.Path(sys.argv[2]).parent / "a.cpp").read_text()
if "!" in text:
    print("a.cpp:1: error: what is that")
    sys.exit(1)
"""


def entry(name, before="-b", after="+b", tests="Sign.*", kind="sign", file="a.cpp"):
    return f'[[mutant]]\nname = "{name}"\nkind = "{kind}"\nfile = "{file}"\nfrom = "{before}"\nto = "{after}"\ntests = {{ prog = "{tests}" }}\n'


class Mutants(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name, text in (("build/bin/prog", PROGRAM), ("tools/cmake", MAKE), ("tools/ninja", NINJA), ("tools/glslang", GLSLANG)):
            path = self.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
            path.chmod(0o755)
        (self.root / "a.cpp").write_text("a -b c\n")
        (self.root / "demos").mkdir()
        (self.root / "demos/a.frag").write_text("a -b c\n")
        (self.root / "shaders").mkdir()
        (self.root / "shaders/a.glsl").write_text("a -b c\n")
        (self.root / "shaders/a.comp").write_text("void main\n")
        made = self.root / "build/words_a.comp.h"
        made.with_name("words_a.comp.h.d").write_text(f"{made}: {self.root}/shaders/a.comp {self.root}/shaders/a.glsl\n")

    def mutants(self, table, *options):
        (self.root / "tests/mutants").mkdir(parents=True, exist_ok=True)
        (self.root / "tests/mutants/mutants.toml").write_text(table)
        environment = {**os.environ, "PATH": f"{self.root / 'tools'}:{os.environ['PATH']}"}
        done = subprocess.run([MUTANTS, "--root", self.root, "--build", self.root / "build", *options], capture_output=True,
                              text=True, env=environment, timeout=60)
        for name in ("a.cpp", "demos/a.frag", "shaders/a.glsl"):
            self.assertEqual((self.root / name).read_text(), "a -b c\n")
        return done.returncode, done.stdout + done.stderr

    def test_one_that_a_test_sees_is_seen(self):
        code, said = self.mutants(entry("turned"))
        self.assertEqual(code, 0, said)
        self.assertIn("Sign.IsSeen", said)
        self.assertEqual(said.splitlines()[-1], "1 mutants: 1 seen, 0 survived, 0 could not be planted")

    def test_one_that_no_test_sees_survives(self):
        code, said = self.mutants(entry("turned", tests="Other.*") + entry("seen"))
        self.assertEqual(code, 1, said)
        self.assertEqual(said.splitlines()[-1], "2 mutants: 1 seen, 1 survived, 0 could not be planted")

    def test_shaders_are_swapped(self):
        for after, tests, words in (("+b", "Sign.*", "Sign.IsSeen"), ("+b", "Other.*", "survived"), ("!", "Sign.*", "a.glsl:1: what is that")):
            code, said = self.mutants(entry("turned", after=after, tests=tests, file="shaders/a.glsl"))
            self.assertEqual(code, {"Sign.IsSeen": 0, "survived": 1}.get(words, 2), said)
            self.assertIn(words, said)

    def test_shaders_of_the_demos_are_built(self):
        code, said = self.mutants(entry("turned", file="demos/a.frag"), "--of", "shader")
        self.assertEqual(code, 0, said)
        self.assertIn("Sign.IsSeen", said)

    def test_shaders_that_none_includes_are_said(self):
        code, said = self.mutants(entry("turned", before="void", file="shaders/b.glsl"))
        self.assertEqual(code, 2, said)
        (self.root / "shaders/b.glsl").write_text("void")
        code, said = self.mutants(entry("turned", before="void", file="shaders/b.glsl"))
        self.assertEqual(code, 2, said)
        self.assertIn("has no shader that is made of shaders/b.glsl", said)

    def test_tests_that_fail_anyway_see_nothing(self):
        code, said = self.mutants(entry("turned", tests="Broken.*"))
        self.assertEqual(code, 2, said)
        self.assertIn("without it Broken.IsSeen fails", said)

    def test_one_that_does_not_build_is_said(self):
        code, said = self.mutants(entry("odd", after="!"))
        self.assertEqual(code, 2, said)
        self.assertIn("it does not build: a.cpp:1: error", said)

    def test_filters_that_name_no_test_are_said(self):
        code, said = self.mutants(entry("turned", tests="None.*"))
        self.assertEqual(code, 2, said)
        self.assertIn("prog has no test None.*", said)

    def test_what_was_left_planted_is_taken_back(self):
        kept = self.root / "build/mutants/a.cpp"
        kept.parent.mkdir(parents=True)
        kept.write_text("a -b c\n")
        (self.root / "a.cpp").write_text("a +b c\n")
        code, said = self.mutants(entry("turned"))
        self.assertEqual(code, 0, said)

    def test_bad_entries_are_named(self):
        for table, words in ((entry("gone", before="-z"), "a.cpp has '-z' 0 times, expected once"),
                             (entry("a") + entry("a"), "its name is taken"), (entry("a", kind="odd"), "kind is 'odd', expected"),
                             (entry("a") + "more = 1\n", "'more' is not known"), ("[[mutant]]\n", "'name' is missing")):
            code, said = self.mutants(table)
            self.assertEqual(code, 2, said)
            self.assertEqual(len(said.splitlines()), 1, said)
            self.assertIn(words, said)

    def test_the_trees_own_find_their_places(self):
        done = subprocess.run([MUTANTS, "--list"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        number = int(done.stdout.splitlines()[-1].split()[0])
        self.assertGreaterEqual(number, 100)


if __name__ == "__main__":
    unittest.main()
