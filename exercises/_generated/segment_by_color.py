"""Starter of the exercise segment_by_color.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import cv2
import numpy as np


def segment_by_color(rgb_image, target_hsv_range):
    """Mark the pixels whose color lies in an HSV range, cleaned of
    specks and holes.

    Convention
    ----------
    OpenCV's 8-bit HSV: hue 0-179 (degrees halved), saturation and
    value 0-255. Limits are inclusive. A range whose low hue is larger
    than its high hue wraps through red: it means ``hue >= low or hue
    <= high``.

    Parameters
    ----------
    rgb_image : ndarray, uint8, shape (H, W, 3)
        The picture, RGB (not BGR).
    target_hsv_range : ((h, s, v), (h, s, v))
        Low and high limits.

    The arguments stay as they are.

    Returns
    -------
    ndarray, uint8, shape (H, W)
        255 inside, 0 outside, after opening and then closing with 5x5
        ones, at the border as ``cv2.morphologyEx`` does it.

    References
    ----------
    .. [1] OpenCV documentation, color conversions, RGB to HSV.
    """
    raise NotImplementedError
