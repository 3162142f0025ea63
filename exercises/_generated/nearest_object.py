"""Starter of the exercise nearest_object.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def nearest_object(labels, depth_metric, K, T_world_cam, max_width):
    """Choose the nearest object that the hand can take, and say where it
    is.

    Only pixels with a valid depth count (above 0.01 m, below 10 m).
    The points behind the valid pixels of an object give its width
    (largest minus smallest x in the camera frame) and its position
    (median of x, median of y, median of z in the camera frame). The
    nearest object is the one whose position has the smallest distance
    from the camera, among those that are at most `max_width` wide. An
    object without a valid pixel does not fit.

    Parameters
    ----------
    labels : ndarray, int32, (H, W)
        0 for the background, 1, 2, 3 ... for the pixels of an object.
    depth_metric : ndarray, float32, (H, W)
        Meters along the optical axis; the pixels of an object may
        include invalid ones.
    K : ndarray, float64, (3, 3)
        Intrinsic matrix.
    T_world_cam : ndarray, float64, (4, 4)
        Pose of the camera (x right, y down, z forward): it maps
        camera points into the world.
    max_width : float
        How far the hand opens, meters.

    The arguments stay as they are.

    Returns
    -------
    label : int or None
        Which object; None where none fits.
    position_world : ndarray, float, (3,), or None
        Its position, moved into the world frame, meters; None where
        none fits.
    """
    raise NotImplementedError
