"""Right answers to render_camera, written in ways that the card does not contain."""

from typing import Any

import mujoco
import numpy as np
from mujoco import Renderer as MujocoRenderer

from labutils.renderers.protocol import Renderer


def render_with_kinematics(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
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


def render_with_a_second_renderer(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    """Depth from a renderer of its own, so that the one that was given stays as it is."""
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    with mujoco.Renderer(model, renderer.height, renderer.width) as second:
        second.update_scene(data, camera_name)
        second.enable_depth_rendering()
        return renderer.render(), second.render()


def render_with_a_renderer_imported_by_name(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    mujoco.mj_forward(model, data)
    mine = MujocoRenderer(model, height=renderer.height, width=renderer.width, max_geom=500)
    mine.update_scene(data, camera=camera_name)
    rgb = mine.render()
    mine.close()
    renderer.update_scene(data, camera=camera_name)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def render_into_arrays_with_options(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Any, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    mujoco.mj_forward(model, data)
    camera = mujoco.MjvCamera()
    camera.type = int(mujoco.mjtCamera.mjCAMERA_FIXED)
    camera.fixedcamid = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if camera.fixedcamid < 0:
        raise ValueError(f"no camera {camera_name}")
    rgb = np.empty((renderer.height, renderer.width, 3), dtype=np.uint8)
    depth = np.empty((renderer.height, renderer.width), dtype=np.float32)
    renderer.update_scene(data, camera, scene_option=mujoco.MjvOption())
    renderer.scene.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = 0
    renderer.render(out=rgb)
    renderer.enable_depth_rendering()
    renderer.render(out=depth)
    renderer.disable_depth_rendering()
    return rgb, depth


def render_with_the_class_of_the_renderer(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Any, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    if not isinstance(renderer, mujoco.Renderer):
        raise TypeError("renderer")
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    other = type(renderer)(model, rgb.shape[0], rgb.shape[1])
    other.update_scene(data, camera=camera_name)
    other.enable_depth_rendering()
    depth = other.render()
    other.disable_depth_rendering()
    other.close()
    return rgb, depth


def render_without_the_renderer(
    model: mujoco.MjModel, data: mujoco.MjData, renderer: Renderer, camera_name: str
) -> tuple[np.ndarray, np.ndarray]:
    """Both pictures from a renderer and a state of its own: only the size is asked for."""
    twin = mujoco.MjData(model)
    mujoco.mj_copyData(twin, model, data)
    mujoco.mj_forward(model, twin)
    with mujoco.Renderer(model, renderer.height, renderer.width) as mine:
        mine.update_scene(twin, camera_name)
        rgb = mine.render()
        mine.enable_depth_rendering()
        return rgb, mine.render()


VARIANTS = [
    render_with_kinematics,
    render_by_id_in_double,
    render_as_lists,
    render_with_a_second_renderer,
    render_with_a_renderer_imported_by_name,
    render_into_arrays_with_options,
    render_with_the_class_of_the_renderer,
    render_without_the_renderer,
]
