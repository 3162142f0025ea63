"""Starter of the exercise crop_region.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def crop_region(points_world, T_world_robot, low, high):
    """Move a cloud into the frame of the robot and keep what lies in a
    box.

    Parameters
    ----------
    points_world : ndarray, float64, (N, 3)
        Points in the world, meters.
    T_world_robot : ndarray, float64, (4, 4)
        Pose of the robot: it maps points of the robot's frame into
        the world.
    low, high : ndarray, float64, (3,)
        Limits of the box in the robot's frame, (x, y, z), meters,
        limits included.

    The arguments stay as they are.

    Returns
    -------
    ndarray, float, (M, 3)
        The points in the box, in the robot's frame, in any order; M
        may be 0.
    """
    raise NotImplementedError
