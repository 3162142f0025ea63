"""From a depth image to points in space.

Single pixels and frames are in `labutils.projection`; its functions can be imported from here too.
Taught in: step 5 (back-projection, frames) and step 6 (viewing).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._back_projection import back_project
from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils._guards import (
    check_colors,
    check_columns,
    check_depth_image,
    check_depth_limits,
    check_intrinsics,
    check_rgb_image,
)
from labutils.projection import (
    camera_to_world,
    pixels_to_points,
    points_to_pixels,
    world_to_camera,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "camera_to_world",
    "depth_to_pointcloud",
    "pixels_to_points",
    "points_to_pixels",
    "visualize_pointcloud",
    "world_to_camera",
]


def depth_to_pointcloud(
    depth_metric: ArrayLike,
    K: ArrayLike,
    rgb_image: ArrayLike | None = None,
    *,
    min_depth: float = MIN_DEPTH,
    max_depth: float = MAX_DEPTH,
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
    min_depth, max_depth : float
        Other limits, in meters, than the two named below, for a scene of another size: see
        `get_depth_limits`. A ValueError unless 0 < min_depth < max_depth.

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
    limits = check_depth_limits("min_depth", min_depth, "max_depth", max_depth)
    dtype = np.float64 if depth.dtype == np.float64 else np.float32
    depth = np.ascontiguousarray(depth, dtype=dtype)
    rgb = None
    if rgb_image is not None:
        rgb = np.ascontiguousarray(check_rgb_image("rgb_image", rgb_image))
        if rgb.shape[:2] != depth.shape:
            raise ValueError(
                f"rgb_image: expected the depth image's size {depth.shape}, got {rgb.shape[:2]}"
            )
    return back_project(depth, K, rgb, limits)


def visualize_pointcloud(points: ArrayLike, colors: ArrayLike | None = None) -> object | None:
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
