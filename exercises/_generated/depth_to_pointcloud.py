"""Starter of the exercise depth_to_pointcloud.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def depth_to_pointcloud(depth_metric, K, rgb_image=None):
    """Back-project a depth image into colored points.

    Convention
    ----------
    Points are in the OpenCV camera frame: x right, y down, z forward.
    Integer (u, v) is a pixel's center. Points may come in any order,
    with their colors in the same.

    Parameters
    ----------
    depth_metric : ndarray, float, shape (H, W)
        Meters along the optical axis.
    K : ndarray, float, shape (3, 3)
        Intrinsic matrix of the picture, in pixels.
    rgb_image : ndarray, uint8, shape (H, W, 3), optional
        Colors of the same pixels.

    The arguments stay as they are.

    Returns
    -------
    points : ndarray, float, shape (N, 3)
        Meters. Pixels whose depth is NaN, infinite, <= 0.01 m or >=
        10 m are left out; where no pixel is left, N is 0.
    colors : ndarray, float, shape (N, 3), or None
        RGB in [0, 1] of the same pixels; None without `rgb_image`.

    Examples
    --------
    >>> K = np.array([[100.0, 0, 0.5], [0, 100.0, 0], [0, 0, 1]])
    >>> points, _ = depth_to_pointcloud(np.array([[2.0, np.nan]]), K)
    >>> points
    array([[-0.01,  0.  ,  2.  ]])

    References
    ----------
    .. [1] Hartley and Zisserman, Multiple View Geometry, section 6.1.
    """
    raise NotImplementedError
