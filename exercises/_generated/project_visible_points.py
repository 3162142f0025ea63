"""Starter of the exercise project_visible_points.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def project_visible_points(
    points_world, T_world_cam, K, depth_metric,
):
    """Project points of the world into a picture and tell which of them
    the camera sees.

    A point is visible if its depth is above 0.01 m, if its pixel
    (rounded to the nearest whole numbers) lies in the picture, and if
    the depth image shows nothing in front of it there: its own depth
    is at most 0.02 m larger than the depth of that pixel. A pixel
    without a valid depth (above 0.01 m, below 10 m) hides nothing.

    Parameters
    ----------
    points_world : ndarray, float64, (N, 3)
        Points in the world, meters.
    T_world_cam : ndarray, float64, (4, 4)
        Pose of the camera (x right, y down, z forward): it maps
        camera points into the world.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix.
    depth_metric : ndarray, float32, (H, W)
        What the camera measured, meters along the optical axis.

    The arguments stay as they are.

    Returns
    -------
    pixels : ndarray, float, (N, 2)
        (u, v) of each point, not rounded, also outside the picture;
        NaN where its depth is 0.01 m or less.
    visible : ndarray, bool, (N,)
        Whether the camera sees the point.
    """
    raise NotImplementedError
