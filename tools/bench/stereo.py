"""Compare matching by hand with OpenCV's: one recorded pair of 640x480, 96 disparities.

All routes take turns in one process, so that whatever else the machine does falls on all alike. The
first is what the others are compared with; milliseconds are those of this machine.

Usage: ``python -m tools.bench.stereo [--rounds 15]``.
"""

import argparse
import statistics
import sys
import time
from collections.abc import Callable, Sequence

import numpy as np

from labutils.recordings import load_recording
from tools.measure.stereo import DISPARITIES, match_bm, match_refined, match_sgbm, match_ssd

Route = Callable[[np.ndarray, np.ndarray, int], np.ndarray]
ROUTES: dict[str, Route] = {
    "cv2.StereoBM, 15x15": match_bm,
    "cv2.StereoSGBM, 5x5": match_sgbm,
    "ssd_disparity, 9x9": match_ssd,
    "the same, parabola and left-right check": match_refined,
}
#: What SSD by hand may take at most, in times of `cv2.StereoBM`.
GOAL = 15


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a table; return a shell's exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=15, help="turns per route")
    options = parser.parse_args(arguments)
    pair = load_recording("room").pairs[0]
    times = measure(pair.left, pair.right, options.rounds)
    first = statistics.median(times[next(iter(ROUTES))])
    print(f"one pair of 640x480, {DISPARITIES} disparities, times cv2.StereoBM (goal: {GOAL})")
    for name, found in times.items():
        median = statistics.median(found)
        print(f"{name:<42}{median / first:>6.1f}{1000 * median:>9.1f} ms")
    return 0


def measure(left: np.ndarray, right: np.ndarray, rounds: int) -> dict[str, list[float]]:
    """Return the seconds of every turn of every route; the first turn only wakes the caches."""
    times: dict[str, list[float]] = {name: [] for name in ROUTES}
    for turn in range(rounds + 1):
        for name, match in ROUTES.items():
            start = time.perf_counter()
            match(left, right, DISPARITIES)
            if turn:
                times[name].append(time.perf_counter() - start)
    return times


if __name__ == "__main__":
    sys.exit(main())
