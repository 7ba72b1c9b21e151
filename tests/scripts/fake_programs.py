#!/usr/bin/env python3
"""Stands in for a GoogleTest program: what its tests are called is what they do. FAKE_TESTS lists them."""
import os
import pathlib
import signal
import sys
import time

tests = os.environ["FAKE_TESTS"].split()
options = dict(argument.split("=", 1) for argument in sys.argv[1:] if "=" in argument)
if "--gtest_list_tests" in sys.argv:
    for test in tests:
        suite, name = test.split(".")
        print(f"{suite}.\n  {name}  # GetParam() = whatever")
    sys.exit(0)
chosen = options["--gtest_filter"].split(":")
with open(os.environ["FAKE_LOG"], "a") as log:
    print(len(chosen), file=log)
failed = False
for test in tests:
    if test not in chosen:
        continue
    print(f"[ RUN      ] {test}", flush=True)
    does = test.split(".")[1]
    if does.startswith("Hangs"):
        if "FAKE_HUNG" in os.environ:
            pathlib.Path(os.environ["FAKE_HUNG"]).touch()
        time.sleep(3600)
    if does.startswith("Crashes"):
        os.kill(os.getpid(), signal.SIGSEGV)
    if does.startswith("Loses"):
        print("fake_programs.py:12: Failure\nFailed\nvkWaitForFences failed: VK_ERROR_DEVICE_LOST")
    if does.startswith("Fails"):
        print("/some/where/fake_programs.py:34: Failure\nExpected equality of these values:\n  1 | 1\n  2")
    if does.startswith("Skips"):
        print("fake_programs.py:56: Skipped\nnothing to test with")
    failed = failed or does.startswith(("Fails", "Loses"))
    verdict = "  FAILED  " if does.startswith(("Fails", "Loses")) else "  SKIPPED " if does.startswith("Skips") else "       OK "
    print(f"[{verdict}] {test}{', where GetParam() = whatever' if failed else ''} (0 ms)", flush=True)
print(f"[  PASSED  ] some\n[  FAILED  ] {chosen[0]}")
sys.exit(1 if failed else 0)
