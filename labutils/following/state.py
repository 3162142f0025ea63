"""What a controller is told beside the picture."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np


@dataclass(frozen=True)
class FollowingState:
    """What a controller knows beside its picture.

    A picture takes time to arrive. So there are two poses of the neck: that of now, and that in
    which the picture was taken.

    Parameters
    ----------
    time, dt : float
        Seconds since the start, and from one command to the next.
    pan, tilt : float
        Angles of the neck now, in radians: pan to the left, tilt downward is positive.
    seen_time : float
        When the picture was taken.
    seen_pan, seen_tilt : float
        Angles of the neck in that moment.
    T_world_cam : ndarray, float64, shape (4, 4)
        Pose of the camera in that moment: maps camera points (OpenCV) into the world.
    limits : tuple of tuple of float
        Low and high of pan, low and high of tilt, in radians.
    gain : float
        What the slider says; a controller may use it.
    memory : dict
        The controller's own: empty at the start, kept from call to call. Where it writes
        ``memory["center"]``, the world coordinates of the ball's center in meters when the picture
        was taken (or None), the record compares them with the truth.
    """

    time: float
    dt: float
    pan: float
    tilt: float
    seen_time: float
    seen_pan: float
    seen_tilt: float
    T_world_cam: np.ndarray
    limits: tuple[tuple[float, float], tuple[float, float]]
    gain: float = 1.0
    memory: dict[str, Any] = field(default_factory=dict)
