"""Starter of the exercise which_camera.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def which_camera(points, pixels, fovs, width, height):
    """Tell from known points which camera took a picture.

    Parameters
    ----------
    points : ndarray, float64, (N, 3)
        Points in the camera frame (x right, y down, z forward),
        meters, all in front.
    pixels : ndarray, float64, (N, 2)
        Where the points were found in the picture, (u, v), with a
        little noise.
    fovs : ndarray, float64, (C,)
        Vertical fields of view of the C cameras in question, radians;
        pixels are square and the principal point is the middle of the
        picture.
    width, height : int
        Size of the picture, pixels.

    The arguments stay as they are.

    Returns
    -------
    camera : int
        Number of the camera that explains the pixels best, counted
        from 0.
    error_px : float
        For that camera, the mean distance between projected and found
        pixels.
    """
    raise NotImplementedError
