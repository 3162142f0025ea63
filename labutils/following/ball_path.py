"""Where the ball is: a smooth path above the table, another one for every seed."""

from __future__ import annotations

from typing import Protocol

import numpy as np

#: The middle of the path and how far it reaches to each side, in meters of the world. Above the
#: objects on the table, and in view when the head looks at its middle.
_MIDDLE = np.array([1.0, 0.0, 1.17])
_REACH = np.array([0.14, 0.38, 0.13])
#: Two waves per axis: how many go round in one unit of the path, and their share of the reach.
_WAVES = np.array([1.0, 2.0])
_SHARES = np.array([0.7, 0.3])
#: Axes differ in their waves, or the ball would run up and down one line.
_AXIS_WAVES = np.array([2.0, 1.0, 3.0])
_SAMPLES = 2000


class Path(Protocol):
    """What the loop asks of a path."""

    def get_position(self, meters: float) -> np.ndarray:
        """Return the ball's center in the world, float64 (3,), so many meters along the path."""
        ...


class BallPath:
    """A closed smooth path through the air above the table.

    Convention
    ----------
    Each axis is a sum of two sines with phases that depend on the seed. The path is traversed by
    its length: `get_position` takes meters, so that a speed in m/s is a true speed.

    Parameters
    ----------
    seed : int
        Another seed is another path.

    Examples
    --------
    >>> path = BallPath(0)
    >>> np.round(path.get_position(0.0), 2).shape
    (3,)
    """

    def __init__(self, seed: int) -> None:
        phases = np.random.default_rng(seed).uniform(0, 2 * np.pi, (3, 2))
        turns = np.linspace(0, 1, _SAMPLES + 1)
        angles = 2 * np.pi * turns[:, None, None] * (_AXIS_WAVES[:, None] * _WAVES) + phases
        self._points = _MIDDLE + _REACH * (np.sin(angles) * _SHARES).sum(axis=2)
        steps = np.linalg.norm(np.diff(self._points, axis=0), axis=1)
        self._lengths = np.concatenate([[0.0], np.cumsum(steps)])

    @property
    def length(self) -> float:
        """Meters of one round."""
        return float(self._lengths[-1])

    def get_position(self, meters: float) -> np.ndarray:
        """Return the ball's center in the world, float64 (3,), so many meters along the path."""
        place = meters % self.length
        axes = (np.interp(place, self._lengths, self._points[:, axis]) for axis in range(3))
        return np.array(list(axes))
