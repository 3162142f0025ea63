"""From pixels to points and back, from the camera into the world and back.

Stands on NumPy alone; clouds are turned by OpenCV where it is installed. Taught in: step 5.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils._constants import FLIP_YZ
from labutils._guards import check_columns, check_intrinsics, check_pose, check_real_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

#: OpenCV counts the numbers of an array in 32 bits; whoever has more points has patience too.
_MOST_POINTS = 2**31 // 3


def pixels_to_points(pixels: ArrayLike, depth: ArrayLike, K: ArrayLike) -> np.ndarray:
    """Back-project single pixels.

    Parameters
    ----------
    pixels : array-like, real, shape (N, 2)
        (u, v): column, row; fractions are allowed.
    depth : array-like, real, shape (N,)
        Meters along the optical axis.
    K : array-like, shape (3, 3)
        Intrinsic matrix.

    Returns
    -------
    ndarray, float64, shape (N, 3)
        Points in the OpenCV camera frame; NaN where the depth is NaN.

    Raises
    ------
    TypeError, ValueError
        If a shape does not fit.
    """
    pixels = check_columns("pixels", pixels, 2).astype(np.float64)
    z = check_real_array("depth", depth).astype(np.float64)
    K = check_intrinsics(K)
    if z.shape != (len(pixels),):
        raise ValueError(
            f"depth: expected one value per pixel ({len(pixels)}), got shape {z.shape}"
        )
    x = (pixels[:, 0] - K[0, 2]) / K[0, 0] * z
    y = (pixels[:, 1] - K[1, 2]) / K[1, 1] * z
    return np.stack([x, y, z], axis=1)


def points_to_pixels(points: ArrayLike, K: ArrayLike) -> np.ndarray:
    """Project points of the camera frame into the picture.

    Parameters
    ----------
    points : array-like, real, shape (N, 3)
        OpenCV camera frame, meters.
    K : array-like, shape (3, 3)
        Intrinsic matrix.

    Returns
    -------
    ndarray, float64, shape (N, 2)
        (u, v), also outside the picture; NaN for points at or behind the camera (z <= 0).

    Raises
    ------
    TypeError, ValueError
        If a shape does not fit.
    """
    points = check_columns("points", points, 3).astype(np.float64)
    K = check_intrinsics(K)
    z = np.where(points[:, 2] > 0, points[:, 2], np.nan)
    u = K[0, 0] * points[:, 0] / z + K[0, 2]
    v = K[1, 1] * points[:, 1] / z + K[1, 2]
    return np.stack([u, v], axis=1)


def camera_to_world(points: ArrayLike, cam_xpos: ArrayLike, cam_xmat: ArrayLike) -> np.ndarray:
    """Move points from the OpenCV camera frame into the world.

    Convention
    ----------
    ``R_world_cv = cam_xmat @ diag(1, -1, -1)``: MuJoCo's camera has y up and looks along -z.

    Parameters
    ----------
    points : array-like, real, shape (N, 3)
        OpenCV camera frame, meters.
    cam_xpos : array-like, 3 numbers
        ``data.cam_xpos`` of the camera.
    cam_xmat : array-like, 9 numbers or shape (3, 3)
        ``data.cam_xmat`` of the camera, MuJoCo's axes.

    Returns
    -------
    ndarray, float32 or float64, shape (N, 3)
        World coordinates in meters; float32 only where float32 points came in.

    Raises
    ------
    TypeError, ValueError
        If a shape does not fit, or `cam_xmat` is no rotation.
    """
    points = _keep_precision(check_columns("points", points, 3))
    position, rotation = check_pose(cam_xpos, cam_xmat)
    return _turn(points, rotation @ FLIP_YZ, position)


def world_to_camera(points: ArrayLike, cam_xpos: ArrayLike, cam_xmat: ArrayLike) -> np.ndarray:
    """Move points from the world into the OpenCV camera frame: undoes `camera_to_world`.

    Parameters
    ----------
    points : array-like, real, shape (N, 3)
        World coordinates in meters.
    cam_xpos, cam_xmat
        As in `camera_to_world`.

    Returns
    -------
    ndarray, float32 or float64, shape (N, 3)
        Camera coordinates in meters; float32 only where float32 points came in.

    Raises
    ------
    TypeError, ValueError
        As in `camera_to_world`.
    """
    points = _keep_precision(check_columns("points", points, 3))
    position, rotation = check_pose(cam_xpos, cam_xmat)
    # In float64 whatever came in: far from the origin float32 would round the turned points like
    # the large numbers they are differences of.
    turn = (rotation @ FLIP_YZ).T
    moved = _turn(points.astype(np.float64, copy=False), turn, -(turn @ position))
    return moved.astype(points.dtype, copy=False)


def _keep_precision(points: np.ndarray) -> np.ndarray:
    """Return points as float32 where they are, as float64 otherwise; contiguous."""
    dtype = np.float32 if points.dtype == np.float32 else np.float64
    return np.ascontiguousarray(points, dtype=dtype)


def _turn(points: np.ndarray, rotation: np.ndarray, offset: np.ndarray) -> np.ndarray:
    """Compute ``rotation @ point + offset`` for every point, in the precision of the points.

    NumPy leaves the product to a library made for large matrices, which wakes all its threads for
    three columns, and adds slowly to rows of three. OpenCV does both in one pass over the memory.
    In float32 either is wrong by a few roundings of the largest coordinate that occurs: by
    thousandths of a millimeter at 10 m, by tenths at 1000 m.
    """
    opencv = _find_opencv() if 0 < len(points) < _MOST_POINTS else None
    if opencv is None:
        return points @ rotation.T.astype(points.dtype) + offset.astype(points.dtype)
    matrix = np.column_stack((rotation, offset))
    moved: np.ndarray = opencv.transform(points.reshape(-1, 1, 3), matrix).reshape(-1, 3)
    return moved


@lru_cache(maxsize=1)
def _find_opencv() -> Any:
    """Return the module, or None where it is not installed."""
    try:
        import cv2  # noqa: PLC0415 - the module runs without it
    except ImportError:
        return None
    return cv2
