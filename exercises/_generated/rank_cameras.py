"""Starter of the exercise rank_cameras.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import mujoco
import numpy as np


def rank_cameras(model, data, point_world):
    """Sort the cameras of a model by their distance from a point,
    nearest first.

    The joints may have moved since positions were last computed.

    Parameters
    ----------
    model : mujoco.MjModel
        A model with C cameras.
    data : mujoco.MjData
        Its state.
    point_world : ndarray, float64, (3,)
        A point in the world, meters.

    The arguments stay as they are. What follows from the state in
    `data` may be brought up to date.

    Returns
    -------
    ids : ndarray, int, (C,)
        Numbers of the cameras, nearest first.
    distances : ndarray, float, (C,)
        Their distances from the point, meters, in the same order.
    """
    raise NotImplementedError
