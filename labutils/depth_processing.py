"""From the depth buffer to meters, and from meters to a picture.

Taught in: step 3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils._guards import check_depth_image, check_depth_limits, check_real_array

if TYPE_CHECKING:
    import mujoco

    from labutils.rendering import AnyRenderer


def get_clip_planes(model: mujoco.MjModel) -> tuple[float, float]:
    """Read the near and far clip planes of a model in meters.

    Convention
    ----------
    ``vis.map.znear`` and ``zfar`` are multiples of ``stat.extent``, the size of the scene, not
    meters.

    Returns
    -------
    tuple of float
        (near, far) in meters.
    """
    extent = float(model.stat.extent)
    # MuJoCo keeps the factors in float32; the product with the extent is rounded to what the
    # file says, so that 0.01 reads 0.01 and not 0.009999999776.
    near = float(f"{model.vis.map.znear * extent:.6g}")
    far = float(f"{model.vis.map.zfar * extent:.6g}")
    return near, far


def process_depth(depth_raw: np.ndarray, near: float = 0.01, far: float = 10.0) -> np.ndarray:
    """Turn window-space depth into meters.

    Convention
    ----------
    Window depth is 0 at the near plane and 1 at the far plane, and hyperbolic in between: half
    of its range is spent on the first few centimeters. (MuJoCo draws with *reversed* z inside, 1
    near and 0 far; pass ``1 - d`` for such a buffer.) `mujoco.Renderer` has done this step
    already: do not apply it to its depth.

    Parameters
    ----------
    depth_raw : array-like, real, any shape
        Window depth; values outside [0, 1] are clipped, NaN stays NaN.
    near, far : float
        Clip planes in meters, see `get_clip_planes`.

    Returns
    -------
    ndarray, float32 or float64, same shape
        Meters along the optical axis. float64 only where float64 came in.

    Raises
    ------
    TypeError, ValueError
        If the depth is not real numbers, or not 0 < near < far.

    Examples
    --------
    >>> process_depth(np.array([0.0, 0.5, 1.0]), near=1.0, far=3.0)
    array([1. , 1.5, 3. ])

    References
    ----------
    .. [1] OpenGL 2.1 reference, ``glFrustum``, with the depth range 0 to 1.
    """
    raw = check_real_array("depth_raw", depth_raw)
    near, far = check_depth_limits("near", near, "far", far)
    dtype = raw.dtype if raw.dtype == np.float64 else np.float32
    raw = np.clip(raw.astype(np.float64), 0.0, 1.0)
    return (near * far / (far - raw * (far - near))).astype(dtype)


def metric_to_raw(depth_metric: np.ndarray, near: float = 0.01, far: float = 10.0) -> np.ndarray:
    """Turn meters into window-space depth: the inverse of `process_depth`.

    Parameters
    ----------
    depth_metric : array-like, real, any shape
        Meters; values outside [near, far] are clipped to it, NaN stays NaN.
    near, far : float
        Clip planes in meters.

    Returns
    -------
    ndarray, float64, same shape
        Window depth in [0, 1]. Double precision, because float32 keeps only a few levels far
        away (see step 3).

    Raises
    ------
    TypeError, ValueError
        As in `process_depth`.
    """
    metric = check_real_array("depth_metric", depth_metric)
    near, far = check_depth_limits("near", near, "far", far)
    metric = np.clip(metric.astype(np.float64), near, far)
    return (far - near * far / metric) / (far - near)


def render_raw_depth(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: AnyRenderer, camera_name: str
) -> np.ndarray:
    """Read the depth buffer before anything converts it.

    With OpenGL this is ``mjr_readPixels`` on an off-screen buffer of its own, read the way a
    beginner reads it: MuJoCo's default depth map (0 near, 1 far) and multisampling on. That
    costs accuracy at depth edges and far away, which step 3 measures. Without OpenGL the exact
    depth is converted backwards.

    Parameters
    ----------
    model, data, renderer, camera_name
        As in `render_camera`; `renderer` gives the size.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Window depth, 0 at the near plane, 1 at the far plane.

    Raises
    ------
    ValueError
        If the model has no such camera.
    """
    # MuJoCo is imported here so that the rest of this module runs where it does not exist: in the
    # browser.
    import mujoco  # noqa: PLC0415

    from labutils.camera_utils import render_camera  # noqa: PLC0415
    from labutils.rendering import is_gl_available  # noqa: PLC0415

    _, depth = render_camera(model, data, renderer, camera_name)
    if not (is_gl_available() and isinstance(renderer, mujoco.Renderer)):
        return metric_to_raw(depth, *get_clip_planes(model)).astype(np.float32)
    height, width = depth.shape
    raw = np.empty((height, width), dtype=np.float32)
    gl_context = mujoco.GLContext(width, height)
    try:
        gl_context.make_current()
        context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, context)
        rect = mujoco.MjrRect(0, 0, width, height)
        mujoco.mjr_render(rect, renderer.scene, context)
        mujoco.mjr_readPixels(None, raw, rect, context)
        context.free()
    finally:
        gl_context.free()
    return np.flipud(raw).copy()  # OpenGL's first row is the bottom one


def find_valid_depth(
    depth_metric: np.ndarray, min_depth: float = MIN_DEPTH, max_depth: float = MAX_DEPTH
) -> np.ndarray:
    """Mark the pixels whose depth is a surface.

    Parameters
    ----------
    depth_metric : array-like, real, any shape
        Meters.
    min_depth, max_depth : float
        Readings at or below `min_depth` or at or beyond `max_depth` are no surface.

    Returns
    -------
    ndarray, bool, same shape
        False also for NaN and infinity.

    Raises
    ------
    TypeError, ValueError
        If the depth is not real numbers, or not 0 < min_depth < max_depth.
    """
    depth = check_real_array("depth_metric", depth_metric)
    min_depth, max_depth = check_depth_limits("min_depth", min_depth, "max_depth", max_depth)
    return (depth > min_depth) & (depth < max_depth)  # any comparison with NaN is False


def visualize_depth(depth_metric: np.ndarray, max_depth: float = 5.0) -> np.ndarray:
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
