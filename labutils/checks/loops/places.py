"""Where a ball is that the head would look at with some pan and tilt."""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from labutils.cameras import get_camera_pose
from labutils.following.scene import CAMERA

if TYPE_CHECKING:
    from collections.abc import Iterable


def get_place(
    model: mujoco.MjModel, data: mujoco.MjData, pan: float, tilt: float, meters: float
) -> np.ndarray:
    """Return the point straight ahead of the eye when the neck has these angles, float64 (3,).

    Angles may lie beyond the limits of the neck. It is left with them, forwarded.
    """
    data.qpos[:2] = pan, tilt
    mujoco.mj_forward(model, data)
    T_world_cam = get_camera_pose(model, data, CAMERA)
    return np.asarray((T_world_cam @ [0.0, 0.0, meters, 1.0])[:3])


class PointPath:
    """A path through points at given seconds; the loop has to move along it by one unit a second.

    Parameters
    ----------
    times : iterable of float
        Seconds, growing.
    points : iterable of ndarray
        World coordinates.
    """

    def __init__(self, times: Iterable[float], points: Iterable[np.ndarray]) -> None:
        self._times, self._points = np.array(list(times)), np.array(list(points))

    def get_position(self, meters: float) -> np.ndarray:
        """Return the ball's center in the world after so many seconds, which the loop calls so."""
        return np.array([np.interp(meters, self._times, axis) for axis in self._points.T])
