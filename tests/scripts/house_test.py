"""house_test.py: scripts/house over a tree of its own, in which each bar is met and then missed; and over this one."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
HOUSE = ROOT / "scripts/house"

BARS = {
    "bytes of SPIR-V in the libraries": 2000000,
    "bytes of libseaglass_water.a": 5000000,
    "files in a folder of sources": 25,
    "lines of the longest function in shaders": 60,
    "lines of the longest function in C++": 80,
    "includes of another library's private header": 0,
    "tests named otherwise than most": 0,
    "files that name a quality field, tests aside": 5,
    "files that name a uniform": 3,
    "files of the libraries that name hybrid": 4,
    "lines of public headers": 1000,
    "public headers that do not compile alone": 0,
    'comments of public headers that say only "as X()"': 0,
}

CLEAN = {
    "gpu/include/seaglass/host.h": "#pragma once\nvoid destroyAll(); ///< as a host does\n",
    "reflection/core/mirror.h": "#include \"gpu/memory/image.h\"\n",
    "gpu/memory/image.h": "",
    "reflection/interface/drawn.h": "",
    "water/include/seaglass/water.h": "#pragma once\nstruct ShadingDesc {\n    unsigned slopeSamples = 1; ///< a pixel\n};\n",
    "water/interface/fields/water.h": "#include \"seaglass/water.h\"\ntemplate<auto member> constexpr int field(const char*) { return 0; }\n"
                                             "constexpr int rows[] = {field<&ShadingDesc::slopeSamples>(\"slopeSamples\")};\n",
    "water/sea/sea.h": "",
    "demos/tools/reference/sea.cpp": "#include \"water/sea/sea.h\"\n#include \"water/interface/checks.h\"\n",
    "water/interface/checks.h": "",
    "water/mirror.cpp": "#include \"gpu/memory/image.h\"\n#include \"reflection/interface/drawn.h\"\nvoid put(MirrorBlock& block) { block.steepness = 1; }\n",
    "shaders/shared/mirror_block.h": "struct MirrorBlock {\n    float steepness; // none\n    float pad0;\n};\n",
    "shaders/mirror.frag": "uniform Mirror { MirrorBlock mirror; };\nvoid main() {\n    mirror.steepness;\n}\n",
    "tests/unit/one_test.cpp": "",
    "tests/unit/two_test.cpp": "",
    "build/release/water/libseaglass_water.a": "!<arch>",
    "build/release/water/generated/spirv/mirror.frag.h": "const uint32_t mirror_frag[] = {0x07230203,0x00010500};\n",
    "build/release/tests/spirv/shaders.txt": "/somewhere/build/release/water/generated/spirv/mirror.frag.h\n",
}


def function(lines):
    return "int f(int x) {\n" + "    x += 1;\n" * (lines - 3) + "    return x;\n}\n"


class House(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name)
        for name, text in CLEAN.items():
            self.write(name, text)

    def write(self, name, text):
        path = self.tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def house(self, tree, *options):
        """(exit code, {bar: (state, value)}, the places)"""
        done = subprocess.run([HOUSE, "--tree", tree, *options], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.stderr, "")
        bars, places = {}, []
        for line in done.stdout.splitlines():
            if line.startswith(" "):
                places.append(line.strip())
                continue
            state, *value, _, limit, what = line.split(maxsplit=4 if not line.startswith("unknown") else 3)
            name = what.partition(" (")[0]
            self.assertEqual(int(limit), BARS[name], line)
            bars[name] = state, int(value[0]) if value else None
        self.assertEqual(bars.keys(), BARS.keys())
        return done.returncode, bars, places

    def missed(self, bar, value, place=None):
        code, bars, places = self.house(self.tree)
        self.assertEqual(code, 1)
        self.assertEqual(bars.pop(bar), ("OVER", value))
        self.assertEqual({state for state, _ in bars.values()}, {"ok"}, bars)
        if place:
            self.assertIn(place, places)

    def test_this_tree_has_a_value_for_each_bar(self):
        _, bars, _ = self.house(ROOT)
        for name in ("lines of the longest function in shaders", "lines of the longest function in C++", "files in a folder of sources",
                     "files that name a quality field, tests aside", "files that name a uniform", "lines of public headers"):
            self.assertGreater(bars[name][1], 1, name)

    def test_a_tree_that_meets_all_is_said_to(self):
        code, bars, places = self.house(self.tree)
        self.assertEqual((code, places), (0, []), bars)
        self.assertEqual(bars["bytes of SPIR-V in the libraries"], ("ok", 8))
        self.assertEqual(bars["bytes of libseaglass_water.a"], ("ok", 7))
        self.assertEqual(bars["files that name a uniform"], ("ok", 3))
        self.assertEqual(bars["files that name a quality field, tests aside"], ("ok", 2))

    def test_what_is_not_built_is_unknown(self):
        (self.tree / "build/release/water/libseaglass_water.a").unlink()
        code, bars, _ = self.house(self.tree)
        self.assertEqual((code, bars["bytes of libseaglass_water.a"]), (1, ("unknown", None)))

    def test_long_functions(self):
        self.write("water/long.cpp", "namespace a {\n" + function(81) + "}\n")
        self.missed("lines of the longest function in C++", 81, "81 water/long.cpp:2 f")
        (self.tree / "water/long.cpp").unlink()
        self.write("shaders/long.glsl", function(61))
        self.missed("lines of the longest function in shaders", 61, "61 shaders/long.glsl:1 f")

    def test_many_files(self):
        for i in range(26):
            self.write(f"demos/host/{i}.cpp", "")
        self.missed("files in a folder of sources", 26, "26 demos/host")

    def test_private_headers_of_others(self):
        self.write("water/look.cpp", '#include "reflection/core/mirror.h"\n')
        self.missed("includes of another library's private header", 1, "water/look.cpp includes reflection/core/mirror.h")
        self.write("demos/host/look.cpp", '#include "gpu/memory/image.h"\n#include "host/look.h"\n')
        self.missed("includes of another library's private header", 2, "demos/host/look.cpp includes gpu/memory/image.h")
        self.write("demos/tools/view/sea.cpp", '#include "water/sea/sea.h"\n')
        self.missed("includes of another library's private header", 3, "demos/tools/view/sea.cpp includes water/sea/sea.h")

    def test_two_ways_to_name_tests(self):
        self.write("tests/unit/three_tests.cpp", "")
        self.missed("tests named otherwise than most", 1, "tests/unit/three_tests.cpp")

    def test_a_setting_with_many_homes(self):
        self.write("demos/scene/other.cpp", "int slopeSamples; // not ShadingDesc::slopeSamples\nint f(Other& o) { return o.slopeSamples; }\n")
        self.write("shaders/other.glsl", "int slopeSamples;\n")
        for i in range(4):
            self.write(f"demos/scene/{i}.cpp", "void f(const ShadingDesc& s, int);\nint x = s.slopeSamples;\n")
        self.write("tests/unit/five_test.cpp", '"slopeSamples"')
        self.missed("files that name a quality field, tests aside", 6, "6 ShadingDesc::slopeSamples")
        self.write("shaders/shared/look_constants.h", "CONSTANT(0, int, slopeSamples, 1)\n")
        self.missed("files that name a quality field, tests aside", 8, "8 ShadingDesc::slopeSamples")

    def test_a_uniform_with_many_homes(self):
        self.write("shaders/other.comp", "uniform Other { MirrorBlock other; };\nfloat x = other.steepness;\n")
        self.write("water/steep.cpp", "float steepness; // of something else\n")
        self.missed("files that name a uniform", 4, "4 MirrorBlock.steepness")

    def test_a_technique_with_many_homes(self):
        for i in range(5):
            self.write(f"reflection/{i}.cpp", "void makeHybrid();\n")
        self.missed("files of the libraries that name hybrid", 5, "reflection/0.cpp")

    def test_public_headers(self):
        header = CLEAN["gpu/include/seaglass/host.h"]
        self.write("gpu/include/seaglass/host.h", header + "void destroyOne(); ///< as destroyAll()\n")
        self.missed('comments of public headers that say only "as X()"', 1)
        self.write("gpu/include/seaglass/host.h", header + "std::size_t size();\n")
        self.missed("public headers that do not compile alone", 1)
        self.write("gpu/include/seaglass/host.h", header + "\n" * 1000)
        self.missed("lines of public headers", 1006)

    def test_bad_input_is_one_line(self):
        done = subprocess.run([HOUSE, "--tree", self.tree / "none"], capture_output=True, text=True)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1))


if __name__ == "__main__":
    unittest.main()
