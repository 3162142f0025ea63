"""Where a ball is that stands at an angle before the eye."""

from __future__ import annotations

import numpy as np

#: Where the eye is when the head looks straight ahead. It moves by some centimeters with the head.
EYE = np.array([0.1, 0.0, 1.46])


def get_place(eye: np.ndarray, pan: float, tilt: float, meters: float) -> np.ndarray:
    """Return the point at these angles, seen from the eye: world coordinates, float64 (3,)."""
    ahead = np.array([np.cos(tilt) * np.cos(pan), np.cos(tilt) * np.sin(pan), -np.sin(tilt)])
    return eye + meters * ahead


class AnglePath:
    """A path given by angles at times; the loop has to move along it by one unit a second.

    Parameters
    ----------
    places : array-like, shape (N, 4)
        Seconds, pan, tilt and meters from the eye.
    """

    def __init__(self, places: tuple[tuple[float, ...], ...]) -> None:
        self._places = np.array(places, dtype=np.float64)

    def get_position(self, meters: float) -> np.ndarray:
        """Return the ball's center in the world after so many seconds, which the loop calls so."""
        times = self._places[:, 0]
        pan, tilt, away = (np.interp(meters, times, column) for column in self._places[:, 1:].T)
        return get_place(EYE, float(pan), float(tilt), float(away))


def make_path(places: tuple[tuple[float, ...], ...]) -> AnglePath:
    """Return the path through these places."""
    return AnglePath(places)
