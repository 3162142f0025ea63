"""Starter of the exercise draw_top_view.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def draw_top_view(points_world, colors, low, high, pixels_per_meter):
    """Draw a cloud as a map, seen from straight above.

    The robot looks along x, so x points up in the picture; y points
    to its left, so y points left. A point at (x, y) falls into row
    floor((high_x - x) * pixels_per_meter) and column floor((high_y -
    y) * pixels_per_meter). Of several points in one pixel the highest
    is seen. Points outside the map are left out; where no point is,
    the map is black.

    Parameters
    ----------
    points_world : ndarray, float64, (N, 3)
        Points in the world (x forward, y left, z up), meters.
    colors : ndarray, float64, (N, 3)
        RGB from 0 to 1 per point.
    low, high : ndarray, float64, (2,)
        Limits (x, y) of the map, meters.
    pixels_per_meter : int
        Scale; the map has (high - low) * pixels_per_meter rows and
        columns, rounded.

    The arguments stay as they are.

    Returns
    -------
    ndarray, uint8, (H, W, 3)
        RGB, 255 times the colors; rounding is free.
    """
    raise NotImplementedError
