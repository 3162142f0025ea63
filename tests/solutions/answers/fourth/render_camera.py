"""Right answers to render_camera, as strangers wrote them."""
import contextlib
import copy

import mujoco
import numpy as np


# 1. the five calls of the book; update_scene raises the ValueError
def f1(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.disable_depth_rendering()
    renderer.disable_segmentation_rendering()
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    try:
        depth = renderer.render()
    finally:
        renderer.disable_depth_rendering()
    return rgb, depth


# 2. mj_name2id, positions only
def f2(model, data, renderer, camera_name):
    cam_id = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if cam_id < 0:
        raise ValueError(f"no camera named {camera_name!r}")
    for part in (mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_camlight,
                 mujoco.mj_flex, mujoco.mj_tendon):
        part(model, data)
    renderer.update_scene(data, camera=cam_id)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    rgb = renderer.render()
    return rgb, depth


# 3. context manager, KeyError turned
@contextlib.contextmanager
def depth_mode(renderer):
    renderer.enable_depth_rendering()
    try:
        yield renderer
    finally:
        renderer.disable_depth_rendering()


def f3(model, data, renderer, camera_name):
    try:
        camera = model.camera(camera_name)
    except KeyError as error:
        raise ValueError(f"no such camera: {camera_name}") from error
    mujoco.mj_fwdPosition(model, data)
    renderer.update_scene(data, camera.id)
    with depth_mode(renderer):
        depth = renderer.render().astype(np.float64)
    renderer.disable_segmentation_rendering()
    return renderer.render(), depth


# 4. own copy of the data
def f4(model, data, renderer, camera_name):
    names = [model.camera(i).name for i in range(model.ncam)]
    if camera_name not in names:
        raise ValueError(f"{camera_name!r} is not one of {names}")
    now = copy.copy(data)
    mujoco.mj_forward(model, now)
    renderer.disable_segmentation_rendering()
    renderer.disable_depth_rendering()
    renderer.update_scene(now, camera=camera_name)
    rgb = renderer.render().copy()
    with depth_mode(renderer):
        return rgb, renderer.render().copy()


# 5. out=, MjvCamera
def f5(model, data, renderer, camera_name):
    number = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA.value, camera_name)
    if number == -1:
        raise ValueError("unknown camera " + camera_name)
    view = mujoco.MjvCamera()
    view.type = mujoco.mjtCamera.mjCAMERA_FIXED
    view.fixedcamid = number
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, view)
    rgb = np.zeros((renderer.height, renderer.width, 3), dtype=np.uint8)
    depth = np.zeros((renderer.height, renderer.width), dtype=np.float32)
    renderer.disable_segmentation_rendering()
    try:
        renderer.enable_depth_rendering()
        renderer.render(out=depth)
    finally:
        renderer.disable_depth_rendering()
    renderer.render(out=rgb)
    return rgb, depth


# 6. fresh MjData with the state copied over
def f6(model, data, renderer, camera_name):
    if not any(model.camera(i).name == camera_name for i in range(model.ncam)):
        raise ValueError(f"camera {camera_name} does not exist")
    fresh = mujoco.MjData(model)
    size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_INTEGRATION)
    state = np.empty(size)
    mujoco.mj_getState(model, data, state, mujoco.mjtState.mjSTATE_INTEGRATION)
    mujoco.mj_setState(model, fresh, state, mujoco.mjtState.mjSTATE_INTEGRATION)
    mujoco.mj_forward(model, fresh)
    renderer.update_scene(fresh, camera=camera_name)
    pictures = []
    for enable in (renderer.disable_depth_rendering, renderer.enable_depth_rendering):
        renderer.disable_segmentation_rendering()
        enable()
        pictures.append(renderer.render())
    renderer.disable_depth_rendering()
    return tuple(pictures)


# 7. class, validation, ExitStack
class CameraShot:
    def __init__(self, model, data, renderer):
        self.model, self.data, self.renderer = model, data, renderer

    def camera_id(self, name):
        if not isinstance(name, str):
            raise ValueError("the name must be a string")
        number = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_CAMERA, name)
        if number < 0:
            raise ValueError(f"no camera {name!r}")
        return number

    def refresh(self):
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        mujoco.mj_camlight(self.model, self.data)
        mujoco.mj_flex(self.model, self.data)
        mujoco.mj_tendon(self.model, self.data)

    def take(self, name):
        number = self.camera_id(name)
        self.refresh()
        with contextlib.ExitStack() as stack:
            stack.callback(self.renderer.disable_depth_rendering)
            stack.callback(self.renderer.disable_segmentation_rendering)
            self.renderer.disable_depth_rendering()
            self.renderer.disable_segmentation_rendering()
            self.renderer.update_scene(self.data, number)
            rgb = self.renderer.render()
            self.renderer.enable_depth_rendering()
            depth = self.renderer.render()
        return rgb, depth


def f7(model, data, renderer, camera_name):
    return CameraShot(model, data, renderer).take(camera_name)


# 8. a second renderer for depth, so the given one never leaves color mode
def f8(model, data, renderer, camera_name):
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) < 0:
        raise ValueError("no camera " + repr(camera_name))
    mujoco.mj_forward(model, data)
    renderer.disable_depth_rendering()
    renderer.disable_segmentation_rendering()
    renderer.update_scene(data, camera_name)
    rgb = renderer.render()
    with mujoco.Renderer(model, height=rgb.shape[0], width=rgb.shape[1]) as second:
        second.enable_depth_rendering()
        second.update_scene(data, camera_name)
        depth = second.render()
    return rgb, depth


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
