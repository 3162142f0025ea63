"""Right answers to render_camera, written in ways that the card does not contain."""

from typing import Any

import mujoco
import numpy as np

from labutils.renderers.protocol import Renderer


def render_with_kinematics(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return renderer.render(), depth


def render_by_id_in_double(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera_name: str
) -> list[np.ndarray]:
    camera = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if camera == -1:
        raise ValueError(camera_name)
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera)
    rgb = renderer.render().copy()
    renderer.enable_depth_rendering()
    depth = renderer.render().astype(np.float64)
    renderer.disable_depth_rendering()
    return [rgb, depth]


def render_as_lists(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera_name: str
) -> tuple[np.ndarray, list[Any]]:
    rgb, depth = render_with_kinematics(model, data, renderer, camera_name)
    return rgb, depth.tolist()


VARIANTS = [render_with_kinematics, render_by_id_in_double, render_as_lists]
