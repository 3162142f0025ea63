"""Starter of the exercise visualize_depth.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import cv2
import numpy as np


def visualize_depth(depth_metric, max_depth=5.0):
    """Color a depth image: blue close, red far.

    Parameters
    ----------
    depth_metric : ndarray, float32, shape (H, W)
        Meters.
    max_depth : float
        Everything at or beyond this is the reddest red.

    The arguments stay as they are.

    Returns
    -------
    ndarray, uint8, shape (H, W, 3)
        **BGR**, ready for ``cv2.imwrite``. Black where the depth is
        NaN, infinite or <= 0: black is in no color map, so it cannot
        be taken for a distance.
    """
    raise NotImplementedError
