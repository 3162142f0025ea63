"""A point renderer in NumPy: a pinhole camera, a depth test, square points.

It draws what an OpenGL viewer would, on a machine that has none, and the same picture everywhere.
"""

from __future__ import annotations

from functools import reduce

import numpy as np

from labutils._drawing.color_maps import find_steps, get_table


def make_look_at(eye: np.ndarray, target: np.ndarray, up: np.ndarray) -> np.ndarray:
    """Build T_cam_world (4x4) of an OpenCV camera at `eye` that looks at `target`.

    Raises
    ------
    ValueError
        If the eye is at the target, or looks along `up`.
    """
    forward = np.asarray(target, float) - eye
    right = np.cross(forward, up)
    if np.linalg.norm(forward) == 0 or np.linalg.norm(right) == 0:
        raise ValueError("eye: expected a view that is not along `up`, and away from the target")
    forward /= np.linalg.norm(forward)
    right /= np.linalg.norm(right)
    rotation = np.stack([right, np.cross(forward, right), forward])
    T_cam_world = np.eye(4)
    T_cam_world[:3, :3] = rotation
    T_cam_world[:3, 3] = -rotation @ eye
    return T_cam_world


def render_points(
    points: np.ndarray,
    colors: np.ndarray,
    T_cam_world: np.ndarray,
    K: np.ndarray,
    size: tuple[int, int],
    *,
    point_size: int = 2,
) -> np.ndarray:
    """Draw points as squares, the nearest on top.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        World coordinates.
    colors : ndarray, shape (N, 3)
        RGB in [0, 1].
    T_cam_world : ndarray, shape (4, 4)
        From `make_look_at`.
    K : ndarray, shape (3, 3)
        Intrinsics of the drawn picture.
    size : (width, height)
        Pixels.
    point_size : int
        Side of a square in pixels.

    Returns
    -------
    ndarray, uint8, shape (H, W, 4)
        RGBA, transparent where no point is.
    """
    in_cam = points @ T_cam_world[:3, :3].T + T_cam_world[:3, 3]
    in_front = in_cam[:, 2] > 1e-6
    in_cam, colors = in_cam[in_front], colors[in_front]
    # Of each square the first column and row, so that its middle lies next to the point: a square
    # of even size has its middle between two pixels.
    half = (point_size - 1) / 2
    u = np.round(K[0, 0] * in_cam[:, 0] / in_cam[:, 2] + K[0, 2] - half).astype(np.int64)
    v = np.round(K[1, 1] * in_cam[:, 1] / in_cam[:, 2] + K[1, 2] - half).astype(np.int64)
    order = np.argsort(-in_cam[:, 2], kind="stable")  # far first: near ones overwrite them
    u, v, colors = u[order], v[order], colors[order]
    pixels = np.zeros((len(u) + 1, 4), np.uint8)  # the first is empty
    pixels[1:, :3] = np.round(255 * np.clip(colors, 0, 1))
    pixels[1:, 3] = 255
    return pixels[_find_nearest(u, v, size, point_size)]


def _find_nearest(u: np.ndarray, v: np.ndarray, size: tuple[int, int], side: int) -> np.ndarray:
    """Return which square is on top in every pixel, counted from 1; 0 where there is none.

    The squares come far first, so the highest number wins: in the pixel where a square begins, and
    then in all pixels that squares reach which begin up to `side - 1` to the left and above.
    """
    width, height = size
    reach = side - 1
    begun = np.zeros((height + reach, width + reach), np.int32)
    inside = (u >= -reach) & (u < width) & (v >= -reach) & (v < height)
    numbers = np.arange(1, len(u) + 1, dtype=np.int32)
    begun[v[inside] + reach, u[inside] + reach] = numbers[inside]  # of those in one pixel, the last
    rows = reduce(np.maximum, (begun[start : start + height] for start in range(side)))
    return reduce(np.maximum, (rows[:, start : start + width] for start in range(side)))


def make_axes_points(length: float, count: int = 400) -> tuple[np.ndarray, np.ndarray]:
    """Make dense points along x (red), y (green) and z (blue) from the origin."""
    steps = np.linspace(0.0, length, count)
    points = np.concatenate([steps[:, None] * axis for axis in np.eye(3)])
    colors = np.repeat(np.array([[0.85, 0.15, 0.15], [0.1, 0.6, 0.2], [0.15, 0.35, 0.9]]), count, 0)
    return points, colors


def get_depth_colors(points: np.ndarray) -> np.ndarray:
    """Color points by their third coordinate in turbo; return RGB in [0, 1], shape (N, 3)."""
    z = points[:, 2]
    span = np.ptp(z) or 1.0
    steps = find_steps(z, (float(z.min()), float(z.min() + span)))
    return get_table("turbo")[steps] / 255


def get_view_point(
    points: np.ndarray, azimuth_deg: float = 25.0, elevation_deg: float = 20.0
) -> tuple[np.ndarray, np.ndarray]:
    """Choose a place to look at a cloud of the camera frame (y down) from.

    Returns
    -------
    target, eye : ndarray, shape (3,)
        The middle of the cloud, and a point behind and above the camera's own place.
    """
    target = np.median(points, axis=0)
    radius = 1.1 * float(np.percentile(np.linalg.norm(points - target, axis=1), 90)) + 1e-6
    azimuth, elevation = np.deg2rad([azimuth_deg, elevation_deg])
    direction = np.array(
        [
            np.sin(azimuth) * np.cos(elevation),
            -np.sin(elevation),
            -np.cos(azimuth) * np.cos(elevation),
        ]
    )
    return target, target + radius * direction
