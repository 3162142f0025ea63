"""From a depth image to points in space.

Taught in: step 5 (back-projection, frames) and step 6 (viewing).
"""

from __future__ import annotations

import numpy as np

from labutils._back_projection import back_project
from labutils._constants import FLIP_YZ
from labutils._guards import (
    check_colors,
    check_columns,
    check_depth_image,
    check_intrinsics,
    check_pose,
    check_real_array,
    check_rgb_image,
)


def depth_to_pointcloud(
    depth_metric: np.ndarray, K: np.ndarray, rgb_image: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray | None]:
    """Back-project a depth image into colored points.

    Convention
    ----------
    Points are in the OpenCV camera frame: x right, y down, z forward. Integer (u, v) is a pixel's
    center. Points keep the order of the pixels, row by row.

    Parameters
    ----------
    depth_metric : array-like, real, shape (H, W)
        Meters along the optical axis.
    K : array-like, shape (3, 3)
        Intrinsic matrix of the picture, in pixels.
    rgb_image : array-like, uint8, shape (H, W, 3), optional
        Colors of the same pixels.

    Returns
    -------
    points : ndarray, float32 or float64, shape (N, 3)
        Meters; float64 only where float64 depth came in. Pixels whose depth is NaN, infinite,
        <= 0.01 m or >= 10 m are left out.
    colors : ndarray, float32, shape (N, 3), or None
        RGB in [0, 1] of the same pixels; None without `rgb_image`.

    Raises
    ------
    TypeError, ValueError
        If the depth is no image of real numbers, K is no intrinsic matrix, or the pictures differ
        in size.

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
    depth = check_depth_image("depth_metric", depth_metric)
    K = check_intrinsics(K)
    dtype = np.float64 if depth.dtype == np.float64 else np.float32
    depth = np.ascontiguousarray(depth, dtype=dtype)
    rgb = None
    if rgb_image is not None:
        rgb = np.ascontiguousarray(check_rgb_image("rgb_image", rgb_image))
        if rgb.shape[:2] != depth.shape:
            raise ValueError(
                f"rgb_image: expected the depth image's size {depth.shape}, got {rgb.shape[:2]}"
            )
    return back_project(depth, K, rgb)


def pixels_to_points(pixels: np.ndarray, depth: np.ndarray, K: np.ndarray) -> np.ndarray:
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


def points_to_pixels(points: np.ndarray, K: np.ndarray) -> np.ndarray:
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


def camera_to_world(points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray) -> np.ndarray:
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
    ndarray, float64, shape (N, 3)
        World coordinates in meters.

    Raises
    ------
    TypeError, ValueError
        If a shape does not fit, or `cam_xmat` is no rotation.
    """
    points = check_columns("points", points, 3)
    position, rotation = check_pose(cam_xpos, cam_xmat)
    return points @ (rotation @ FLIP_YZ).T + position


def world_to_camera(points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray) -> np.ndarray:
    """Move points from the world into the OpenCV camera frame: undoes `camera_to_world`.

    Parameters
    ----------
    points : array-like, real, shape (N, 3)
        World coordinates in meters.
    cam_xpos, cam_xmat
        As in `camera_to_world`.

    Returns
    -------
    ndarray, float64, shape (N, 3)
        Camera coordinates in meters.

    Raises
    ------
    TypeError, ValueError
        As in `camera_to_world`.
    """
    points = check_columns("points", points, 3)
    position, rotation = check_pose(cam_xpos, cam_xmat)
    return (points - position) @ (rotation @ FLIP_YZ)


def visualize_pointcloud(points: np.ndarray, colors: np.ndarray | None = None) -> object | None:
    """Show a point cloud: in an Open3D window, or as a picture where there is no screen.

    Parameters
    ----------
    points : array-like, real, shape (N, 3)
        OpenCV camera frame (x right, y down, z forward), meters.
    colors : array-like, real in [0, 1], shape (N, 3), optional
        RGB; without it, points are colored by depth.

    Returns
    -------
    Picture or None
        None after an Open3D window was shown and closed. Without a screen, a picture that shows
        itself as the last line of a cell: drawn by Open3D off screen where its Vulkan driver is
        found, by the book's own point renderer elsewhere.

    Raises
    ------
    TypeError, ValueError
        If a shape does not fit, or there is no point to show.
    """
    from labutils.cloud_view import show_cloud  # noqa: PLC0415 - Open3D and Matplotlib are heavy

    points = check_columns("points", points, 3)
    if len(points) == 0:
        raise ValueError("points: expected at least one point, got none")
    if colors is not None:
        colors = check_colors(colors, len(points))
    return show_cloud(points, colors)
