"""Right answers to render_camera, as strangers wrote them."""
import contextlib
import copy

import mujoco
import numpy as np


# 1. the five calls of the chapter
def render_plain(model, data, renderer, camera_name):
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) < 0:
        raise ValueError(f"no camera {camera_name!r}")
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


# 2. try / finally, any earlier mode switched off first
def render_finally(model, data, renderer, camera_name):
    try:
        camera_id = model.camera(camera_name).id
    except KeyError:
        raise ValueError(f"the model has no camera {camera_name!r}") from None
    mujoco.mj_forward(model, data)
    renderer.disable_segmentation_rendering()
    renderer.disable_depth_rendering()
    renderer.update_scene(data, camera_id)
    rgb = renderer.render().copy()
    try:
        renderer.enable_depth_rendering()
        depth = renderer.render().copy()
    finally:
        renderer.disable_depth_rendering()
    return rgb, depth


# 3. beginner: loops over names
def render_beginner(model, data, renderer, camera_name):
    found = False
    for i in range(model.ncam):
        if model.camera(i).name == camera_name:
            found = True
    if not found:
        raise ValueError("There is no camera with the name " + str(camera_name))
    mujoco.mj_forward(model, data)
    # color
    renderer.disable_depth_rendering()
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    # depth
    renderer.enable_depth_rendering()
    renderer.update_scene(data, camera=camera_name)
    depth = renderer.render()
    # back to color
    renderer.disable_depth_rendering()
    return rgb, depth


# 4. a context manager, depth first
@contextlib.contextmanager
def _depth_mode(renderer):
    renderer.enable_depth_rendering()
    try:
        yield renderer
    finally:
        renderer.disable_depth_rendering()


def render_context(model, data, renderer, camera_name):
    if camera_name not in [model.camera(i).name for i in range(model.ncam)]:
        raise ValueError(camera_name)
    mujoco.mj_fwdPosition(model, data)
    renderer.update_scene(data, camera_name)
    with _depth_mode(renderer) as deep:
        depth = deep.render()
    rgb = renderer.render()
    return rgb, depth


# 5. only positions, MjvCamera, arrays given with out=
def render_mjvcamera(model, data, renderer, camera_name):
    number = mujoco.mj_name2id(model, int(mujoco.mjtObj.mjOBJ_CAMERA), camera_name)
    if number == -1:
        raise ValueError("camera not found")
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    mujoco.mj_flex(model, data)
    mujoco.mj_tendon(model, data)
    camera = mujoco.MjvCamera()
    camera.type = mujoco.mjtCamera.mjCAMERA_FIXED
    camera.fixedcamid = number
    renderer.update_scene(data, camera=camera)
    rgb = np.empty((renderer.height, renderer.width, 3), dtype=np.uint8)
    depth = np.empty((renderer.height, renderer.width), dtype=np.float32)
    renderer.render(out=rgb)
    renderer.enable_depth_rendering()
    renderer.render(out=depth)
    renderer.disable_depth_rendering()
    return rgb, depth


# 6. a copy of the data: what the caller holds stays as it is
def render_copy(model, data, renderer, camera_name):
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) == -1:
        raise ValueError(f"{camera_name} is not a camera of this model")
    mine = copy.copy(data)
    mujoco.mj_forward(model, mine)
    renderer.update_scene(mine, camera=camera_name)
    color = renderer.render()
    with contextlib.ExitStack() as stack:
        stack.callback(renderer.disable_depth_rendering)
        renderer.enable_depth_rendering()
        meters = renderer.render()
    return np.array(color), meters.astype(np.float64)


# 7. Java
class CameraNotFoundError(ValueError):
    pass


class RobotEye:
    def __init__(self, model, data, renderer):
        self._model, self._data, self._renderer = model, data, renderer

    def _id(self, name):
        number = mujoco.mj_name2id(self._model, mujoco.mjtObj.mjOBJ_CAMERA, name)
        if number < 0:
            raise CameraNotFoundError(f"no camera named {name!r}")
        return number

    def look(self, name):
        number = self._id(name)
        mujoco.mj_forward(self._model, self._data)
        self._renderer.update_scene(self._data, camera=number)
        return self._color(), self._depth()

    def _color(self):
        return self._renderer.render()

    def _depth(self):
        self._renderer.enable_depth_rendering()
        try:
            return self._renderer.render()
        finally:
            self._renderer.disable_depth_rendering()


def render_java(model, data, renderer, camera_name):
    return RobotEye(model, data, renderer).look(camera_name)


# 8. a second renderer for the depth, of the same size: the first stays in color mode
def render_second(model, data, renderer, camera_name):
    if camera_name not in {model.camera(i).name for i in range(model.ncam)}:
        raise ValueError(f"no camera {camera_name!r}")
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    second = mujoco.Renderer(model, renderer.height, renderer.width)
    try:
        second.enable_depth_rendering()
        second.update_scene(data, camera=camera_name)
        depth = second.render()
    finally:
        second.close()
    return rgb, depth


# 9. the renderer's own ValueError is enough; a list comes back
def render_own_error(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)      # raises ValueError for unknown names
    pictures = []
    for prepare in (renderer.disable_depth_rendering, renderer.enable_depth_rendering):
        prepare()
        pictures.append(renderer.render())
    renderer.disable_depth_rendering()
    return pictures


ANSWERS = [render_plain, render_finally, render_beginner, render_context, render_mjvcamera,
           render_copy, render_java, render_second, render_own_error]
