"""Right answers to get_camera_intrinsics, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import mujoco
import numpy as np


# 1. straightforward
def f1(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i < 0:
        raise ValueError(f"no camera {camera_name!r}")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    sx, sy = model.cam_sensorsize[i]
    if sx > 0 and sy > 0:
        fx, fy, px, py = model.cam_intrinsic[i]
        fx, fy = fx / sx * width, fy / sy * height
        cx, cy = cx - px / sx * width, cy - py / sy * height
        fov = np.arctan((cy + 0.5) / fy) + np.arctan((height - 0.5 - cy) / fy)
    else:
        fov = np.deg2rad(model.cam_fovy[i])
        fx = fy = height / 2 / np.tan(fov / 2)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), fov


# 2. accessors, matrices: sensor lengths to pixels; KeyError translated
def f2(model, camera_name, width, height):
    try:
        cam = model.camera(camera_name)
    except KeyError as error:
        raise ValueError(str(error)) from error
    size = np.array(model.cam_sensorsize[cam.id], dtype=float)
    if not size.any():
        theta = math.radians(float(cam.fovy[0]))
        f = 0.5 * height / math.tan(0.5 * theta)
        return np.array([[f, 0, width / 2 - .5], [0, f, height / 2 - .5], [0, 0, 1.]]), theta
    lens = np.array(model.cam_intrinsic[cam.id], dtype=float)
    metric = np.array([[lens[0], 0, -lens[2]], [0, lens[1], -lens[3]], [0, 0, 1]])
    scale = np.diag([width / size[0], height / size[1], 1])
    shift = np.array([[1, 0, width / 2 - .5], [0, 1, height / 2 - .5], [0, 0, 1]])
    K = shift @ scale @ metric
    edges = np.linalg.solve(K, np.array([[K[0, 2], -0.5, 1], [K[0, 2], height - 0.5, 1]]).T)
    up, down = (edges / np.linalg.norm(edges, axis=0)).T
    return K, float(np.arccos(up @ down))


# 3. everything float32
def f3(model, camera_name, width, height):
    found = [k for k in range(model.ncam) if camera_name and model.cam(k).name == camera_name]
    if not found:
        raise ValueError("unknown camera")
    k = found[0]
    wh = np.array([width, height], np.float32)
    center = (wh - 1) / 2
    sensor = model.cam_sensorsize[k].astype(np.float32)
    if sensor.prod() > 0:
        lens = model.cam_intrinsic[k].astype(np.float32).reshape(2, 2)
        focal, shift = lens / sensor * wh
        center = center - shift
        top = (center[1] + np.float32(.5)) / focal[1]
        bottom = (wh[1] - np.float32(.5) - center[1]) / focal[1]
        fov = np.arctan(top) + np.arctan(bottom)
    else:
        fov = np.radians(np.float32(model.cam_fovy[k]))
        focal = np.repeat(wh[1] / 2 / np.tan(fov / 2), 2)
    K = np.eye(3, dtype=np.float32)
    K[[0, 1], [0, 1]] = focal
    K[:2, 2] = center
    return K, float(fov)


# 4. over-engineered
@dataclass(frozen=True)
class _Intrinsics:
    fx: float
    fy: float
    cx: float
    cy: float
    width: int
    height: int

    @classmethod
    def from_angle(cls, angle, width, height):
        f = height / (2 * math.tan(angle / 2))
        return cls(f, f, (width - 1) / 2, (height - 1) / 2, width, height)

    @classmethod
    def from_sheet(cls, sensor, focal, principal, width, height):
        return cls(focal[0] / sensor[0] * width, focal[1] / sensor[1] * height,
                   (width - 1) / 2 - principal[0] / sensor[0] * width,
                   (height - 1) / 2 - principal[1] / sensor[1] * height, width, height)

    @property
    def K(self):
        return np.array([[self.fx, 0.0, self.cx], [0.0, self.fy, self.cy], [0.0, 0.0, 1.0]])

    @property
    def fov_y(self):
        above = self.cy - -0.5
        below = self.height - 0.5 - self.cy
        return math.atan2(above, self.fy) + math.atan2(below, self.fy)


def _lookup(model, name):
    ids = {model.camera(i).name: i for i in range(model.ncam)}
    ids.pop("", None)
    if name not in ids:
        raise ValueError(f"no camera {name!r}; there are {sorted(ids)}")
    return ids[name]


def f4(model, camera_name, width, height):
    i = _lookup(model, camera_name)
    sensor = model.cam_sensorsize[i].tolist()
    if all(s > 0 for s in sensor):
        fx, fy, px, py = model.cam_intrinsic[i].tolist()
        cam = _Intrinsics.from_sheet(sensor, (fx, fy), (px, py), width, height)
    else:
        cam = _Intrinsics.from_angle(math.radians(model.cam_fovy[i]), width, height)
    return cam.K, cam.fov_y


# 5. undistortPoints for the angle; a list comes back
def f5(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA.value, camera_name)
    if i == -1:
        raise ValueError(camera_name)
    K = cv2.getDefaultNewCameraMatrix(np.eye(3), (width, height), True)
    if model.cam_sensorsize[i, 1] == 0:
        K[0, 0] = K[1, 1] = height / 2 / np.tan(np.deg2rad(model.cam_fovy[i]) / 2)
    else:
        per_meter = np.array([width, height]) / model.cam_sensorsize[i]
        K[0, 0], K[1, 1] = model.cam_intrinsic[i, :2] * per_meter
        K[:2, 2] -= model.cam_intrinsic[i, 2:] * per_meter
    edge = cv2.undistortPoints(np.array([[[0, -.5]], [[0, height - .5]]]), K, None)
    top, bottom = edge[:, 0, 1]
    return K, math.atan(bottom) - math.atan(top)


# 6. frustum in meters on the sensor
def f6(model, camera_name, width, height):
    try:
        cid = model.cam(camera_name).id
    except KeyError:
        raise ValueError(f"camera {camera_name} not found")
    w, h = model.cam_sensorsize[cid]
    if w * h:
        fx, fy, px, py = model.cam_intrinsic[cid]
    else:
        h = 2 * np.tan(np.radians(model.cam_fovy[cid]) / 2)
        w = h * width / height
        fx, fy, px, py = 1.0, 1.0, 0.0, 0.0
    K = np.vstack([[fx * width / w, 0, (width - 1) / 2 - px * width / w],
                   [0, fy * height / h, (height - 1) / 2 - py * height / h],
                   [0, 0, 1]])
    theta = np.arctan2(h / 2 - py, fy) + np.arctan2(h / 2 + py, fy)
    return K, np.float64(theta)


# 7. code golf
def f7(model, camera_name, width, height):
    n, (i,) = np.array([width, height]), [j for j in range(model.ncam) if model.camera(j).name == camera_name != ""] or [None]
    if i is None: raise ValueError(camera_name)
    s, q = model.cam_sensorsize[i], model.cam_intrinsic[i]
    f, c = (q[:2] / s * n, (n - 1) / 2 - q[2:] / s * n) if s.all() else ([height / 2 / np.tan(np.pi * model.cam_fovy[i] / 360)] * 2, (n - 1) / 2)
    return np.c_[np.r_[np.diag(f), [[0, 0]]], [*c, 1]], sum(np.arctan((x + .5) / f[1]) for x in (c[1], height - 1 - c[1]))


# 8. beginner, verbose
def f8(model, camera_name, width, height):
    camera_id = -1
    for number in range(model.ncam):
        name = model.camera(number).name
        if name == camera_name and name != "":
            camera_id = number
    if camera_id == -1:
        raise ValueError("The model has no camera with the name " + str(camera_name))
    K = np.zeros((3, 3))
    K[2][2] = 1
    sensor_width = model.cam_sensorsize[camera_id][0]
    sensor_height = model.cam_sensorsize[camera_id][1]
    middle_x = (width - 1) / 2
    middle_y = (height - 1) / 2
    if sensor_width == 0:
        fov_y = model.cam_fovy[camera_id] * np.pi / 180
        focal = height / 2 / np.tan(fov_y / 2)
        K[0][0] = focal
        K[1][1] = focal
        K[0][2] = middle_x
        K[1][2] = middle_y
    else:
        focal_x, focal_y, principal_x, principal_y = model.cam_intrinsic[camera_id]
        K[0][0] = focal_x / sensor_width * width
        K[1][1] = focal_y / sensor_height * height
        K[0][2] = middle_x - principal_x / sensor_width * width
        K[1][2] = middle_y - principal_y / sensor_height * height
        angle_up = np.arctan((K[1][2] + 0.5) / K[1][1])
        angle_down = np.arctan((height - 0.5 - K[1][2]) / K[1][1])
        fov_y = angle_up + angle_down
    return K, float(fov_y)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
