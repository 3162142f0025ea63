"""Measure how long one check takes when its pictures have the size of the lab, 640x480.

The visible cases of the exercises are small. Here each exercise whose arguments are pictures gets
one large case, and a right and a wrong answer are judged: message, recognition and picture.

The times are told as ratios, which a busy or slow machine leaves as they are: to the time in which
the right answer itself is computed, and to the least that any check has to do, one comparison of
the same arrays by ``numpy.allclose``. Both take turns with the checks.

An answer that is wrong in no known way, the right one with noise, has everything tried on it. How
much longer it takes for that, once more as a ratio, is the price of an explanation.

Usage: ``python -m tools.bench.checks [--rounds 5]``.
"""

from __future__ import annotations

import argparse
import sys
import time
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks import judge_answers
from labutils.checks.calls import collect_answers
from labutils.checks.explain import Differences
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
    from collections.abc import Callable, Sequence

    from labutils.checks.table import CheckTable, Outcome

REFERENCE, PEER = "the right answer", "numpy.allclose"
UNKNOWN, EXPLAINING = "unknown mistake", "explaining it"
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


def measure(name: str, case: Case, rounds: int) -> dict[str, float]:
    """Return the best times in milliseconds: of both peers, of right and of wrong answers."""
    exercise = load_exercises()[name]
    table = exercise.freeze((case,))
    made = exercise.get_combinations()
    right = exercise.make_wrong(())
    functions = {
        "right": right,
        "first mistake": exercise.make_wrong(made[0]),
        "last pair": exercise.make_wrong(made[-1]),
    }
    runs: dict[str, Callable[[], object]] = {
        REFERENCE: lambda: collect_answers(table, right),
        PEER: lambda: compare_with_numpy(table.expected),
    }
    for label, function in functions.items():
        # What the learner's own function takes is not the checker's time.
        runs[label] = _judge(table, collect_answers(table, function))
    unknown = tuple(map(add_noise, table.expected))
    runs[UNKNOWN] = _judge(table, unknown)
    runs[EXPLAINING] = lambda: explain_difference(table, unknown)
    times = {label: [_time(run) for _ in range(rounds)] for label, run in runs.items()}
    return {label: min(found) for label, found in times.items()}


def compare_with_numpy(outcomes: tuple[Outcome, ...]) -> bool:
    """Compare every array of some outcomes once, with itself."""
    parts = [part for outcome in outcomes if isinstance(outcome, tuple) for part in outcome]
    return all(np.allclose(part, part, equal_nan=True) for part in parts if part is not None)


def add_noise(outcome: Outcome) -> Outcome:
    """Spoil every array of an answer, the same way every time."""
    rng = np.random.default_rng(0)

    def spoil(part: np.ndarray | None) -> np.ndarray | None:
        if part is None or part.dtype == bool:
            return part
        if part.dtype == np.uint8:
            return np.where(rng.random(part.shape) < 0.2, 255 - part, part).astype(np.uint8)
        noise = rng.normal(size=part.shape) if part.dtype.kind == "f" else 7
        return np.asarray((part + noise).astype(part.dtype))

    return tuple(map(spoil, outcome)) if isinstance(outcome, tuple) else outcome


def explain_difference(table: CheckTable, answers: tuple[Outcome, ...]) -> None:
    """Try all that is tried on answers of which nothing is known, but for calling again."""
    differences = Differences(table, answers)
    differences.find_relation()
    differences.find_partial()
    differences.find_odd_case()


def _judge(table: CheckTable, answers: tuple[Outcome, ...]) -> Callable[[], object]:
    return lambda: judge_answers(table, answers)


def _time(run: Callable[[], object]) -> float:
    start = time.perf_counter()
    run()
    return 1000 * (time.perf_counter() - start)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a table; return a shell's exit code."""
    parser = argparse.ArgumentParser(description="Measure checks of pictures of 640x480.")
    parser.add_argument("--rounds", type=int, default=5, help="turns per check")
    options = parser.parse_args(arguments)
    print(f"a check, times {REFERENCE} / times {PEER} (milliseconds on this machine)")
    for name, case in make_large_cases().items():
        times = measure(name, case, options.rounds)
        reference, peer = times.pop(REFERENCE), times.pop(PEER)
        explaining = times.pop(EXPLAINING)
        price = times[UNKNOWN] / max(times[UNKNOWN] - explaining, 1e-3)
        cells = [
            f"{label} {ms / reference:.1f} / {ms / peer:.1f} ({ms:.0f} ms)"
            for label, ms in times.items()
        ]
        print(f"{name:<22}{', '.join(cells)}, explained {price:.1f} x unexplained")
    return 0


if __name__ == "__main__":
    sys.exit(main())
