"""Starter of the exercise find_object_centroid.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import cv2
import numpy as np


def find_object_centroid(mask):
    """Find the center of the largest object in a mask.

    Convention
    ----------
    The answer is (x, y): column first, as OpenCV draws. Index an
    array with ``[y, x]``.

    Parameters
    ----------
    mask : ndarray, uint8, shape (H, W)
        Anything not zero is inside.

    The arguments stay as they are.

    Returns
    -------
    tuple of int, or None
        Center of mass of the external contour with the largest area,
        in whole pixels; one pixel off is right, so rounding is free.
        None where there is no contour, or the largest has no area (a
        line, a dot).
    """
    raise NotImplementedError
