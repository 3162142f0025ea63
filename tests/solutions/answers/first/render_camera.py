"""Right answers to render_camera, as strangers wrote them."""
import contextlib
import copy

import mujoco
import numpy as np


def forward_then_render(model, data, renderer, camera_name):
    """mj_forward (time and state stay), color first, then depth, then back to color mode."""
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) == -1:
        raise ValueError(f"no camera {camera_name!r}")
    mujoco.mj_forward(model, data)
    renderer.disable_depth_rendering()
    renderer.disable_segmentation_rendering()
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def only_positions(model, data, renderer, camera_name):
    """The five position functions of the book; depth first (this also ends any other mode), then color."""
    try:
        model.camera(camera_name)
    except KeyError:
        raise ValueError(f"the model has no camera {camera_name!r}") from None
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    mujoco.mj_flex(model, data)
    mujoco.mj_tendon(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return renderer.render(), depth


@contextlib.contextmanager
def _depth_mode(renderer):
    renderer.enable_depth_rendering()
    try:
        yield renderer
    finally:
        renderer.disable_depth_rendering()


def with_a_context_manager(model, data, renderer, camera_name):
    """mj_fwdPosition; depth inside a context manager, so color mode comes back even after an error; names compared in a loop."""
    names = [model.camera(i).name for i in range(model.ncam)]
    if not camera_name or camera_name not in names:
        raise ValueError(f"{camera_name!r} is not among {names}")
    mujoco.mj_fwdPosition(model, data)
    with _depth_mode(renderer):
        renderer.update_scene(data, camera=camera_name)
        depth = np.array(renderer.render(), dtype=np.float32)
    rgb = np.array(renderer.render(), dtype=np.uint8)
    return rgb, depth


def state_kept_to_the_bit(model, data, renderer, camera_name):
    """Over-engineered: saves the whole integration state around mj_forward and puts it back, warm start included."""
    known = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_CAMERA, i) for i in range(model.ncam)]
    if camera_name is None or camera_name not in known:
        raise ValueError(f"unknown camera: {camera_name}")
    kind = mujoco.mjtState.mjSTATE_INTEGRATION
    state = np.empty(mujoco.mj_stateSize(model, kind))
    mujoco.mj_getState(model, data, state, kind)
    mujoco.mj_forward(model, data)
    mujoco.mj_setState(model, data, state, kind)
    pictures = {}
    for mode in ("depth", "color"):
        if mode == "depth":
            renderer.enable_depth_rendering()
        else:
            renderer.disable_depth_rendering()
        renderer.update_scene(data, camera=camera_name)
        pictures[mode] = renderer.render().copy()
    return pictures["color"], pictures["depth"]


def forward_without_sensors(model, data, renderer, camera_name):
    """mj_forwardSkip leaves the sensor readings alone; segmentation switched off only where the renderer has it."""
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA.value, camera_name) < 0:
        raise ValueError("The model has no such camera.")
    mujoco.mj_forwardSkip(model, data, mujoco.mjtStage.mjSTAGE_NONE, 1)
    for switch in ("disable_segmentation_rendering", "disable_depth_rendering"):
        getattr(renderer, switch, lambda: None)()
    renderer.update_scene(data, camera_name)
    color = np.ascontiguousarray(renderer.render())
    try:
        renderer.enable_depth_rendering()
        meters = np.asarray(renderer.render(), np.float32)
    finally:
        renderer.disable_depth_rendering()
    return color, meters


class _Photographer:
    def __init__(self, model, data, renderer):
        self.model, self.data, self.renderer = model, data, renderer

    def find(self, name):
        for i in range(self.model.ncam):
            if name and self.model.camera(i).name == name:
                return i
        raise ValueError(f"camera {name!r} does not exist")

    def aim(self, name):
        self.find(name)
        for update in (mujoco.mj_kinematics, mujoco.mj_comPos, mujoco.mj_camlight,
                       mujoco.mj_flex, mujoco.mj_tendon):
            update(self.model, self.data)
        self.renderer.update_scene(self.data, camera=name)

    def shoot(self, depth):
        self.renderer.enable_depth_rendering()
        if not depth:
            self.renderer.disable_depth_rendering()
        return self.renderer.render()


def with_a_class(model, data, renderer, camera_name):
    """A class with one method per step; the color picture is taken twice, the last one leaves the renderer in color mode."""
    photographer = _Photographer(model, data, renderer)
    photographer.aim(camera_name)
    photographer.shoot(depth=False)
    depth = photographer.shoot(depth=True)
    return photographer.shoot(depth=False), depth


def by_number(model, data, renderer, camera_name):
    """Hands the number of the camera, not its name, to update_scene."""
    number = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if number not in range(model.ncam):
        raise ValueError(f"no camera named {camera_name}")
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=number)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    rgb = renderer.render()
    return rgb, depth


def from_a_copy(model, data, renderer, camera_name):
    """Updates a copy of the data and draws that: the caller's data keep every number."""
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) == -1:
        raise ValueError("no such camera")
    current = copy.copy(data)
    mujoco.mj_forward(model, current)
    renderer.update_scene(current, camera=camera_name)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return renderer.render(), depth


ANSWERS = [forward_then_render, only_positions, with_a_context_manager, state_kept_to_the_bit,
           forward_without_sensors, with_a_class, by_number, from_a_copy]
