"""gpu_check_test.py: scripts/gpu_check with programs that hang, crash and differ as they are told. No Vulkan is needed."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
CHECK = HERE.parents[1] / "scripts/gpu_check"


class GpuCheck(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        self.program("seaglass", HERE / "fake_seaglass.py")
        for name in ("reflection_gpu_tests", "water_gpu_tests", "host_gpu_tests", "defects_gpu_tests"):
            self.program(name, HERE / "fake_programs.py")
        for name in ("seaglass_bench_waves", "seaglass_bench_reflection"):
            (self.bin / name).write_text(f"#!/bin/sh\necho {name} $*\n")
            (self.bin / name).chmod(0o755)
        self.report, self.log = self.folder / "page.md", self.folder / "log"

    def program(self, name, fake):
        (self.bin / name).write_text(f"#!/bin/sh\nexec {sys.executable} -BS {fake} \"$@\"\n")
        (self.bin / name).chmod(0o755)

    def check(self, *options, tests="A.Passes", **told):
        """(exit code, what it said, the page)"""
        environment = {**os.environ, "FAKE_TESTS": tests, "FAKE_LOG": str(self.log), **told}
        done = subprocess.run([CHECK, "--bin", self.bin, "-o", self.report, "--each", "1", *options], capture_output=True,
                              text=True, env=environment, timeout=60)
        return done.returncode, done.stdout + done.stderr, self.report.read_text() if self.report.exists() else ""

    def some(self, *options, **told):
        return self.check("--scenes", "harbour,floor", "--qualities", "low,high", *options, **told)

    def refused(self, expected, *options, **told):
        code, said, page = self.check(*options, **told)
        self.assertEqual(code, 2)
        self.assertEqual(len(said.splitlines()), 1, said)
        self.assertIn(expected, said)
        self.assertEqual(page, "")

    def test_all_is_well(self):
        code, said, page = self.check()
        self.assertEqual(code, 0, said)
        self.assertEqual(said.splitlines()[-1], "4 passed, 0 failed, 0 skipped")
        self.assertIn("| device | Some GPU (discrete) |", page)
        self.assertIn("| driver | Some driver 1.2, (build 3) |", page)
        self.assertIn("29 of 29 pictures are as they should be", page)
        self.assertIn("| harbour |  | 1.500 | 1.500 | 1.500 | 1.500 |", page)
        self.assertIn("| floor | 1.500 |  |  |  |  |", page)
        self.assertIn("| harbour | surface |  | 0.250 | 0.250 | 0.250 | 0.250 |", page)
        self.assertIn("| harbour | (floor) |  | 0.062 | 0.062 | 0.062 | 0.062 |", page)
        self.assertIn("Clock: timestamps.", page)
        self.assertIn("seaglass_bench_waves 256 3 60", page)
        self.assertNotIn("not finished", page)
        self.assertNotIn("Left out", page)

    def test_what_is_asked_for_stands_on_the_page(self):
        code, said, page = self.check("--skip-benches", "--qualities", "low", "--filter", "A.*", "--each", "30")
        self.assertEqual(code, 0, said)
        self.assertIn("| options | `--skip-benches --filter 'A.*' --qualities low --each 30` |", page)

    def test_what_hangs_or_crashes_is_one_line_and_the_others_run(self):
        code, said, page = self.some(tests="A.Passes A.Hangs B.Passes B.Crashes B.Fails/0 B.Skips C.Passes")
        self.assertEqual(code, 1)
        self.assertEqual(said.splitlines()[-1], "12 passed, 12 failed (4 timed out), 4 skipped")
        self.assertIn("- `water_gpu_tests` `A.Hangs` timed out: did not end in 1 s", page)
        self.assertIn("- `water_gpu_tests` `B.Crashes` crashed: ended by SIGSEGV", page)
        self.assertIn("- `water_gpu_tests` `B.Fails/0` failed: fake_programs.py:34: Expected equality of these values: 1 | 1 2", page)
        self.assertIn("fake_programs.py:56: nothing to test with", page)
        # All, those behind the one that hung, those behind the one that crashed.
        self.assertEqual(self.log.read_text().split()[:3], ["7", "5", "3"])

    def test_a_process_that_lost_the_device_tests_no_more(self):
        code, said, page = self.some(tests="A.Loses B.Passes C.Passes")
        self.assertEqual(code, 1)
        self.assertEqual(said.splitlines()[-1], "8 passed, 4 failed, 0 skipped")
        self.assertEqual(self.log.read_text().split()[:2], ["3", "2"])

    def test_it_stops_where_the_device_answers_no_more_behind_a_test(self):
        code, said, page = self.some(tests="A.Passes A.Hangs B.Passes", FAKE_HUNG=str(self.folder / "hung"))
        self.assertEqual(code, 1)
        self.assertEqual(said.splitlines()[-1], "1 passed, 1 failed (1 timed out), 1 skipped (1 not run)")
        self.assertIn("The device no longer answers, behind reflection_gpu_tests", page)
        self.assertIn("not run: the device no longer answers", page)

    def test_it_stops_where_the_device_answers_no_more_behind_a_frame(self):
        code, said, page = self.some(FAKE_HANGS="harbour_high", FAKE_HUNG=str(self.folder / "hung"))
        self.assertEqual(code, 1)
        self.assertIn("The device no longer answers, behind `", page)
        self.assertIn("| harbour |  | 1.500 | not finished |", page)  # and what was finished is kept
        self.assertNotIn("## Tests", page)
        self.assertIn("**Left out: 1 of 3 frames, 3 of 3 pictures, seaglass_bench_waves, seaglass_bench_reflection, all of", page)

    def test_a_frame_that_hangs_is_one_cell(self):
        code, said, page = self.some(FAKE_HANGS="harbour_high")
        self.assertEqual(code, 1)
        self.assertIn("| harbour |  | 1.500 | did not end in 1 s |", page)
        self.assertIn("4 passed", page)

    def test_a_picture_that_differs_fails(self):
        code, said, page = self.some("--skip-tests", FAKE_DIFFERS="harbour_level_low")
        self.assertEqual(code, 1)
        self.assertIn("| harbour |  | **0.3000** | 0.0010 |", page)
        self.assertIn("2 of 3 pictures are as they should be", page)
        self.assertEqual(said.splitlines()[-1], "0 passed, 0 failed, 0 skipped")

    def test_it_ends_in_time_and_keeps_what_it_has(self):
        began = time.monotonic()
        code, said, page = self.some("--seconds", "4", "--each", "50", tests="A.Passes A.Hangs B.Passes")
        self.assertLess(time.monotonic() - began, 30)  # an hour without
        self.assertEqual(code, 1)
        self.assertIn("not run: out of time", page)
        # However long the fakes took to begin.
        self.assertRegex(page, r"Left out: [23] of reflection_gpu_tests, all of water_gpu_tests, all of host_gpu_tests, all of defects")
        self.assertIn("| harbour |  | 1.500 | 1.500 |", page)

    def test_programs_that_do_not_run_are_a_line_each(self):
        (self.bin / "water_gpu_tests").write_text("#!/bin/sh\necho no device to test on: none >&2\nexit 2\n")
        code, said, page = self.some()
        self.assertEqual(code, 1)
        self.assertIn("- `water_gpu_tests` `(the program itself)` crashed: exit 2: no device to test on: none", page)
        self.assertEqual(said.splitlines()[-1], "3 passed, 1 failed, 0 skipped")

    def test_to_run_no_test_is_no_pass(self):
        code, said, page = self.some(tests="")
        self.assertEqual(code, 1)
        self.assertIn("No test matches --filter '*'", page)

    def test_a_cpu_device_is_refused_unless_it_is_meant(self):
        self.refused("llvmpipe is a CPU device, expected a GPU, or --cpu if it is meant", FAKE_KIND="cpu", FAKE_NAME="llvmpipe")
        code, said, page = self.some("--cpu", FAKE_KIND="cpu")
        self.assertEqual(code, 0)
        self.assertTrue(page.startswith("# Seaglass on a CPU device: a dry run"), page)
        self.assertIn("## Milliseconds a frame at 320x180", page)
        self.assertIn("## `seaglass_bench_reflection 640x360 5 half sspr`", page)

    def test_bad_input_is_one_line(self):
        self.refused("--nope", "--nope")
        self.refused("--scenes is 'pond', expected some of floor, harbour,", "--scenes", "pond")
        self.refused("--qualities is 'best', expected some of low, medium", "--qualities", "best")
        self.refused("--size is 'big', expected WIDTHxHEIGHT", "--size", "big")
        self.refused("--seconds is 0, expected more than 0", "--seconds", "0")
        self.refused("where there is no seaglass", "--bin", str(self.folder))

    def test_a_program_that_is_not_there_is_a_line(self):
        (self.bin / "defects_gpu_tests").unlink()
        code, said, page = self.some()
        self.assertEqual(code, 1)
        self.assertIn("- `defects_gpu_tests` `(the program itself)` crashed: exit 127: it cannot be run: No such file or directory", page)


if __name__ == "__main__":
    unittest.main()
