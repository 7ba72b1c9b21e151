"""drivers_test.py: scripts/drivers with test programs that do as they are told. Nothing is fetched and no Vulkan is needed."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
DRIVERS = HERE.parents[1] / "scripts/drivers"


class Drivers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name in ("reflection_gpu_tests", "water_gpu_tests", "host_gpu_tests", "defects_gpu_tests", "null_tests", "every_surface"):
            (self.folder / name).write_text(f"#!/bin/sh\nexec {sys.executable} -B {HERE / 'fake_programs.py'} \"$@\"\n")
            (self.folder / name).chmod(0o755)

    def drivers(self, *options, tests="A.Passes", known=""):
        (self.folder / "known.txt").write_text(known)
        environment = {**os.environ, "FAKE_TESTS": tests, "FAKE_LOG": str(self.folder / "log")}
        done = subprocess.run([DRIVERS, "--bin", self.folder, "--known", self.folder / "known.txt", "--each", "1", *options],
                              capture_output=True, text=True, env=environment, timeout=60)
        return done.returncode, done.stdout + done.stderr

    def last(self, code, line, *options, **told):
        done, said = self.drivers("lavapipe", *options, **told)
        self.assertEqual(done, code, said)
        self.assertEqual(said.splitlines()[-1], line)
        return said

    def refused(self, expected, *options, **told):
        code, said = self.drivers(*options, **told)
        self.assertEqual(code, 2)
        self.assertEqual(len(said.splitlines()), 1, said)
        self.assertIn(expected, said)

    def test_what_passes_passes(self):
        self.last(0, "8 passed, 0 failed, 0 skipped", tests="A.Passes B.Passes")

    def test_what_hangs_crashes_or_fails_is_named(self):
        said = self.last(1, "8 passed, 12 failed, 4 skipped", tests="A.Passes A.Hangs B.Crashes B.Fails B.Skips C.Passes")
        self.assertIn("lavapipe: A.Hangs timed out: did not end in 1 s", said)
        self.assertIn("lavapipe: B.Crashes crashed: ended by SIGSEGV", said)
        self.assertIn("lavapipe: B.Fails failed: fake_programs.py:34: Expected equality", said)
        cells = next(line for line in said.splitlines() if "water_gpu_tests" in line).split()
        self.assertEqual(cells, ["lavapipe", "water_gpu_tests", "2", "3", "1", "0", "1", "0"])

    def test_what_is_known_to_fail_may(self):
        known = "# a comment\n\nlavapipe fails B.F* it rounds\nlavapipe slow A.Hangs it compiles\n"
        self.last(0, "4 passed, 0 failed, 8 skipped", tests="A.Passes A.Hangs B.Fails", known=known)
        self.last(1, "4 passed, 4 failed, 4 skipped", "--slow", tests="A.Passes A.Hangs B.Fails", known=known)
        # What is known of another driver counts for nothing.
        self.last(1, "4 passed, 4 failed, 0 skipped", tests="A.Passes B.Fails", known="trixie fails B.Fails it rounds\n")

    def test_what_is_known_to_fail_and_passes_is_said(self):
        said = self.last(1, "0 passed, 4 failed, 0 skipped", known="lavapipe fails A.Passes it rounds\n")
        self.assertIn("lavapipe: A.Passes passes, but known.txt says: it rounds", said)

    def test_a_program_that_does_not_run_fails(self):
        (self.folder / "host_gpu_tests").write_text("#!/bin/sh\necho no device to test on: none >&2\nexit 2\n")
        said = self.last(1, "3 passed, 1 failed, 0 skipped")
        self.assertIn("lavapipe: host_gpu_tests: exit 2: no device to test on: none", said)

    def test_to_run_no_test_is_no_pass(self):
        code, said = self.drivers("lavapipe", tests="")
        self.assertEqual(code, 2)
        self.assertIn("no test matches --filter '*'", said)

    def test_what_only_compiles_has_tests_of_its_own(self):
        code, said = self.drivers("amd")
        self.assertEqual(code, 0)
        self.assertEqual([line.split()[:3] for line in said.splitlines()[1:-1]], [["amd", "null_tests", "1"], ["amd", "every_surface", "1"]])

    def test_the_list_names_all(self):
        code, said = self.drivers("--list")
        self.assertEqual(code, 0)
        self.assertEqual([line.split()[0] for line in said.splitlines()], ["lavapipe", "swiftshader", "trixie", "amd"])

    def test_bad_input_is_one_line(self):
        self.refused("'nvidia' is no driver, expected one of lavapipe, swiftshader, trixie, amd", "nvidia")
        self.refused("--nope", "--nope")
        self.refused("--each is 0, expected more than 0", "lavapipe", "--each", "0")
        self.refused("known.txt:1: 'lavapipe fails A.B', expected: driver, fails or slow, a test, the reason", "lavapipe",
                     known="lavapipe fails A.B\n")
        self.refused("known.txt:1: 'nvidia fails A.B it is', expected", "lavapipe", known="nvidia fails A.B it is\n")
        (self.folder / "defects_gpu_tests").unlink()
        self.refused("has no defects_gpu_tests, expected: cmake --build --preset release", "lavapipe")


if __name__ == "__main__":
    unittest.main()
