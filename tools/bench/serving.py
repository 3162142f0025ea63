"""The process that runs one route when it is its turn; stands on NumPy alone.

Every route starts from the NumPy arrays of a frame and ends with NumPy arrays: points and colors.
A module of routes ends with `serve`. Started as a script with the name of a route and a frame, it
answers each line "run N" on its standard input with the seconds of N runs.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

#: The arrays of a frame by name: rgb, depth, K, xpos, xmat, points.
Frame = dict[str, np.ndarray]

Route = Callable[[], tuple[Any, Any]]

MIN_DEPTH, MAX_DEPTH = 0.01, 10.0


def make_pose(frame: Frame) -> np.ndarray:
    """Build the 3x4 matrix that takes the points of OpenCV's camera frame into the world."""
    return np.column_stack((frame["xmat"].reshape(3, 3) * [1, -1, -1], frame["xpos"]))


def serve(make_route: Callable[[str, Frame], Route]) -> int:
    """Serve the route that the command line names until the input ends."""
    name, path = sys.argv[1:]
    with np.load(path) as file:
        frame = {key: file[key] for key in file.files}
    route = make_route(name, frame)
    # The answers get the real output; whatever a library prints goes to the error output.
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    for line in sys.stdin:
        command, _, argument = line.strip().partition(" ")
        if command == "save":
            np.savez(argument, *(part for part in route() if part is not None))
            answers.write("saved\n")
            continue
        answers.write(" ".join(str(measure(route)) for _ in range(int(argument))) + "\n")
    return 0


def measure(route: Route) -> float:
    """Run once; return seconds."""
    started = time.perf_counter()
    route()  # the result is dropped at once: handing memory back is part of the price
    return time.perf_counter() - started
