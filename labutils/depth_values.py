"""What a depth reading means: raw or meters, and whether it is a surface.

Stands on NumPy alone. Taught in: step 3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils._guards import check_depth_limits, check_real_array

if TYPE_CHECKING:
    import mujoco
    from numpy.typing import ArrayLike

#: What reads beyond this share of the far plane is sky, where the planes are as far apart as usual.
_SKY_SHARE = 0.999

#: From 1 to the next float32. `mujoco.Renderer` divides by a difference of two such numbers, which
#: is near / far and at most three quarters of a step wrong: three roundings of half a step, halved.
_FLOAT32_STEP = 2.0**-23


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


def get_depth_limits(model: mujoco.MjModel) -> tuple[float, float]:
    """Choose between which depths a reading of a model's cameras is a surface.

    What `find_valid_depth` and `depth_to_pointcloud` take for `min_depth` and `max_depth`, where a
    scene is much smaller or larger than the room of this book:
    ``depth_to_pointcloud(depth, K, min_depth=low, max_depth=high)``.

    Convention
    ----------
    Nothing before the near plane is drawn, and sky reads the far plane up to rounding, 200.007 m
    where it stands at 200 m. So sky begins a thousandth before the far plane, and a surface beyond
    that counts as sky. Where the far plane is more than 8000 times as far as the near one, sky
    begins earlier: its depth is a quotient by a difference of float32 numbers near 1, and reads up
    to 0.5 % wrong where the far plane is 50,000 times as far.

    Returns
    -------
    tuple of float
        (min_depth, max_depth) in meters.
    """
    near, far = get_clip_planes(model)
    return near, min(_SKY_SHARE * far, far / (1 + _FLOAT32_STEP * far / near))


def process_depth(depth_raw: ArrayLike, near: float = 0.01, far: float = 10.0) -> np.ndarray:
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


def metric_to_raw(depth_metric: ArrayLike, near: float = 0.01, far: float = 10.0) -> np.ndarray:
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


def find_valid_depth(
    depth_metric: ArrayLike, min_depth: float = MIN_DEPTH, max_depth: float = MAX_DEPTH
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
