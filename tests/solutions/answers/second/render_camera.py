"""Right answers to render_camera, as strangers wrote them."""
import contextlib
import copy
from dataclasses import dataclass, field

import mujoco
import numpy as np


# 1. five calls of the chapter, mj_forward first
def f1(model, data, renderer, camera_name):
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) < 0:
        raise ValueError(f"no camera named {camera_name!r}")
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


# 2. a context manager for the mode, an own copy of the data, MjvCamera
@contextlib.contextmanager
def _mode(renderer, depth):
    renderer.disable_segmentation_rendering()
    if depth:
        renderer.enable_depth_rendering()
    else:
        renderer.disable_depth_rendering()
    try:
        yield renderer
    finally:
        renderer.disable_depth_rendering()


def f2(model, data, renderer, camera_name):
    try:
        cam_id = model.camera(camera_name).id
    except KeyError as err:
        raise ValueError(f"unknown camera {camera_name}") from err
    own = copy.copy(data)
    mujoco.mj_fwdPosition(model, own)
    view = mujoco.MjvCamera()
    view.type = mujoco.mjtCamera.mjCAMERA_FIXED
    view.fixedcamid = cam_id
    renderer.update_scene(own, view)
    with _mode(renderer, depth=True):
        depth = renderer.render().astype(np.float64)
    with _mode(renderer, depth=False):
        rgb = renderer.render()
    return rgb, depth


# 3. only the kinematic parts, in place, own buffers, id by a loop of names
def f3(model, data, renderer, camera_name):
    index = None
    for i in range(model.ncam):
        if model.cam(i).name == camera_name and camera_name:
            index = i
            break
    if index is None:
        raise ValueError("The model has no camera " + repr(camera_name))
    for part in (mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_camlight,
                 mujoco.mj_flex, mujoco.mj_tendon):
        part(model, data)
    H, W = renderer.height, renderer.width
    color = np.zeros((H, W, 3), np.uint8)
    meters = np.zeros((H, W), np.float32)
    renderer.disable_segmentation_rendering()
    renderer.disable_depth_rendering()
    renderer.update_scene(data, index)
    renderer.render(out=color)
    try:
        renderer.enable_depth_rendering()
        renderer.render(out=meters)
    finally:
        renderer.disable_depth_rendering()
    return color, meters


# 4. a second renderer of my own; the borrowed one is only put to color
def f4(model, data, renderer, camera_name):
    names = {model.camera(i).name for i in range(model.ncam)} - {""}
    if camera_name not in names:
        raise ValueError(f"{camera_name!r} is not one of {sorted(names)}")
    twin = mujoco.MjData(model)
    mujoco.mj_copyData(twin, model, data)
    mujoco.mj_forward(model, twin)
    with mujoco.Renderer(model, renderer.height, renderer.width) as mine:
        mine.update_scene(twin, camera_name)
        rgb = mine.render()
        mine.enable_depth_rendering()
        depth = mine.render()
    renderer.disable_depth_rendering()
    renderer.disable_segmentation_rendering()
    return rgb, depth


# 5. over-engineered: a dataclass service
@dataclass
class _Snapshot:
    model: mujoco.MjModel
    data: mujoco.MjData
    renderer: mujoco.Renderer
    camera_id: int = field(default=-1)

    def select(self, name):
        if not isinstance(name, str):
            raise ValueError("camera_name must be a string")
        self.camera_id = mujoco.mj_name2id(
            self.model, mujoco.mjtObj.mjOBJ_CAMERA.value, name)
        if self.camera_id == -1:
            raise ValueError(f"camera {name!r} does not exist")
        return self

    def refresh(self):
        mujoco.mj_forward(self.model, self.data)
        self.renderer.update_scene(self.data, camera=self.camera_id)
        return self

    def _color(self):
        self.renderer.disable_depth_rendering()
        self.renderer.disable_segmentation_rendering()
        return self.renderer.render().copy()

    def _depth(self):
        self.renderer.enable_depth_rendering()
        return np.array(self.renderer.render(), dtype=float)

    def shoot(self):
        try:
            depth = self._depth()
        finally:
            color = self._color()
        return color, depth


def f5(model, data, renderer, camera_name):
    return _Snapshot(model, data, renderer).select(camera_name).refresh().shoot()


# 6. short: the Renderer itself raises ValueError
def f6(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


# 7. ExitStack, state restored through mj_getState into fresh data
def f7(model, data, renderer, camera_name, dtype=np.float64):
    cid = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if cid == -1:
        raise ValueError(camera_name)
    spec = mujoco.mjtState.mjSTATE_INTEGRATION
    state = np.empty(mujoco.mj_stateSize(model, spec))
    mujoco.mj_getState(model, data, state, spec)
    scratch = mujoco.MjData(model)
    mujoco.mj_setState(model, scratch, state, spec)
    mujoco.mj_forward(model, scratch)
    with contextlib.ExitStack() as stack:
        stack.callback(renderer.disable_segmentation_rendering)
        stack.callback(renderer.disable_depth_rendering)
        renderer.disable_depth_rendering()
        renderer.disable_segmentation_rendering()
        renderer.update_scene(scratch, cid)
        pictures = [renderer.render()]
        renderer.enable_depth_rendering()
        pictures.append(renderer.render().astype(dtype))
    return tuple(pictures)


# 8. generator of the two pictures, returned as a list of two
def _pictures(renderer):
    for switch in (renderer.disable_depth_rendering, renderer.enable_depth_rendering):
        renderer.disable_segmentation_rendering()
        switch()
        yield renderer.render()
    renderer.disable_depth_rendering()


def f8(model, data, renderer, camera_name):
    try:
        cam = model.cam(camera_name)
    except KeyError:
        raise ValueError(f"no such camera: {camera_name}") from None
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    mujoco.mj_flex(model, data)
    mujoco.mj_tendon(model, data)
    renderer.update_scene(data, cam.id)
    rgb, depth = _pictures(renderer)
    return rgb, depth


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
