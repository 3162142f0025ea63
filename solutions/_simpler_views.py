"""Simplifications of points of the world that a camera looks at."""

from __future__ import annotations

from typing import Any

import numpy as np

from labutils import find_valid_depth
from solutions._simpler import carry


def _look(args: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    """Return the points in the camera frame, and their pixels."""
    points = carry(args["points_world"], args["T_world_cam"], np.eye(4))
    with np.errstate(all="ignore"):
        pixels = points @ args["K"].T
        return points, pixels[:, :2] / pixels[:, 2:]


def keep_ahead(args: dict[str, Any]) -> dict[str, Any]:
    """Keep the points that lie well before the camera."""
    points, _ = _look(args)
    return {"points_world": args["points_world"][points[:, 2] > 0.02]}


def keep_inside(args: dict[str, Any]) -> dict[str, Any]:
    """Keep the points that the picture shows."""
    points, pixels = _look(args)
    last = np.array(args["depth_metric"].shape[::-1]) - 1
    kept = (points[:, 2] > 0.02) & ((pixels > 0) & (pixels < last)).all(axis=1)
    return {"points_world": args["points_world"][kept]}


def put_on_pixels(args: dict[str, Any]) -> dict[str, Any]:
    """Move every point to the center of its pixel, at the same depth."""
    return _put(args, np.rint)


def put_on_surface(args: dict[str, Any]) -> dict[str, Any]:
    """Move every point along its ray to the depth that was measured there."""
    return _put(args, np.asarray, on_surface=True)


def _put(args: dict[str, Any], place: Any, *, on_surface: bool = False) -> dict[str, Any]:
    points, pixels = _look(args)
    height, width = args["depth_metric"].shape
    pixels = place(pixels)
    inside = points[:, 2] > 0.02
    inside &= ((np.rint(pixels) >= 0) & (np.rint(pixels) < [width, height])).all(axis=1)
    z = points[inside, 2]
    u, v = np.rint(pixels[inside]).astype(int).T
    seen = args["depth_metric"][v, u]
    if on_surface:
        z = np.where(find_valid_depth(seen), seen, z)
    ways = np.column_stack([pixels[inside], np.ones(len(z))]) @ np.linalg.inv(args["K"]).T
    return {"points_world": carry(ways * z[:, None], np.eye(4), args["T_world_cam"])}
