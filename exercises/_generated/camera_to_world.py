"""Starter of the exercise camera_to_world.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def camera_to_world(points, cam_xpos, cam_xmat):
    """Move points from the OpenCV camera frame into the world.

    Convention
    ----------
    ``R_world_cv = cam_xmat @ diag(1, -1, -1)``: MuJoCo's camera has y
    up and looks along -z.

    Parameters
    ----------
    points : array-like, real, shape (N, 3)
        OpenCV camera frame, meters.
    cam_xpos : array-like, 3 numbers
        ``data.cam_xpos`` of the camera.
    cam_xmat : array-like, 9 numbers or shape (3, 3)
        ``data.cam_xmat`` of the camera, MuJoCo's axes.

    Returns
    -------
    ndarray, float32 or float64, shape (N, 3)
        World coordinates in meters; float32 only where float32 points
        came in.

    Raises
    ------
    TypeError, ValueError
        If a shape does not fit, or `cam_xmat` is no rotation.
    """
    raise NotImplementedError
