"""Measure Python in the page: from the first click to the result, and every check after.

The same check runs here, natively, in a process of its own for the first and in this one for the
later, so that the times can be read as ratios: those of a machine that is busy, or slow, keep
their meaning. Needs a built book with its wheels, and Chromium.

Usage: ``python -m tools.bench.page_python [--rounds 3]``; ends with an error where there is no
built book with its wheels.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from labutils.checks import judge
from labutils.checks.table import load_table
from tools import ROOT
from tools.vendor import npm

HTML = ROOT / "_build" / "html"
SCRIPT = Path(__file__).with_suffix(".mjs")
PAGE, EXERCISE = "exercises/step4_color", "segment_by_color"
TURNS = 10

# A wrong answer that is recognized and drawn: nothing a check does is left out.
CODE = """
import cv2

def segment_by_color(rgb_image, target_hsv_range):
    low, high = target_hsv_range
    return cv2.inRange(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV), low, high)
"""
COLD_CHECK = f"""
from labutils.checks import judge
from labutils.checks.table import load_table
{CODE}
judge(load_table({EXERCISE!r}), {EXERCISE})._repr_html_()
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the times and the ratios; return a shell's exit code."""
    parser = argparse.ArgumentParser(description="Measure Python in the page.")
    parser.add_argument("--rounds", type=int, default=3, help="browsers that are opened")
    options = parser.parse_args(arguments)
    if not has_wheels():
        print("python in the page: not measured; no built book that holds the wheels")
        return 1
    npm.install()
    first: list[float] = []
    later: list[float] = []
    cold: list[float] = []
    warm: list[float] = []
    for _ in range(options.rounds):  # in turns: what else the machine does falls on both
        page = measure_page()
        first.append(page["first"])
        later += page["later"]
        cold.append(measure_cold())
        warm += measure_warm()
    print_line("first click to result", first, "a new native Python", cold)
    print_line("every later check", later, "the native check", warm)
    return 0


def has_wheels() -> bool:
    """Tell whether there is a built book that holds NumPy for its pages."""
    return (HTML / "_static" / "python" / "vendor" / "numpy.zip.0.js").is_file()


def print_line(what: str, ours: list[float], peer: str, theirs: list[float]) -> None:
    """Print the ratio of two medians, and what this machine took."""
    a, b = statistics.median(ours), statistics.median(theirs)
    print(f"{what:<22} {a / b:5.1f} x {peer} ({a:.0f} ms to {b:.0f} ms on this machine)")


def measure_page() -> dict[str, Any]:
    """Open the page in a new browser and check there."""
    arguments = [str(SCRIPT), str(HTML), PAGE, EXERCISE, CODE, str(TURNS)]
    command = [*npm.find_node(), *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"python in the page: {done.stderr.strip()[-500:]}")
    times = json.loads(done.stdout)
    if times["said"] != "failed":
        raise SystemExit(f"python in the page: a wrong answer was {times['said']}")
    return times


def measure_cold() -> float:
    """Start a Python, import everything and check, in milliseconds."""
    started = time.perf_counter()
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    subprocess.run(
        [sys.executable, "-c", COLD_CHECK],
        cwd=ROOT,
        env=environment,
        check=True,
        stdout=subprocess.DEVNULL,
    )
    return 1000 * (time.perf_counter() - started)


def measure_warm() -> list[float]:
    """Check once more in this Python, several times."""
    times = []
    for _ in range(TURNS):
        space: dict[str, object] = {}
        started = time.perf_counter()
        exec(CODE, space)  # noqa: S102 - our own
        judge(load_table(EXERCISE), space[EXERCISE])._repr_html_()
        times.append(1000 * (time.perf_counter() - started))
    return times


if __name__ == "__main__":
    sys.exit(main())
