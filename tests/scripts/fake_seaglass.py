#!/usr/bin/env python3
"""Stands in for the program in gpu_check_test.py: says what FAKE_* ask for, and draws nothing."""
import json
import os
import pathlib
import sys
import time


def after(option, otherwise=""):
    return sys.argv[sys.argv.index(option) + 1] if option in sys.argv else otherwise


name, kind = os.environ.get("FAKE_NAME", "Some GPU"), os.environ.get("FAKE_KIND", "discrete")
hung = pathlib.Path(os.environ["FAKE_HUNG"]) if "FAKE_HUNG" in os.environ else None
command = sys.argv[1]
if command == "--version":
    print("seaglass 0.0.0")
elif command == "devices":
    print(f"{name} ({kind}, Some driver 1.2, (build 3)): supported")
elif command == "render":
    scene, quality = pathlib.Path(sys.argv[2]).stem, after("--quality", "own")
    if hung and hung.exists():
        sys.exit("vkCreateDevice failed: VK_ERROR_INITIALIZATION_FAILED")
    if f"{scene}_{quality}" == os.environ.get("FAKE_HANGS"):
        if hung:
            hung.touch()
        time.sleep(3600)
    pathlib.Path(after("-o")).write_text("a picture")
    if after("--stats"):
        pathlib.Path(after("--stats")).write_text(json.dumps({
            "frame_ms": 9.5, "gpu_frame_ms": 1.5, "clock": "timestamps", "floor_ms": 0.0625, "more": [],
            "passes": [{"name": "surface", "ms": 0.25, "spread_ms": 0, "also": 1}]}))
    print(f"{name}: {after('--size')}, 1.0 ms a frame, {after('-o')}")
elif command == "compare":
    golden = pathlib.Path(sys.argv[2])
    if not golden.exists():
        sys.exit(f"{golden}: no such file")
    differs = golden.parent.name == os.environ.get("FAKE_DIFFERS")
    pathlib.Path(after("--json")).write_text(json.dumps({"flip": {"mean": 0.3 if differs else 0.001}}))
