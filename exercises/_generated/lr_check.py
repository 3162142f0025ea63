"""Starter of the exercise lr_check.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def lr_check(disparity_left, disparity_right, tolerance=1.0):
    """Keep the matches that the other picture confirms: the left-right
    check.

    A pixel of the left picture with disparity d leads to column ``u -
    d`` of the right picture, rounded to the nearest one. What was
    found there has to lead back: it may differ by the tolerance.

    Parameters
    ----------
    disparity_left : ndarray, float32, shape (H, W)
        Pixels; NaN where there is no match. No column u - d lies
        halfway between two.
    disparity_right : ndarray, float32, shape (H, W)
        The same of the right picture: its column u is found in column
        u + d of the left one.
    tolerance : float
        How far the two may differ, in pixels, > 0.

    The arguments stay as they are.

    Returns
    -------
    ndarray, bool, shape (H, W)
        True where the match is kept: both disparities exist, and
        agree. False where the left one leads out of the picture.
    """
    raise NotImplementedError
