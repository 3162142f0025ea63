"""What is written down while a controller acts, and the properties read from it. NumPy alone.

A trace is an array with a row per call, so that it travels like any other answer. Errors are in
pixels of a picture 640 wide, whatever size was drawn.
"""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

import numpy as np

from labutils._constants import NEAR_PX
from labutils.checks.loops.scenario import FOLLOWS, RECOVERS, SETTLES

#: The bound of the book, in pixels of a picture 640 wide.
BOUND_PX = NEAR_PX

#: A command may miss its limit by a rounding error.
SLACK_RAD = 1e-6

LIMITS = "limits"

#: In the order in which they are asked for.
PROPERTIES = (LIMITS, SETTLES, FOLLOWS, RECOVERS)


class Column(IntEnum):
    """What the columns of a trace hold; behind them follow those of `Looks`."""

    TIME = 0
    ERROR_PX = 1
    PAN = 2
    TILT = 3
    #: How far the command lies beyond a limit, in radians; 0 within.
    BEYOND = 4
    IS_HIDDEN = 5
    #: The number of the property that is measured at this time, in `PROPERTIES`; 0 for none.
    MEASURED = 6


class Looks(NamedTuple):
    """What single pictures show of a controller, each in a few classes.

    Classes are as wide as gains, filters and predictions go: right controllers of all styles are in
    the same, and a mistake is in another.

    Parameters
    ----------
    pan, tilt : int
        1 turns toward the ball, -1 turns away, 0 does not turn.
    size : int
        0 for turns of less than a twentieth of the angle, 2 for more than four times it, 1 else.
    stale : int
        1 where an angle of the picture is added to the pose of now.
    beyond : int
        1 where a command lies beyond its limit.
    blind : int
        1 where it turns otherwise as soon as the depth of the ball is lost.
    winds : int
        1 where it stays at its limit for long after the ball has come back.
    """

    pan: int
    tilt: int
    size: int
    stale: int
    beyond: int
    blind: int
    winds: int


COLUMNS = len(Column) + len(Looks._fields)


def read_properties(trace: np.ndarray) -> dict[str, float]:
    """Return what decides each property that a trace was measured for.

    Radians beyond a limit for the limits; for the others pixels: the worst where the ball rests,
    else the mean.
    """
    found = {LIMITS: float(trace[:, Column.BEYOND].max())}
    for number, name in enumerate(PROPERTIES[1:], 1):
        errors = trace[trace[:, Column.MEASURED] == number, Column.ERROR_PX]
        if errors.size:
            found[name] = float(errors.max() if name == SETTLES else errors.mean())
    return found


def holds(name: str, value: float) -> bool:
    """Tell whether a property holds."""
    return value <= (SLACK_RAD if name == LIMITS else BOUND_PX)


def find_failing(trace: np.ndarray) -> str:
    """Name the first property that does not hold; empty where all do."""
    found = read_properties(trace)
    return next((name for name in PROPERTIES if name in found and not holds(name, found[name])), "")


def classify(trace: np.ndarray) -> np.ndarray:
    """Return per property whether it holds, then the classes of the looks; NaN: not asked."""
    found = read_properties(trace)
    kept = [float(holds(name, found[name])) if name in found else np.nan for name in PROPERTIES]
    return np.concatenate([kept, trace[0, len(Column) :]])
