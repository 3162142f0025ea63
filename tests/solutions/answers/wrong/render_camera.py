"""Wrong answers to render_camera, as strangers wrote them."""
import os
os.environ.setdefault("MUJOCO_GL", "egl")
import cv2
import mujoco
import numpy as np


def _right(model, data, renderer, camera_name):
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) < 0:
        raise ValueError(f"no camera {camera_name}")
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.disable_depth_rendering()
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    try:
        depth = renderer.render()
    finally:
        renderer.disable_depth_rendering()
    return rgb, depth


def w_stale(model, data, renderer, camera_name):
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_steps(model, data, renderer, camera_name):
    mujoco.mj_step(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_steps_and_sets_time_back(model, data, renderer, camera_name):
    time, qpos = data.time, data.qpos.copy()
    mujoco.mj_step(model, data)
    data.time = time
    data.qpos[:] = qpos
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_kinematics_only(model, data, renderer, camera_name):
    mujoco.mj_kinematics(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_no_com_pos(model, data, renderer, camera_name):
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_forward_too_late(model, data, renderer, camera_name):
    renderer.update_scene(data, camera=camera_name)
    mujoco.mj_forward(model, data)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_left_in_depth_mode(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.disable_depth_rendering()
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    return rgb, depth


def w_depth_argument(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering(True)
    depth = renderer.render()
    renderer.enable_depth_rendering(False)
    return rgb, depth


def w_normalized_depth(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    depth -= depth.min()
    depth /= depth.max()
    return rgb, depth


def w_bgr(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = cv2.cvtColor(renderer.render(), cv2.COLOR_RGB2BGR)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_depth_first(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    rgb = renderer.render()
    return depth, rgb


def w_always_head_camera(model, data, renderer, camera_name="head_camera"):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera="head_camera")
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_minus_one_is_free_camera(model, data, renderer, camera_name):
    cam_id = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=cam_id)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_key_error(model, data, renderer, camera_name):
    cam = model.camera(camera_name)
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=cam.id)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_none_for_missing(model, data, renderer, camera_name):
    try:
        mujoco.mj_forward(model, data)
        renderer.update_scene(data, camera=camera_name)
    except ValueError:
        print("camera not found:", camera_name)
        return None, None
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_zero_id_is_missing(model, data, renderer, camera_name):
    cam_id = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if cam_id <= 0:
        raise ValueError(f"no camera {camera_name}")
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=cam_id)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_ray_length(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    h, w = depth.shape
    f = h / 2 / np.tan(np.deg2rad(model.camera(camera_name).fovy[0]) / 2)
    v, u = np.mgrid[:h, :w]
    x, y = (u - (w - 1) / 2) / f, (v - (h - 1) / 2) / f
    return rgb, (depth * np.sqrt(1 + x**2 + y**2)).astype(np.float32)


def w_far_becomes_nan(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    far = model.vis.map.zfar * model.stat.extent
    depth[depth > 0.99 * far] = np.nan
    return rgb, depth


def w_clipped_at_ten(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = np.clip(renderer.render(), 0.01, 10.0)
    renderer.disable_depth_rendering()
    return rgb, depth


def w_converts_meters_again(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    raw = renderer.render()
    renderer.disable_depth_rendering()
    near = model.vis.map.znear * model.stat.extent
    far = model.vis.map.zfar * model.stat.extent
    d = np.clip(raw, 0, 1)
    return rgb, (near * far / (far - d * (far - near))).astype(np.float32)


def w_upside_down(model, data, renderer, camera_name):
    # OpenGL counts rows from the bottom
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = np.flipud(renderer.render())
    renderer.enable_depth_rendering()
    depth = np.flipud(renderer.render())
    renderer.disable_depth_rendering()
    return rgb, depth


def w_resets_to_keyframe(model, data, renderer, camera_name):
    mujoco.mj_resetData(model, data)
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_copy_without_mocap(model, data, renderer, camera_name):
    # work on a copy, so that the state cannot change
    copy = mujoco.MjData(model)
    copy.qpos[:] = data.qpos
    mujoco.mj_forward(model, copy)
    renderer.update_scene(copy, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


def w_millimeters(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, np.clip(1000 * depth, 0, 65535).astype(np.uint16)


def w_own_renderer(model, data, renderer, camera_name):
    if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name) < 0:
        raise ValueError("no such camera")
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, 480, 640) as r:
        r.update_scene(data, camera=camera_name)
        rgb = r.render()
        r.enable_depth_rendering()
        depth = r.render()
    return rgb, depth


def w_cached(model, data, renderer, camera_name, _cache={}):
    if camera_name not in _cache:
        mujoco.mj_forward(model, data)
        renderer.update_scene(data, camera=camera_name)
        rgb = renderer.render()
        renderer.enable_depth_rendering()
        depth = renderer.render()
        renderer.disable_depth_rendering()
        _cache[camera_name] = rgb, depth
    return _cache[camera_name]


def w_buffer_shape_swapped(model, data, renderer, camera_name):
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    rgb = np.zeros((renderer.width, renderer.height, 3), np.uint8)
    renderer.render(out=rgb)
    depth = np.zeros((renderer.width, renderer.height), np.float32)
    renderer.enable_depth_rendering()
    renderer.render(out=depth)
    renderer.disable_depth_rendering()
    return rgb, depth


def w_depth_only_updated(model, data, renderer, camera_name):
    renderer.update_scene(data, camera=camera_name)
    rgb = renderer.render()
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return rgb, depth


WRONG = [
    (w_stale, "positions are not brought up to date; a joint moved after the last mj_forward"),
    (w_steps, "mj_step instead of mj_forward: time passes and the state changes; every input"),
    (w_steps_and_sets_time_back, "steps, then restores only time and qpos: velocities change; a joint under gravity or moving"),
    (w_kinematics_only, "mj_kinematics alone leaves cameras and lights where they were; a camera on a moved body"),
    (w_no_com_pos, "without mj_comPos, cameras that follow a center of mass are stale; targetbodycom or trackcom cameras"),
    (w_forward_too_late, "mj_forward after update_scene, so the picture shows the old pose; a joint moved before the call"),
    (w_left_in_depth_mode, "renderer is left in depth mode; every input"),
    (w_depth_argument, "enable_depth_rendering(True) of another version raises TypeError; every input"),
    (w_normalized_depth, "depth stretched to 0..1, not meters; every input"),
    (w_bgr, "color picture in BGR; every picture with color"),
    (w_depth_first, "return order swapped; every input"),
    (w_always_head_camera, "camera name is ignored; another camera, or a name the model lacks"),
    (w_minus_one_is_free_camera, "a missing camera gives id -1, which the renderer takes for the free camera: no error; unknown name"),
    (w_key_error, "KeyError instead of ValueError; unknown name"),
    (w_none_for_missing, "swallows the error and answers None; unknown name"),
    (w_zero_id_is_missing, "takes id 0 for missing; the first camera of the model"),
    (w_ray_length, "length of the ray instead of depth along the axis; every input, most in the corners"),
    (w_far_becomes_nan, "pixels that see nothing are NaN instead of the far plane; a picture with sky"),
    (w_clipped_at_ten, "depth is clipped to 10 m; far plane beyond 10 m"),
    (w_converts_meters_again, "treats the renderer's meters as window depth; every input"),
    (w_upside_down, "turns the pictures over, which the Renderer has done already; every input that is not symmetric"),
    (w_resets_to_keyframe, "resets the data first; any qpos other than the default"),
    (w_copy_without_mocap, "draws a copy that has qpos but not the mocap poses; a moved mocap body"),
    (w_millimeters, "uint16 millimeters instead of float32 meters; every input"),
    (w_own_renderer, "ignores the renderer that was given: picture is always 640 x 480; any other size"),
    (w_cached, "keeps pictures per camera name and never draws again; second call after the joints moved"),
    (w_buffer_shape_swapped, "buffers of shape (W, H): ValueError; pictures that are not square"),
    (w_depth_only_updated, "color is drawn before the update, depth after; a joint moved before the call"),
]

_XML = """<mujoco><option gravity='0 0 -9.81'/><statistic extent='1' center='0 0 0.5'/>
<visual><map znear='0.05' zfar='15'/></visual>
<worldbody><light pos='0 -1 3'/>
<geom type='plane' size='3 3 .1' rgba='.5 .6 .4 1'/>
<geom type='box' size='.2 .1 .3' pos='0.3 1.5 .3' rgba='1 0 0 1'/>
<geom type='sphere' size='.2' pos='-.6 1 .5' rgba='.1 .2 1 1'/>
<body name='head' pos='0 -1 .6'><joint name='pan' type='hinge' axis='0 1 .4'/><geom type='sphere' size='.05' pos='.2 0 0' mass='1'/>
 <camera name='head_camera' pos='0 .2 0.1' xyaxes='1 0 0 0 .1 1' fovy='50'/></body>
<body name='thing' pos='.4 0 .6'><joint type='slide' axis='1 0 0'/><geom type='box' size='.1 .1 .1' rgba='0 1 0 1'/>
<body pos='0 0 .3'><joint type='slide' axis='0 0 1'/><geom type='sphere' size='.08' rgba='1 1 0 1' mass='3'/></body></body>
<body name='target' mocap='true' pos='-.2 .6 .8'><geom type='sphere' size='.1' rgba='1 0 1 1'/></body>
<camera name='overview' mode='targetbodycom' target='thing' pos='-1 -1.5 1.5' fovy='60'/>
</worldbody></mujoco>"""
_M = None


def _cases():
    global _M
    if _M is None:
        m = mujoco.MjModel.from_xml_string(_XML)
        _M = m, mujoco.Renderer(m, 36, 52)
    m, r = _M

    def make(name, moved=True, mocap=False):
        def case():
            d = mujoco.MjData(m)
            mujoco.mj_forward(m, d)
            if moved:
                d.qpos[:] = [0.15, -0.4, 0.2]
                d.qvel[:] = [0.5, 0, 0]
            if mocap:
                d.mocap_pos[0] = [0.2, 0.5, 0.6]
            r.disable_depth_rendering()
            return m, d, r, name
        return case
    return [make("head_camera", False), make("overview", False), make("head_camera"), make("overview"),
            make("head_camera", True, True), make("nope"), make("head_camera", False)]


def _same(a, b):
    try:
        (c, z), (c2, z2) = a, b
        return (c.dtype == c2.dtype and z.dtype == z2.dtype and c.shape == c2.shape and z.shape == z2.shape
                and np.abs(c.astype(int) - c2).max() <= 2 and np.allclose(z, z2, atol=1e-3, equal_nan=True))
    except Exception:
        return False


def _post(args, result):
    if args[2].render().ndim != 3:
        args[2].disable_depth_rendering()
        return "depth mode"
