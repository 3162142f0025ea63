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
    points : ndarray, int or float, shape (N, 3)
        OpenCV camera frame, meters.
    cam_xpos : ndarray, float, shape (3,)
        ``data.cam_xpos`` of the camera.
    cam_xmat : ndarray, float, shape (9,) or (3, 3)
        ``data.cam_xmat`` of the camera, MuJoCo's axes.

    The arguments stay as they are.

    Returns
    -------
    ndarray, float, shape (N, 3)
        World coordinates in meters.
    """
    raise NotImplementedError
