"""Render color, depth and labels from a camera of the scene.

What that camera is, `labutils.cameras` derives; its functions can be imported from here too.
Taught in: step 1 (rendering) and step 2 (intrinsics).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from labutils.cameras import (
    get_camera_id,
    get_camera_intrinsics,
    get_camera_pose,
    intrinsics_matrix,
)

if TYPE_CHECKING:
    from labutils.renderers.protocol import Renderer

__all__ = [
    "get_camera_id",
    "get_camera_intrinsics",
    "get_camera_pose",
    "intrinsics_matrix",
    "render_camera",
    "render_segmentation",
]


def render_camera(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    renderer: Renderer,
    camera_name: str,
) -> tuple[np.ndarray, np.ndarray]:
    """Render color and depth from a named camera.

    Convention
    ----------
    The picture shows the *current* ``data.qpos`` (and mocap poses): positions are brought up to
    date by ``mj_kinematics`` and ``mj_camlight`` first, which change no state. Depth is metric:
    meters along the optical axis, not along the ray. Pixels that see nothing read the far plane.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene and its state.
    renderer : mujoco.Renderer or RaycastRenderer
        From `make_renderer`; its size is the picture size.
    camera_name : str
        Name of a camera of the model.

    Returns
    -------
    rgb : ndarray, uint8, shape (H, W, 3)
        The color picture. The renderer is left in color mode.
    depth : ndarray, float32, shape (H, W)
        Meters.

    Raises
    ------
    ValueError
        If the model has no such camera.

    References
    ----------
    .. [1] MuJoCo documentation, Python bindings, ``mujoco.Renderer``.
    """
    get_camera_id(model, camera_name)
    _update_positions(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.disable_segmentation_rendering()
    renderer.disable_depth_rendering()
    rgb = renderer.render()
    try:
        renderer.enable_depth_rendering()
        depth = renderer.render()
    finally:
        renderer.disable_depth_rendering()
    return rgb, depth


def render_segmentation(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    renderer: Renderer,
    camera_name: str,
) -> np.ndarray:
    """Render which body every pixel belongs to: labels a real camera does not have.

    Parameters
    ----------
    model, data, renderer, camera_name
        As in `render_camera`.

    Returns
    -------
    ndarray, int32, shape (H, W)
        Body ids as in ``model.body(name).id``; -1 where nothing is seen.

    Raises
    ------
    ValueError
        If the model has no such camera.
    """
    get_camera_id(model, camera_name)
    _update_positions(model, data)
    renderer.update_scene(data, camera=camera_name)
    try:
        renderer.enable_segmentation_rendering()
        pairs = renderer.render()
    finally:
        renderer.disable_segmentation_rendering()
    object_ids, kinds = pairs[..., 0], pairs[..., 1]
    is_geom = kinds == int(mujoco.mjtObj.mjOBJ_GEOM)
    # Pixels of anything else (a site, a contact arrow) carry no body: they count as nothing.
    return np.where(is_geom, model.geom_bodyid[np.where(is_geom, object_ids, 0)], -1).astype(
        np.int32
    )


def _update_positions(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Bring body, geom, camera and light poses up to date with qpos.

    The full ``mj_forward`` would also run contacts, forces and sensors, which no picture shows:
    these two calls do what a picture needs, and leave accelerations and sensor data alone.
    """
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
