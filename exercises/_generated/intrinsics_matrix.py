"""Starter of the exercise intrinsics_matrix.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def intrinsics_matrix(fov_y, width, height):
    """Build the intrinsic matrix of an ideal camera from its vertical
    field of view.

    Convention
    ----------
    Integer (u, v) is a pixel's center, so the middle of W pixels is
    at (W-1)/2. Pixels are square: fx = fy.

    Parameters
    ----------
    fov_y : float
        Vertical field of view in radians, between 0 and pi.
    width, height : int
        Picture size in pixels.

    The arguments stay as they are.

    Returns
    -------
    ndarray, float, shape (3, 3)
        ``[[f, 0, cx], [0, f, cy], [0, 0, 1]]`` in pixels.

    Examples
    --------
    >>> intrinsics_matrix(np.pi / 2, 640, 480)
    array([[240. ,   0. , 319.5],
           [  0. , 240. , 239.5],
           [  0. ,   0. ,   1. ]])

    References
    ----------
    .. [1] Hartley and Zisserman, Multiple View Geometry, section 6.1.
    """
    raise NotImplementedError
