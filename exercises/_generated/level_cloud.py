"""Starter of the exercise level_cloud.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def level_cloud(points):
    """Find the table top in a cloud and turn the cloud so that the table
    is the plane z = 0.

    The table holds more points than any other plane. Its points lie
    within 2 mm of it, all others at least 30 mm away. Fit the plane
    to *all* points of the table by least squares (distances
    perpendicular to the plane): three points alone are not accurate
    enough. RANSAC finds which points those are; start its random
    generator from a fixed seed, so that it answers the same every
    time.

    Parameters
    ----------
    points : ndarray, float64, (N, 3)
        Points in the camera frame, meters; the camera is at the
        origin and above the table.

    The arguments stay as they are.

    Returns
    -------
    plane : ndarray, float, (4,)
        (a, b, c, d) with a unit normal n = (a, b, c) and n . p + d =
        0 on the table. The sign is such that d > 0: the normal points
        to the side of the camera.
    leveled : ndarray, float, (N, 3)
        R p + (0, 0, d) for every point p, in the order of the input.
        R is the smallest rotation that turns n into (0, 0, 1): its
        axis is the cross product of n and (0, 0, 1). So z is the
        height above the table.
    """
    raise NotImplementedError
