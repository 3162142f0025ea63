"""Right answers to get_camera_intrinsics, as strangers wrote them."""
import math

import mujoco
import numpy as np


def step_by_step(model, camera_name, width, height):
    """mj_name2id, two branches; for a sensor camera the angle comes from focal length and sensor size."""
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i < 0:
        raise ValueError(f"no camera {camera_name!r}")
    if model.cam_projection[i] == mujoco.mjtProjection.mjPROJ_ORTHOGRAPHIC:
        raise ValueError(f"camera {camera_name!r} is orthographic")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sensor = model.cam_sensorsize[i].astype(np.float64)
    if sensor[0] > 0 and sensor[1] > 0:
        focal_x, focal_y, principal_x, principal_y = model.cam_intrinsic[i].astype(np.float64)
        fx, fy = focal_x / sensor[0] * width, focal_y / sensor[1] * height
        cx -= principal_x / sensor[0] * width
        cy -= principal_y / sensor[1] * height
        fov_y = 2 * np.arctan(sensor[1] / (2 * focal_y))
    else:
        fov_y = np.deg2rad(model.cam_fovy[i])
        fx = fy = (height / 2) / np.tan(fov_y / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]], dtype=np.float64), float(fov_y)


def compiled_angle(model, camera_name, width, height):
    """model.camera(name) and its view of fovy; fov_y is always the compiled cam_fovy, also for a sensor camera."""
    try:
        cam = model.camera(camera_name)
    except KeyError:
        raise ValueError(f"unknown camera {camera_name}") from None
    if int(model.cam_projection[cam.id]) != 0:
        raise ValueError("orthographic cameras have no intrinsic matrix")
    fov_y = math.radians(float(cam.fovy[0]))
    K = np.eye(3)
    size = np.array([width, height], dtype=float)
    K[:2, 2] = (size - 1) / 2
    sensor = np.array(model.cam_sensorsize[cam.id], dtype=float)
    if np.any(sensor):
        lens = np.array(model.cam_intrinsic[cam.id], dtype=float)
        K[[0, 1], [0, 1]] = lens[:2] / sensor * size
        K[:2, 2] -= lens[2:] / sensor * size
    else:
        K[[0, 1], [0, 1]] = height / (2 * math.tan(fov_y / 2))
    return K, fov_y


def matrix_chain(model, camera_name, width, height):
    """Camera frame to sensor plane in meters to pixels: a product of three matrices; the angle from K itself."""
    names = [model.camera(k).name for k in range(model.ncam)]
    if not camera_name or camera_name not in names:
        raise ValueError(f"{camera_name!r} is none of {names}")
    i = names.index(camera_name)
    if model.cam_projection[i]:
        raise ValueError("orthographic")
    sensor = [float(s) for s in model.cam_sensorsize[i]]
    if sensor[0]:
        f1, f2, p1, p2 = (float(k) for k in model.cam_intrinsic[i])
    else:  # a virtual sensor one meter behind the pinhole
        tall = 2 * math.tan(math.radians(model.cam_fovy[i]) / 2)
        sensor = [tall * width / height, tall]
        f1 = f2 = 1.0
        p1 = p2 = 0.0
    lens = np.diag([f1, f2, 1.0])
    shift = np.array([[1, 0, sensor[0] / 2 - p1], [0, 1, sensor[1] / 2 - p2], [0, 0, 1.0]])
    to_pixels = np.array([[width / sensor[0], 0, -0.5], [0, height / sensor[1], -0.5], [0, 0, 1]])
    K = to_pixels @ shift @ lens
    return K, 2 * math.atan2(height / 2, K[1, 1])


def plain_python(model, camera_name, width, height):
    """A loop over the cameras with mj_id2name, math only, nested list; the angle is a NumPy float64."""
    number = None
    for k in range(model.ncam):
        name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_CAMERA, k)
        if name and name == camera_name:
            number = k
    if number is None:
        raise ValueError("the model has no such camera")
    if model.cam_projection[number] == 1:
        raise ValueError("the camera is orthographic")
    sw, sh = float(model.cam_sensorsize[number, 0]), float(model.cam_sensorsize[number, 1])
    K = [[0.0] * 3 for _ in range(3)]
    K[2][2] = 1.0
    if sw * sh != 0:
        fl = [float(x) for x in model.cam_intrinsic[number]]
        K[0][0], K[0][2] = width * fl[0] / sw, (width - 1) / 2 - width * fl[2] / sw
        K[1][1], K[1][2] = height * fl[1] / sh, (height - 1) / 2 - height * fl[3] / sh
    else:
        half = math.radians(float(model.cam_fovy[number])) / 2
        K[0][0] = K[1][1] = height / 2 * math.cos(half) / math.sin(half)
        K[0][2], K[1][2] = (width - 1) / 2, (height - 1) / 2
    return np.array(K), np.float64(2.0) * np.arctan(height / 2 / K[1][1])


class _Lens:
    """What one camera says about itself, independent of a picture."""

    def __init__(self, model, name):
        k = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, str(name))
        if k == -1:
            raise ValueError(f"The model has no camera {name!r}.")
        if model.cam_projection[k] == mujoco.mjtProjection.mjPROJ_ORTHOGRAPHIC.value:
            raise ValueError(f"Camera {name!r} is orthographic.")
        self.sensor = np.asarray(model.cam_sensorsize[k], dtype=np.float64)
        self.lens = np.asarray(model.cam_intrinsic[k], dtype=np.float64)
        self.given_by_sensor = bool(self.sensor.all())
        self.tangent = (self.sensor[1] / 2 / self.lens[1] if self.given_by_sensor
                        else np.tan(np.deg2rad(model.cam_fovy[k]) / 2))

    def K(self, size):
        size = np.asarray(size, dtype=np.float64)
        f = np.full(2, size[1] / 2 / self.tangent)
        c = (size - 1) / 2
        if self.given_by_sensor:
            f[0] = self.lens[0] * (size[0] / self.sensor[0])
            c = c - self.lens[2:] * (size / self.sensor)
        return np.vstack([np.column_stack([np.diag(f), c]), [0, 0, 1]])


def with_a_class(model, camera_name, width, height):
    """A class for the lens, checks of the picture size that nobody asked for."""
    if width <= 0 or height <= 0:
        raise ValueError("the picture must have a size")
    lens = _Lens(model, camera_name)
    return lens.K((width, height)), float(2 * np.arctan(lens.tangent))


def by_corners(model, camera_name, width, height):
    """Solves for K from the directions of the picture's four edges (-1/2 and W-1/2)."""
    known = {model.camera(k).name: k for k in range(model.ncam)}
    known.pop("", None)
    if camera_name not in known:
        raise ValueError(f"no camera called {camera_name}")
    k = known[camera_name]
    if model.cam_projection[k] != mujoco.mjtProjection.mjPROJ_PERSPECTIVE:
        raise ValueError("no perspective camera")
    s, lens = model.cam_sensorsize[k].astype(float), model.cam_intrinsic[k].astype(float)
    if s.any():
        low = (-s / 2 + lens[2:]) / lens[:2]
        high = (s / 2 + lens[2:]) / lens[:2]
        angle = 2 * math.atan(s[1] / lens[1] / 2)
    else:
        angle = math.pi / 180 * float(model.cam_fovy[k])
        high = math.tan(angle / 2) * np.array([width / height, 1.0])
        low = -high
    K = np.eye(3)
    for axis, n in enumerate((width, height)):
        # slope * f + c is -1/2 at the low edge and n - 1/2 at the high edge
        f, c = np.linalg.solve([[low[axis], 1], [high[axis], 1]], [-0.5, n - 0.5])
        K[axis, axis], K[axis, 2] = f, c
    return K, angle


def angle_between_the_edges(model, camera_name, width, height):
    """As the first answer, but fov_y of a sensor camera is the true angle between top and bottom edge, also where the principal point is off the middle."""
    K, fov_y = step_by_step(model, camera_name, width, height)
    top, bottom = K[1, 2] + 0.5, height - 0.5 - K[1, 2]
    return K, float(np.arctan2(top, K[1, 1]) + np.arctan2(bottom, K[1, 1]))


# The others give the angle of a camera that is not shifted, which the statement rules out by now.
ANSWERS = [angle_between_the_edges]
