"""Starter of the exercise fill_invalid_depth.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import cv2
import numpy as np


def fill_invalid_depth(depth_metric):
    """Fill the invalid pixels of a depth image and keep its edges sharp.

    Valid is a depth above 0.01 m and below 10 m. Fill in rounds: in
    each round, every invalid pixel that has valid pixels among its
    eight neighbors takes the *farthest* of them; the filled pixels
    are valid from the next round on. Repeat until no invalid pixel is
    left. A hole beside an object is mostly background that the object
    hides, hence the farthest.

    Parameters
    ----------
    depth_metric : ndarray, float32, (H, W)
        Meters. At least one pixel is valid.

    The arguments stay as they are.

    Returns
    -------
    ndarray, float, (H, W)
        Meters; valid pixels keep their depth.
    """
    raise NotImplementedError
