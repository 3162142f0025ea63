"""From the depth buffer to meters, and from meters to a picture.

The arithmetic is in `labutils.depth_values`; its functions can be imported from here too.
Taught in: step 3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils._guards import check_depth_image
from labutils.depth_values import (
    find_valid_depth,
    get_clip_planes,
    get_depth_limits,
    metric_to_raw,
    process_depth,
)

if TYPE_CHECKING:
    import mujoco
    from numpy.typing import ArrayLike

    from labutils.cameras import Camera
    from labutils.renderers.protocol import Renderer

__all__ = [
    "find_valid_depth",
    "get_clip_planes",
    "get_depth_limits",
    "metric_to_raw",
    "process_depth",
    "render_raw_depth",
    "visualize_depth",
]


def render_raw_depth(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    renderer: Renderer,
    camera_name: Camera,
    *,
    scene_option: mujoco.MjvOption | None = None,
) -> np.ndarray:
    """Read the depth buffer before anything converts it.

    With OpenGL this is ``mjr_readPixels`` on an off-screen buffer of its own, read the way a
    beginner reads it: MuJoCo's default depth map (0 near, 1 far) and multisampling on. That
    costs accuracy at depth edges and far away, which step 3 measures. Without OpenGL the exact
    depth is converted backwards.

    Parameters
    ----------
    model, data, renderer, camera_name, scene_option
        As in `render_camera`; `renderer` gives the size.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Window depth, 0 at the near plane, 1 at the far plane.

    Raises
    ------
    TypeError, ValueError
        As in `render_camera`.
    """
    # Imported here, because all of this needs MuJoCo and the rest of the module also runs where it
    # does not exist: in the browser.
    from labutils.camera_utils import render_camera  # noqa: PLC0415
    from labutils.renderers import opengl, rays  # noqa: PLC0415

    render_camera(model, data, renderer, camera_name, scene_option=scene_option)
    reader = opengl if opengl.is_used_by(renderer) else rays
    return reader.read_raw_depth(model, renderer)


def visualize_depth(depth_metric: ArrayLike, max_depth: float = 5.0) -> np.ndarray:
    """Color a depth image: blue close, red far.

    Parameters
    ----------
    depth_metric : array-like, real, shape (H, W)
        Meters.
    max_depth : float
        Everything at or beyond this is the reddest red.

    Returns
    -------
    ndarray, uint8, shape (H, W, 3)
        **BGR**, ready for ``cv2.imwrite``. Black where the depth is NaN, infinite or <= 0: black
        is in no color map, so it cannot be taken for a distance.

    Raises
    ------
    TypeError, ValueError
        If the depth is no image of real numbers, or `max_depth` is not positive.
    """
    depth = check_depth_image("depth_metric", depth_metric)
    if not 0 < max_depth < np.inf:
        raise ValueError(f"max_depth: expected meters > 0, got {max_depth}")
    surface = np.isfinite(depth) & (depth > 0)
    share = np.clip(np.where(surface, depth, 0.0) / max_depth, 0.0, 1.0)
    depth_bgr = cv2.applyColorMap((share * 255).astype(np.uint8), cv2.COLORMAP_TURBO)
    depth_bgr[~surface] = 0
    return depth_bgr
