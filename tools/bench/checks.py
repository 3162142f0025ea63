"""Measure how long one check takes when its pictures have the size of the lab, 640x480.

The visible cases of the exercises are small. Here each exercise whose arguments are pictures gets
one large case, and a right and a wrong answer are judged: message, recognition and picture.

Usage: ``python -m tools.bench.checks``; ends with an error where a check takes 150 ms or more.
"""

from __future__ import annotations

import sys
import time
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks import judge_answers
from labutils.checks.calls import collect_answers
from solutions import Case, load_exercises
from solutions._cases import (
    make_color_scene,
    make_depth,
    make_mask,
    make_render_scene,
    make_rgb,
    spoil_depth,
)

if TYPE_CHECKING:
    from labutils.checks.table import CheckTable, Outcome

LIMIT_MS = 150
REPEATS = 5
HEIGHT, WIDTH = 480, 640


def make_large_cases() -> dict[str, Case]:
    """Make one case of 640x480 per exercise that takes or makes a picture."""
    rng = np.random.default_rng(1)
    depth = spoil_depth(rng, make_depth(rng, HEIGHT, WIDTH))
    K = np.array([[579.4, 0, 319.5], [0, 560.0, 239.5], [0, 0, 1]])
    raw = rng.uniform(0, 1, size=(HEIGHT, WIDTH)).astype(np.float32)
    scene = make_color_scene(rng, HEIGHT, WIDTH)
    args = {
        "render_camera": (make_render_scene(rng, WIDTH, HEIGHT), "head_camera"),
        "process_depth": (raw, 0.02, 12.0),
        "visualize_depth": (depth, 5.0),
        "segment_by_color": (scene, ((60, 90, 60), (90, 255, 255))),
        "find_object_centroid": (make_mask(rng, HEIGHT, WIDTH),),
        "depth_to_pointcloud": (depth, K, make_rgb(rng, HEIGHT, WIDTH)),
    }
    return {name: Case("640x480", values) for name, values in args.items()}


def measure(name: str, case: Case) -> dict[str, float]:
    """Return the best time in milliseconds for a right and for a wrong answer."""
    exercise = load_exercises()[name]
    table = exercise.freeze((case,))
    made = exercise.get_combinations()
    functions = {
        "right": exercise.make_wrong(()),
        "first mistake": exercise.make_wrong(made[0]),
        "last pair": exercise.make_wrong(made[-1]),
    }
    times = {}
    for label, function in functions.items():
        # What the learner's own function takes is not the checker's time.
        answers = collect_answers(table, function)
        times[label] = min(_time(table, answers) for _ in range(REPEATS))
    return times


def _time(table: CheckTable, answers: tuple[Outcome, ...]) -> float:
    start = time.perf_counter()
    judge_answers(table, answers)
    return 1000 * (time.perf_counter() - start)


def main() -> int:
    """Print a table; return a shell's exit code."""
    worst = 0.0
    for name, case in make_large_cases().items():
        times = measure(name, case)
        worst = max(worst, *times.values())
        print(f"{name:<22}" + "  ".join(f"{label} {ms:6.1f} ms" for label, ms in times.items()))
    print(f"slowest check: {worst:.0f} ms, limit {LIMIT_MS} ms")
    return int(worst >= LIMIT_MS)


if __name__ == "__main__":
    sys.exit(main())
