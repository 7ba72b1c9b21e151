"""looks_test.py: scripts/looks with a program that draws nothing. Needs no Vulkan."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
LOOKS = HERE.parents[1] / "scripts/looks"


class Looks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "seaglass"

    def looks(self, *options, program=f'exec {sys.executable} -BS {HERE / "fake_seaglass.py"} "$@"'):
        """(exit code, what it said, the page)"""
        self.program.write_text(f"#!/bin/sh\n{program}\n")
        self.program.chmod(0o755)
        page = self.folder / "out/index.html"
        done = subprocess.run([LOOKS, "--program", self.program, "-o", page.parent, *options], capture_output=True, text=True,
                              timeout=60)
        return done.returncode, done.stdout + done.stderr, page.read_text() if page.exists() else ""

    def test_every_camera_wind_and_sun_is_on_the_page(self):
        code, said, page = self.looks("ocean", "--winds", "3,25", "--suns", "46,own")
        self.assertEqual(code, 0, said)
        self.assertEqual(page.count("<img"), 4 * 2 * 2)
        for camera in ("level", "low", "high", "tour"):
            self.assertIn(f"ocean_{camera}_25_46.png", page)
            self.assertTrue((self.folder / f"out/ocean_{camera}_25_46.png").exists())
        self.assertIn("water.waves.wind_m_s=25", page)
        self.assertIn("sky.clear=true --set sun.elevation_deg=46", page)

    def test_heights_and_forces(self):
        code, said, page = self.looks("storm", "--heights", "2,1000", "--winds", "8,25", "--suns", "own")
        self.assertEqual(code, 0, said)
        self.assertEqual(page.count("<img"), 2 * 2)
        self.assertIn("camera.near.position_m=[0.0, 1000.0, 0.0]", page)
        for force in (5, 10):   # of 8 and 25 m/s
            self.assertIn(f"water.waves.beaufort={force}", page)

    def test_what_fails_is_named(self):
        code, said, page = self.looks("pool", "--cameras", "edge", "--winds", "3", "--suns", "own", program="echo bad >&2; exit 1")
        self.assertEqual((code, page.count("<img")), (1, 0))
        self.assertIn("pool_edge_3_own: bad", said)

    def test_an_unknown_scene_is_one_line(self):
        code, said, page = self.looks("oceans")
        self.assertEqual((code, len(said.splitlines()), page), (2, 1, ""), said)


if __name__ == "__main__":
    unittest.main()
