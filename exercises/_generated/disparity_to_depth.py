"""Starter of the exercise disparity_to_depth.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def disparity_to_depth(disparity, K, baseline):
    """Compute the depth that a disparity stands for: the inverse of
    `depth_to_disparity`.

    Parameters
    ----------
    disparity : ndarray, float32, shape (H, W)
        Pixels, positive where the right camera sees the point farther
        left.
    K : ndarray, float64, shape (3, 3)
        Intrinsic matrix of both cameras.
    baseline : float
        Distance between the cameras in meters, > 0.

    The arguments stay as they are.

    Returns
    -------
    depth : ndarray, float, shape (H, W)
        Meters; infinite where the disparity is 0, NaN where it is NaN
        or negative.
    """
    raise NotImplementedError
