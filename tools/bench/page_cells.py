"""Measure the cells of a page: the first run, every later one, and a loop of simulation and sight.

The same code runs here, natively and by the ray caster, so that the times can be read as ratios:
those of a machine that is busy, or slow, keep their meaning. Needs a built book with its wheels,
and Chromium.

Usage: ``python -m tools.bench.page_cells [--rounds 3]``; ends with an error where there is no
built book with its wheels.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import time
from typing import TYPE_CHECKING

from tools import ROOT, headless
from tools.bench.page_python import HTML, has_wheels, print_line
from tools.vendor import npm

if TYPE_CHECKING:
    from collections.abc import Sequence

SCRIPT = ROOT / "tools" / "bench" / "page_cells.mjs"
PAGE = "book/step2_intrinsics"
TURNS = 20
ENVIRONMENT = {"MUJOCO_GL": "disable", "LABUTILS_GL_MISSING": "a web page has none"}

#: The set-up cell of the page, as it is read natively.
SETUP = """
import mujoco
import numpy as np
import labutils as lab
from labutils import figures
model, data = lab.make_scene()
"""
#: A plain cell: a few numbers, printed.
PLAIN = """
K, fov_y = lab.get_camera_intrinsics(model, "head_camera", 640, 480)
print(np.round(K, 2), np.rad2deg(fov_y))
"""
#: Ten steps of simulation, a picture of 160 x 120 with its depth, and where the red things are.
LOOP = """
import time
import mujoco
import labutils as lab
model, data = lab.make_scene()
renderer = lab.make_renderer(model, 120, 160)
started, frames = time.perf_counter(), 60
for _ in range(frames):
    mujoco.mj_step(model, data, nstep=10)
    rgb, depth = lab.render_camera(model, data, renderer, "head_camera")
    lab.find_object_centroid(lab.segment_by_color(rgb, lab.HSV_RANGES["red"]))
print(1000 * (time.perf_counter() - started) / frames)
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the times and the ratios; return a shell's exit code."""
    parser = argparse.ArgumentParser(description="Measure the cells of a page.")
    parser.add_argument("--rounds", type=int, default=3, help="browsers that are opened")
    options = parser.parse_args(arguments)
    if not has_wheels():
        print("cells of a page: not measured; no built book that holds the wheels")
        return 1
    npm.install()
    first: list[float] = []
    later: list[float] = []
    loop: list[float] = []
    cold: list[float] = []
    warm: list[float] = []
    native_loop: list[float] = []
    for _ in range(options.rounds):  # in turns: what else the machine does falls on both
        site = HTML.as_uri() + "/"
        page = headless.run_script(SCRIPT, site, PAGE, PLAIN, LOOP, TURNS)
        first.append(page["first"])
        later += page["later"]
        loop.append(float(page["printed"]))
        cold.append(measure_cold())
        warm += measure_warm()
        native_loop.append(float(_run(LOOP)))
    print_line("first Run to output", first, "a new native Python", cold)
    print_line("every later cell", later, "the native cell", warm)
    print_line("one turn of a loop", loop, "the native turn", native_loop)
    return 0


def measure_cold() -> float:
    """Start a Python and run the set-up cell, in milliseconds."""
    started = time.perf_counter()
    _run(SETUP)
    return 1000 * (time.perf_counter() - started)


def measure_warm() -> list[float]:
    """Run the plain cell in a native Python, several times, in milliseconds."""
    timed = f"""{SETUP}
import contextlib, io, json, time
code, times = compile({PLAIN!r}, "cell", "exec"), []
for _ in range({TURNS}):
    started = time.perf_counter()
    with contextlib.redirect_stdout(io.StringIO()):
        exec(code)
    times.append(1000 * (time.perf_counter() - started))
print(json.dumps(times))
"""
    return json.loads(_run(timed))


def _run(code: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env={**os.environ, **ENVIRONMENT, "PYTHONPATH": str(ROOT)},
        check=True,
        capture_output=True,
        text=True,
    )
    return done.stdout


if __name__ == "__main__":
    sys.exit(main())
