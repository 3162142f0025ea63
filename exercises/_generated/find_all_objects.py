"""Starter of the exercise find_all_objects.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import cv2
import numpy as np


def find_all_objects(rgb_image, color_ranges, min_area):
    """Find all objects of several colors.

    An object is a connected region (eight neighbors) of pixels whose
    HSV values lie in a range, limits included. No object has holes.

    Parameters
    ----------
    rgb_image : ndarray, uint8, (H, W, 3)
        The picture.
    color_ranges : tuple of (name, low, high)
        Name of a color, and its limits (h, s, v) in OpenCV's units. A
        hue range whose low limit is above the high one wraps through
        red.
    min_area : int
        Regions with fewer pixels are no objects.

    The arguments stay as they are.

    Returns
    -------
    names : list of str, N
        Color name per object, largest object first.
    areas : list of int, N
        Number of pixels, in the same order.
    boxes : list of (left, top, width, height), N
        Smallest upright box around all pixels of the object: its
        first column and row, and how many columns and rows it has.
    """
    raise NotImplementedError
