"""Starter of the exercise process_depth.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def process_depth(depth_raw, near=0.01, far=10.0):
    """Turn window-space depth into meters.

    Convention
    ----------
    Window depth is 0 at the near plane and 1 at the far plane, and
    hyperbolic in between: half of its range is spent on the first few
    centimeters. (MuJoCo draws with *reversed* z inside, 1 near and 0
    far; pass ``1 - d`` for such a buffer.) `mujoco.Renderer` has done
    this step already: do not apply it to its depth.

    Parameters
    ----------
    depth_raw : ndarray, float32, shape (H, W)
        Window depth; values outside [0, 1] are clipped, NaN stays
        NaN.
    near, far : float
        Clip planes in meters, see `get_clip_planes`.

    The arguments stay as they are.

    Returns
    -------
    ndarray, float, shape (H, W)
        Meters along the optical axis.

    Examples
    --------
    >>> process_depth(np.array([[0.0, 0.5, 1.0]]), near=1.0, far=3.0)
    array([[1. , 1.5, 3. ]])

    References
    ----------
    .. [1] OpenGL 2.1 reference, ``glFrustum``, with the depth range 0
    to 1.
    """
    raise NotImplementedError
