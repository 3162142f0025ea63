"""Compare the speed of the library with that of others, and write the table the book shows.

``make bench`` runs it. Every route first has to give the same points; then all of them take
turns, so that whatever else the machine does falls on all of them alike. The table holds ratios,
because milliseconds are a property of the machine.

Each route lives in a process of its own. In a shared process the routes would inherit each
other's heap, and on Linux that decides what they cost: see the page book/speed.md. For the same
reason every route runs in two kinds of process, one with everything as installed and one where
the C library keeps freed memory and waiting threads sleep.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import IO, cast

import numpy as np

from labutils import get_camera_intrinsics, make_renderer, make_scene, render_camera
from tools import ROOT
from tools.bench import routes

TABLE = ROOT / "book" / "_generated" / "bench.md"
CAMERA, WIDTH, HEIGHT = "head_camera", 640, 480

# What the GNU C library needs to hear to keep memory; other systems ignore the variable.
_KEEP = 1 << 28
KEEP_MEMORY = {
    "GLIBC_TUNABLES": ":".join(
        f"glibc.malloc.{name}={_KEEP}" for name in ("trim_threshold", "mmap_threshold", "top_pad")
    )
}
# Threads that wait by spinning take the processor from each other on a machine with few cores.
PATIENT_THREADS = {"OMP_WAIT_POLICY": "passive"}

#: Column of the table to the variables its processes get.
SETTINGS = {"as installed": {}, "tuned": KEEP_MEMORY | PATIENT_THREADS}

# Between two turns: threads of the last route that still spin have gone to sleep by then.
PAUSE_S = 0.02

TOLERANCE = 1e-5  # meters and shares of color: float32 against float64
PACKAGES = {
    "MuJoCo": ("mujoco",),
    "NumPy": ("numpy",),
    "OpenCV": ("opencv-python-headless",),
    "Open3D": ("open3d-cpu", "open3d"),  # the small build on Linux, the only one elsewhere
}

# A turn is a burst, as in a camera loop; its first run only wakes the process and fills
# the caches. A rendering takes a hundred times as long, and no caches outlive it.
CLOUD_BURST, RENDER_BURST = 20, 1


class Worker:
    """A process that runs one route when it is its turn."""

    def __init__(self, route: str, frame: Path, variables: dict[str, str]) -> None:
        self.route = route
        self.process = subprocess.Popen(
            [sys.executable, "-m", routes.__name__, route, str(frame)],
            cwd=ROOT,
            env=os.environ | variables,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.asked = cast("IO[str]", self.process.stdin)
        self.answers = cast("IO[str]", self.process.stdout)

    def ask(self, command: str) -> str:
        """Send one line, return the answer."""
        self.asked.write(command + "\n")
        self.asked.flush()
        answer = self.answers.readline().strip()
        if not answer:
            raise SystemExit(f"bench: the route {self.route!r} stopped; its error is above")
        return answer

    def stop(self) -> None:
        """End the process and wait for it."""
        self.asked.close()
        self.process.wait()


def main() -> int:
    """Measure, print the table and write it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=40, help="turns per route, at least 40")
    parser.add_argument("--out", type=Path, default=TABLE, help="file to write")
    options = parser.parse_args()
    if options.rounds < 40:
        parser.error("--rounds: expected at least 40, for a median that stays")
    with tempfile.TemporaryDirectory() as folder:
        frame = save_frame(Path(folder))
        clouds = {
            setting: measure_group(
                list(routes.CLOUD), frame, variables, options.rounds, CLOUD_BURST
            )
            for setting, variables in SETTINGS.items()
        }
        renders = measure_group(list(routes.RENDER), frame, {}, options.rounds, RENDER_BURST)
    table = make_table(clouds, renders)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(table, encoding="utf-8")
    print_milliseconds(clouds, renders)
    print(table)
    return 0


def save_frame(folder: Path) -> Path:
    """Render the real head camera once; every route gets this frame."""
    model, data = make_scene()
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        rgb, depth = render_camera(model, data, renderer, CAMERA)
    K, _ = get_camera_intrinsics(model, CAMERA, WIDTH, HEIGHT)
    path = folder / "frame.npz"
    np.savez(path, rgb=rgb, depth=depth, K=K)
    return path


def measure_group(
    routes: list[str], frame: Path, variables: dict[str, str], rounds: int, burst: int
) -> dict[str, list[float]]:
    """Verify that the routes agree, then let them take turns; return seconds per route."""
    workers = [Worker(route, frame, variables) for route in routes]
    try:
        verify(workers, frame.parent)
        for worker in workers:  # lazy imports, the heap's own habits
            worker.ask("run 5")
        seconds: dict[str, list[float]] = {worker.route: [] for worker in workers}
        for turn in range(rounds):
            # Another one starts every time, so none always follows the same neighbor.
            start = turn % len(workers)
            for worker in workers[start:] + workers[:start]:
                time.sleep(PAUSE_S)
                answer = [float(word) for word in worker.ask(f"run {burst}").split()]
                seconds[worker.route].extend(answer[1:] or answer)
    finally:
        for worker in workers:
            worker.stop()
    return seconds


def verify(workers: list[Worker], folder: Path) -> None:
    """Stop unless every route that claims the same result gives it."""
    reference = None
    for worker in workers:
        path = folder / "result.npz"
        worker.ask(f"save {path}")
        with np.load(path) as file:
            result = [file[name] for name in sorted(file.files)]
        if worker.route in routes.NOT_COMPARABLE:
            continue
        if reference is None:
            reference = result
        for ours, theirs in zip(reference, result, strict=True):
            same = ours.shape == theirs.shape
            if not (same and np.allclose(ours, theirs, rtol=0, atol=TOLERANCE)):
                raise SystemExit(f"bench: {worker.route!r} does not give the result of the others")


def make_table(clouds: dict[str, dict[str, list[float]]], renders: dict[str, list[float]]) -> str:
    """Write both comparisons as MyST tables of ratios."""
    lines = [
        "% written by tools/bench/clouds.py (make bench); do not edit",
        "",
        f":::{{table}} From RGB-D to a colored cloud at {WIDTH}x{HEIGHT}: times labutils",
        "| route | as installed | tuned |",
        "|---|---:|---:|",
    ]
    for route, label in routes.CLOUD.items():
        cells = [format_ratio(times[route], times["labutils"]) for times in clouds.values()]
        lines.append(f"| {label} | {' | '.join(cells)} |")
    lines += [
        ":::",
        "",
        f":::{{table}} RGB and depth of one frame at {WIDTH}x{HEIGHT}: times the bare passes",
        "| route | time |",
        "|---|---:|",
    ]
    for route, label in routes.RENDER.items():
        lines.append(f"| {label} | {format_ratio(renders[route], renders['bare'])} |")
    versions = ", ".join(f"{name} {find_version(names)}" for name, names in PACKAGES.items())
    lines += [
        ":::",
        "",
        f"Ratios of medians; in brackets, of the fastest runs. Measured with {versions}.",
        "",
    ]
    return "\n".join(lines)


def find_version(packages: tuple[str, ...]) -> str:
    """Return the version of the first package that is installed."""
    for package in packages:
        try:
            return version(package)
        except PackageNotFoundError:
            continue
    raise SystemExit(f"bench: expected one of {', '.join(packages)} to be installed")


def format_ratio(times: list[float], reference: list[float]) -> str:
    """Return the ratio of the medians and, in brackets, of the fastest runs."""
    median = statistics.median(times) / statistics.median(reference)
    fastest = min(times) / min(reference)
    return f"{_round(median)} ({_round(fastest)})"


def _round(ratio: float) -> str:
    return f"{ratio:.1f}" if ratio > 2 else f"{ratio:.2f}"


def print_milliseconds(
    clouds: dict[str, dict[str, list[float]]], renders: dict[str, list[float]]
) -> None:
    """Print what this machine took: not for the page, where it would be no one's number."""
    print(f"{'milliseconds':44} {'median':>8} {'fastest':>8}")
    for title, group in [*clouds.items(), ("render", renders)]:
        for route, times in group.items():
            median, fastest = 1000 * statistics.median(times), 1000 * min(times)
            print(f"{title + ': ' + route:44} {median:8.3f} {fastest:8.3f}")
    print()


if __name__ == "__main__":
    sys.exit(main())
