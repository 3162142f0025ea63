"""How hard an exercise is: counted from our own solution, not felt.

The *size* of an exercise is the number of steps of its solution (statements that only check
arguments left out) plus the number of objectives that it practices.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Difficulty:
    """One level: its name, its mark, the largest size that belongs to it, minutes to plan."""

    name: str
    mark: str
    largest: int | None
    minutes: int


#: From the easiest on; the last level has no largest size.
LEVELS = (
    Difficulty("easy", "●○○", 7, 15),
    Difficulty("medium", "●●○", 12, 25),
    Difficulty("hard", "●●●", None, 35),
)


def rate(steps: int, objectives: int) -> Difficulty:
    """Return the level of an exercise.

    Parameters
    ----------
    steps : int
        Statements of its solution.
    objectives : int
        Learning objectives that it practices.
    """
    size = steps + objectives
    return next(one for one in LEVELS if one.largest is None or size <= one.largest)


def get_difficulty(name: str) -> Difficulty:
    """Return the level of a name.

    Raises
    ------
    ValueError
        If there is none; the message names those that there are.
    """
    levels = {one.name: one for one in LEVELS}
    if name not in levels:
        raise ValueError(f"difficulty: expected one of {', '.join(levels)}, got {name!r}")
    return levels[name]
