"""Starter of the exercise measure_object_size.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def measure_object_size(mask, depth_metric, K):
    """Measure the width and height of the side of an object that faces
    the camera.

    At the border of a mask some pixels see the background. Take the
    median depth of the valid pixels in the mask (above 0.01 m, below
    10 m), and keep the valid pixels in the mask whose depth differs
    from it by at most 0.05 m. Of the points behind these pixels,
    width is the largest minus the smallest x, height the largest
    minus the smallest y, in the camera frame.

    Parameters
    ----------
    mask : ndarray, uint8, (H, W)
        255 on the object, 0 elsewhere.
    depth_metric : ndarray, float32, (H, W)
        Meters along the optical axis.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix.

    The arguments stay as they are.

    Returns
    -------
    width, height : float
        Meters.
    """
    raise NotImplementedError
