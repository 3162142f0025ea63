"""The point cloud explorer's first view without a browser, drawn by the book's point renderer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from labutils._splat import get_depth_colors, render_points
from labutils.cameras import intrinsics_matrix
from labutils.explorers._cloud_start import turn_to_view

if TYPE_CHECKING:
    from collections.abc import Mapping

#: Angle of the reader's own view from top to bottom.
VIEW_FOV_DEG = 50.0
_SIZE = (640, 480)
#: The book's paper: the poster stands for a view whose ground is the page.
_PAPER = np.array([253, 252, 250], np.uint8)


def make_view_transform(orbit: Mapping[str, Any]) -> np.ndarray:
    """Build the transform (4x4) from the frame one orbits in to the reader's eye.

    Azimuth 0, elevation 0 looks along z; a positive azimuth stands to the right, a positive
    elevation above. Unlike `make_look_at` it also knows which way is up when one looks straight
    down.
    """
    azimuth, elevation = np.radians([orbit["azimuth_deg"], orbit["elevation_deg"]])
    right = np.array([np.cos(azimuth), 0.0, np.sin(azimuth)])
    forward = np.array(
        [
            -np.sin(azimuth) * np.cos(elevation),
            np.sin(elevation),
            np.cos(azimuth) * np.cos(elevation),
        ]
    )
    rotation = np.stack([right, np.cross(forward, right), forward])
    T_eye_view = np.eye(4)
    T_eye_view[:3, :3] = rotation
    T_eye_view[:3, 3] = -rotation @ orbit["target"] + [0, 0, orbit["distance"]]
    return T_eye_view


def draw_cloud(
    points: np.ndarray,
    colors: np.ndarray | None,
    T_world_cam: np.ndarray | None,
    orbit: Mapping[str, Any],
) -> np.ndarray:
    """Draw points of the camera frame as the explorer does: uint8 RGB (480, 640, 3)."""
    # The page counts from the corner of the first pixel, where the middle is at W/2; the point
    # renderer counts from its center, where the same middle is at (W-1)/2.
    K = intrinsics_matrix(np.radians(VIEW_FOV_DEG), *_SIZE)
    T_eye_cam = make_view_transform(orbit) @ turn_to_view(T_world_cam)
    if colors is None:
        colors = get_depth_colors(points)
    rgba = render_points(points, colors, T_eye_cam, K, _SIZE, point_size=2)
    return np.where(rgba[..., 3:] > 0, rgba[..., :3], _PAPER)
