"""Render color, depth and labels from a camera of the scene.

What that camera is, `labutils.cameras` derives; its functions can be imported from here too.
Taught in: step 1 (rendering) and step 2 (intrinsics).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from labutils._positions import range_finders_measured, update_positions
from labutils._scene_guards import check_renderer, check_state
from labutils.cameras import (
    get_camera_id,
    get_camera_intrinsics,
    get_camera_pose,
    intrinsics_matrix,
)
from labutils.free_camera import is_free
from labutils.renderers.opengl import is_wrong_thread

if TYPE_CHECKING:
    from labutils.cameras import Camera
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
    camera_name: Camera,
    *,
    scene_option: mujoco.MjvOption | None = None,
) -> tuple[np.ndarray, np.ndarray]:
    """Render color and depth from a camera.

    Convention
    ----------
    The picture shows the *current* ``data.qpos`` (and mocap poses): what follows from them is
    brought up to date first, which changes no state. Depth is metric: meters along the optical
    axis, not along the ray. Pixels that see nothing read the far plane.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene and its state.
    renderer : mujoco.Renderer or RaycastRenderer
        From `make_renderer`; its size is the picture size.
    camera_name : str, int or mujoco.MjvCamera
        Name or number of a camera of the model, or the free camera of a viewer.
    scene_option : mujoco.MjvOption, optional
        What is drawn, such as groups of geoms; MuJoCo's default without it. What it adds from
        the dynamics, such as contacts, is drawn as it stands in `data`.

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
    _update(model, data, renderer, camera_name, scene_option)
    renderer.disable_segmentation_rendering()
    renderer.disable_depth_rendering()
    rgb = _draw(renderer)
    try:
        renderer.enable_depth_rendering()
        depth = _draw(renderer)
    finally:
        renderer.disable_depth_rendering()
    return rgb, depth


def render_segmentation(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    renderer: Renderer,
    camera_name: Camera,
    *,
    scene_option: mujoco.MjvOption | None = None,
) -> np.ndarray:
    """Render which body every pixel belongs to: labels a real camera does not have.

    Parameters
    ----------
    model, data, renderer, camera_name, scene_option
        As in `render_camera`.

    Returns
    -------
    ndarray, int32, shape (H, W)
        Body ids as in ``model.body(name).id``; -1 where nothing is seen.

    Raises
    ------
    TypeError, ValueError
        As in `render_camera`.
    """
    _update(model, data, renderer, camera_name, scene_option)
    try:
        renderer.enable_segmentation_rendering()
        pairs = _draw(renderer)
    finally:
        renderer.disable_segmentation_rendering()
    object_ids, kinds = pairs[..., 0], pairs[..., 1]
    is_geom = kinds == int(mujoco.mjtObj.mjOBJ_GEOM)
    # Pixels of anything else (a site, a contact arrow) carry no body: they count as nothing.
    return np.where(is_geom, model.geom_bodyid[np.where(is_geom, object_ids, 0)], -1).astype(
        np.int32
    )


def _update(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    renderer: Renderer,
    camera: Camera,
    scene_option: mujoco.MjvOption | None,
) -> None:
    """Show the renderer the current state, or say what does not fit, before anything is done."""
    check_state(model, data)
    check_renderer(model, renderer)
    chosen = camera if is_free(camera) else get_camera_id(model, camera)
    update_positions(model, data)
    with range_finders_measured(model, data):
        renderer.update_scene(data, camera=chosen, scene_option=scene_option)


def _draw(renderer: Renderer) -> np.ndarray:
    """Draw; say in a sentence what OpenGL says in a code."""
    try:
        return renderer.render()
    except Exception as error:
        if is_wrong_thread(error):
            raise RuntimeError(
                "renderer: expected one made in this thread, got one that OpenGL has bound to "
                "another thread; call make_renderer in every thread that draws"
            ) from error
        raise
