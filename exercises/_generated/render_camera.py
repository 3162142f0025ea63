"""Starter of the exercise render_camera.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import mujoco


def render_camera(model, data, renderer, camera_name):
    """Render color and depth from a camera.

    Convention
    ----------
    The picture shows the *current* ``data.qpos``: what follows from
    it is brought up to date first, which changes no state. Depth is
    metric: meters along the optical axis, not along the ray. Pixels
    that see nothing read the far plane.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene and its state.
    renderer : mujoco.Renderer
        From `make_renderer`; its size is the picture size.
    camera_name : str
        Name of a camera of the model.

    The arguments stay as they are. What follows from the state in
    `data` may be brought up to date.

    Returns
    -------
    rgb : ndarray, uint8, shape (H, W, 3)
        The color picture. The renderer is left in color mode.
    depth : ndarray, float, shape (H, W)
        Meters.

    Raises
    ------
    ValueError
        If the model has no such camera.

    References
    ----------
    .. [1] MuJoCo documentation, Python bindings, ``mujoco.Renderer``.
    """
    raise NotImplementedError
