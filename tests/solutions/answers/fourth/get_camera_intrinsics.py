"""Right answers to get_camera_intrinsics, as strangers wrote them."""
import math
from typing import Tuple

import mujoco
import numpy as np


# 1. as in the book, mj_name2id
def f1(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i < 0:
        raise ValueError(f"no camera {camera_name!r}")
    sensor = model.cam_sensorsize[i]
    if sensor[0] > 0 and sensor[1] > 0:
        fx = model.cam_intrinsic[i][0] / sensor[0] * width
        fy = model.cam_intrinsic[i][1] / sensor[1] * height
        cx = (width - 1) / 2 - model.cam_intrinsic[i][2] / sensor[0] * width
        cy = (height - 1) / 2 - model.cam_intrinsic[i][3] / sensor[1] * height
    else:
        fx = fy = height / 2 / np.tan(np.radians(model.cam_fovy[i]) / 2)
        cx, cy = (width - 1) / 2, (height - 1) / 2
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    fov_y = np.arctan((cy + 0.5) / fy) + np.arctan((height - 0.5 - cy) / fy)
    return K, float(fov_y)


# 2. model.camera(name), KeyError turned into ValueError
def f2(model, camera_name, width, height):
    try:
        camera = model.camera(camera_name)
    except KeyError as error:
        raise ValueError(str(error)) from error
    size = np.array([width, height], dtype=float)
    K = np.identity(3)
    K[:2, 2] = (size - 1) / 2
    sensorsize = model.cam_sensorsize[camera.id]
    if np.any(sensorsize):
        focal, principal = np.split(model.cam_intrinsic[camera.id].astype(np.float64), 2)
        scale = size / sensorsize
        K[[0, 1], [0, 1]] = focal * scale
        K[:2, 2] -= principal * scale
        upper, lower = [math.atan2(edge, K[1, 1]) for edge in (-0.5 - K[1, 2], height - 0.5 - K[1, 2])]
        return K, lower - upper
    fov_y = math.radians(camera.fovy[0])
    K[0, 0] = K[1, 1] = height / (2 * math.tan(fov_y / 2))
    return K, fov_y


# 3. loop over names
def f3(model, camera_name, width, height):
    found = None
    for i in range(model.ncam):
        if camera_name != "" and model.camera(i).name == camera_name:
            found = i
    if found is None:
        raise ValueError("no such camera: " + str(camera_name))
    sx, sy = (float(s) for s in model.cam_sensorsize[found])
    px, py, ox, oy = (float(s) for s in model.cam_intrinsic[found])
    cx = (width - 1) / 2
    cy = (height - 1) / 2
    if sy == 0:
        fov_y = model.cam_fovy[found] * np.pi / 180
        f = 0.5 * height / np.tan(fov_y / 2)
        return np.array([[f, 0, cx], [0, f, cy], [0, 0, 1]]), fov_y
    # angle in the lengths of the sensor
    fov_y = math.atan((sy / 2 - oy) / py) + math.atan((sy / 2 + oy) / py)
    K = np.array([[px * width / sx, 0, cx - ox * width / sx],
                  [0, py * height / sy, cy - oy * height / sy],
                  [0, 0, 1]])
    return K, fov_y


# 4. game developer: the frustum
def _frustum(model, i, aspect):
    sx, sy = map(float, model.cam_sensorsize[i])
    if sx > 0:
        fx, fy, ox, oy = map(float, model.cam_intrinsic[i])
        return (-(sx / 2 - ox) / fx, (sx / 2 + ox) / fx, -(sy / 2 - oy) / fy, (sy / 2 + oy) / fy)
    t = math.tan(math.radians(float(model.cam_fovy[i])) / 2)
    return -t * aspect, t * aspect, -t, t


def f4(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA.value, str(camera_name))
    if i == -1:
        raise ValueError("unknown camera")
    left, right, top, bottom = _frustum(model, i, width / height)
    fx, fy = width / (right - left), height / (bottom - top)
    K = np.array([[fx, 0, -left * fx - 0.5], [0, fy, -top * fy - 0.5], [0, 0, 1.0]])
    return K, math.atan(bottom) - math.atan(top)


# 5. angle between the two rays by their dot product
def f5(model, camera_name, width, height):
    names = [model.cam(i).name for i in range(model.ncam)]
    names = [name for name in names if name]
    if camera_name not in names:
        raise ValueError(f"{camera_name} not in {names}")
    cam = model.cam(camera_name)
    sensorsize, intrinsic = model.cam_sensorsize[cam.id], model.cam_intrinsic[cam.id]
    K = np.array([[0, 0, (width - 1) / 2], [0, 0, (height - 1) / 2], [0, 0, 1.0]])
    if (sensorsize > 0).all():
        K[0, 0], K[1, 1] = intrinsic[:2] / sensorsize * [width, height]
        K[:2, 2] -= intrinsic[2:] / sensorsize * np.array([width, height])
    else:
        K[0, 0] = K[1, 1] = height / 2 / np.tan(np.deg2rad(cam.fovy[0]) / 2)
    a = np.linalg.inv(K) @ [K[0, 2], -0.5, 1]
    b = np.linalg.inv(K) @ [K[0, 2], height - 0.5, 1]
    cosine = a @ b / np.linalg.norm(a) / np.linalg.norm(b)
    return K, np.arccos(cosine)


# 6. class
class Lens:
    def __init__(self, fx, fy, ox=0.0, oy=0.0):
        """Everything as a share of the picture."""
        self.fx, self.fy, self.ox, self.oy = fx, fy, ox, oy

    @classmethod
    def from_model(cls, model, i, aspect):
        w, h = model.cam_sensorsize[i].tolist()
        if w and h:
            fx, fy, ox, oy = model.cam_intrinsic[i].tolist()
            return cls(fx / w, fy / h, ox / w, oy / h)
        f = 0.5 / math.tan(math.radians(model.cam_fovy[i].item()) / 2)
        return cls(f / aspect, f)

    def matrix(self, w, h):
        return np.array([[self.fx * w, 0, (0.5 - self.ox) * w - 0.5],
                         [0, self.fy * h, (0.5 - self.oy) * h - 0.5],
                         [0, 0, 1]])

    @property
    def fov_y(self):
        return math.atan((0.5 - self.oy) / self.fy) + math.atan((0.5 + self.oy) / self.fy)


def f6(model: mujoco.MjModel, camera_name: str, width: int, height: int) -> Tuple[np.ndarray, float]:
    if width <= 0 or height <= 0:
        raise ValueError("the picture needs a size")
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i < 0:
        raise ValueError("no such camera")
    lens = Lens.from_model(model, i, width / height)
    return lens.matrix(width, height), lens.fov_y


# 7. float32 results, list pair with numpy scalar
def f7(model, camera_name, width, height):
    try:
        i = model.camera(camera_name).id
    except (KeyError, ValueError):
        raise ValueError("no camera " + camera_name)
    wh = np.float32([width, height])
    if model.cam_sensorsize[i].min() > 0:
        lens = model.cam_intrinsic[i].astype(np.float32).reshape(2, 2) / model.cam_sensorsize[i].astype(np.float32)
        f, c = lens[0] * wh, (wh - 1) / 2 - lens[1] * wh
    else:
        f = np.float32([1, 1]) * wh[1] / 2 / np.tan(np.deg2rad(np.float32(model.cam_fovy[i])) / 2)
        c = (wh - 1) / 2
    K = np.float32([[f[0], 0, c[0]], [0, f[1], c[1]], [0, 0, 1]])
    return K, np.arctan2(c[1] + np.float32(0.5), f[1]) + np.arctan2(wh[1] - np.float32(0.5) - c[1], f[1])


# 8. the horizontal and the vertical in one helper
def _axis(n, sensor, focal, principal):
    share = 1 / sensor
    return focal * share * n, (n - 1) / 2 - principal * share * n


def f8(model, camera_name, width, height):
    lookup = {model.camera(k).name: k for k in range(model.ncam) if model.camera(k).name}
    try:
        k = lookup[camera_name]
    except KeyError:
        raise ValueError(f"there is no camera {camera_name}") from None
    s, p = model.cam_sensorsize[k].copy(), model.cam_intrinsic[k].copy()
    if not s.any():
        half = np.tan(np.deg2rad(model.cam_fovy[k]) / 2)
        s = 2 * half * np.array([width / height, 1])
        p = np.array([1, 1, 0, 0])
    fx, cx = _axis(width, s[0], p[0], p[2])
    fy, cy = _axis(height, s[1], p[1], p[3])
    v = np.array([-0.5, height - 0.5])
    angle = np.diff(np.arctan((v - cy) / fy))[0]
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), angle


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
