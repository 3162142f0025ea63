"""Right answers to get_camera_intrinsics, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import mujoco
import numpy as np


# 1. mj_name2id and the model's arrays
def intrinsics_name2id(model, camera_name, width, height):
    i = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if i < 0:
        raise ValueError(f"no camera {camera_name!r}")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    if model.cam_sensorsize[i].all():
        sx, sy = model.cam_sensorsize[i].astype(float)
        focal_x, focal_y, px, py = model.cam_intrinsic[i].astype(float)
        fx, fy = focal_x / sx * width, focal_y / sy * height
        cx -= px / sx * width
        cy -= py / sy * height
    else:
        fx = fy = height / 2 / math.tan(math.radians(model.cam_fovy[i]) / 2)
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    fov_y = math.atan((cy + 0.5) / fy) + math.atan((height - 0.5 - cy) / fy)
    return K, fov_y


# 2. named access, KeyError turned into ValueError
def intrinsics_named(model, camera_name, width, height):
    try:
        cam = model.camera(camera_name)
    except KeyError as error:
        raise ValueError(str(error)) from error
    size = np.float64(model.cam_sensorsize[cam.id])
    if size[1] > 0:
        scale = np.array([width, height]) / size
        lens = np.float64(model.cam_intrinsic[cam.id])
        f = lens[:2] * scale
        c = (np.array([width, height]) - 1) / 2 - lens[2:] * scale
        top, bottom = (np.array([-0.5, height - 0.5]) - c[1]) / f[1]
        fov_y = float(np.arctan(bottom) - np.arctan(top))
    else:
        fov_y = float(np.deg2rad(cam.fovy[0]))
        f = np.full(2, height / (2 * np.tan(fov_y / 2)))
        c = (np.array([width, height]) - 1) / 2
    K = np.eye(3)
    K[0, 0], K[1, 1] = f
    K[:2, 2] = c
    return K, fov_y


# 3. beginner: loops over the names
def intrinsics_beginner(model, camera_name, width, height):
    number = -1
    for i in range(model.ncam):
        if model.camera(i).name == camera_name:
            number = i
    if number == -1:
        raise ValueError("The model has no camera called " + str(camera_name))
    sensor_width = float(model.cam_sensorsize[number][0])
    sensor_height = float(model.cam_sensorsize[number][1])
    K = np.zeros((3, 3))
    K[2, 2] = 1
    if sensor_width == 0 and sensor_height == 0:
        fov_y = float(model.cam_fovy[number]) * math.pi / 180
        f = (height / 2) / math.tan(fov_y / 2)
        K[0, 0] = f
        K[1, 1] = f
        K[0, 2] = (width - 1) / 2
        K[1, 2] = (height - 1) / 2
        return K, fov_y
    focal_x = float(model.cam_intrinsic[number][0])
    focal_y = float(model.cam_intrinsic[number][1])
    principal_x = float(model.cam_intrinsic[number][2])
    principal_y = float(model.cam_intrinsic[number][3])
    K[0, 0] = focal_x / sensor_width * width
    K[1, 1] = focal_y / sensor_height * height
    K[0, 2] = (width - 1) / 2 - principal_x / sensor_width * width
    K[1, 2] = (height - 1) / 2 - principal_y / sensor_height * height
    # the edges of the sensor, seen from the lens, in meters
    upper = sensor_height / 2 - principal_y
    lower = sensor_height / 2 + principal_y
    fov_y = math.atan(upper / focal_y) + math.atan(lower / focal_y)
    return K, fov_y


# 4. mathematician: angle between two rays K^-1 (cx, -1/2, 1) and K^-1 (cx, H - 1/2, 1)
def intrinsics_rays(model, camera_name, width, height):
    camera_id = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if camera_id == -1:
        raise ValueError(camera_name)
    has_sensor = np.any(model.cam_sensorsize[camera_id] > 0)
    picture = np.array([width, height], dtype=float)
    if has_sensor:
        to_pixels = np.diag(picture / model.cam_sensorsize[camera_id].astype(float))
        f = to_pixels @ model.cam_intrinsic[camera_id, :2]
        shift = to_pixels @ model.cam_intrinsic[camera_id, 2:]
    else:
        f = np.ones(2) * picture[1] / 2 / np.tan(np.radians(model.cam_fovy[camera_id]) / 2)
        shift = np.zeros(2)
    K = np.vstack([np.c_[np.diag(f), (picture - 1) / 2 - shift], [0, 0, 1]])
    up, low = np.linalg.solve(K, np.array([[K[0, 2], K[0, 2]], [-0.5, height - 0.5], [1, 1]])).T
    fov_y = math.atan2(np.linalg.norm(np.cross(up, low)), up @ low)
    return K, fov_y


# 5. Java: two kinds of camera
class CameraModel:
    @staticmethod
    def of(model, name):
        names = [model.camera(i).name for i in range(model.ncam)]
        if name not in names:
            raise ValueError(f"unknown camera {name!r}; there are {names}")
        i = names.index(name)
        if float(model.cam_sensorsize[i, 1]) > 0.0:
            return SensorCamera(*map(float, model.cam_sensorsize[i]),
                                *map(float, model.cam_intrinsic[i]))
        return AngleCamera(math.radians(float(model.cam_fovy[i])))


@dataclass
class AngleCamera(CameraModel):
    fov_y: float

    def matrix(self, width, height):
        f = height * 0.5 * math.tan((math.pi - self.fov_y) / 2)
        return np.array([[f, 0, 0.5 * (width - 1)], [0, f, 0.5 * (height - 1)], [0, 0, 1.0]])


@dataclass
class SensorCamera(CameraModel):
    sensor_x: float
    sensor_y: float
    focal_x: float
    focal_y: float
    principal_x: float
    principal_y: float

    @property
    def fov_y(self):
        half = self.sensor_y / 2
        return (math.atan2(half - self.principal_y, self.focal_y)
                + math.atan2(half + self.principal_y, self.focal_y))

    def matrix(self, width, height):
        kx, ky = width / self.sensor_x, height / self.sensor_y
        return np.array([[self.focal_x * kx, 0, (width - 1) / 2 - self.principal_x * kx],
                         [0, self.focal_y * ky, (height - 1) / 2 - self.principal_y * ky],
                         [0, 0, 1]])


def intrinsics_java(model, camera_name, width, height):
    camera = CameraModel.of(model, camera_name)
    return camera.matrix(width, height), camera.fov_y


# 6. model.cam, another route to the same camera; one frustum for both kinds
def intrinsics_frustum(model, camera_name, width, height):
    try:
        i = model.cam(camera_name).id
    except (KeyError, IndexError):
        raise ValueError(f"no camera {camera_name}") from None
    sx, sy = (float(s) for s in model.cam_sensorsize[i])
    if sx and sy:
        fx, fy, px, py = (float(a) for a in model.cam_intrinsic[i])
        left, right = -(sx / 2 - px) / fx, (sx / 2 + px) / fx
        top, bottom = -(sy / 2 - py) / fy, (sy / 2 + py) / fy
    else:
        bottom = np.tan(np.pi * model.cam_fovy[i] / 360)
        right = bottom * width / height
        left, top = -right, -bottom
    # columns -1/2 .. W - 1/2 show left .. right, rows likewise
    fx, fy = width / (right - left), height / (bottom - top)
    K = np.array([[fx, 0, -0.5 - fx * left], [0, fy, -0.5 - fy * top], [0, 0, 1]])
    return K, np.arctan(bottom) - np.arctan(top)


# 7. OpenCV: undistort the two edge pixels; list back
def intrinsics_opencv(model, camera_name, width, height):
    table = {model.camera(i).name: i for i in range(model.ncam)}
    if camera_name not in table:
        raise ValueError("no such camera")
    i = table[camera_name]
    K = np.diag([1.0, 1.0, 1.0])
    K[:2, 2] = (width - 1) / 2, (height - 1) / 2
    if np.count_nonzero(model.cam_sensorsize[i]) == 2:
        for axis, pixels in enumerate((width, height)):
            per_meter = pixels / float(model.cam_sensorsize[i, axis])
            K[axis, axis] = float(model.cam_intrinsic[i, axis]) * per_meter
            K[axis, 2] -= float(model.cam_intrinsic[i, axis + 2]) * per_meter
    else:
        K[0, 0] = K[1, 1] = height / (2.0 * np.tan(np.deg2rad(model.cam_fovy[i] / 2)))
    edges = np.array([[[K[0, 2], -0.5]], [[K[0, 2], height - 0.5]]])
    rays = cv2.undistortPoints(edges, K, None).reshape(2, 2)
    a, b = np.arctan(rays[:, 1])
    return [K, float(b - a)]


# 8. Matlab: one formula, zeros where there is no sensor; float32 K
def intrinsics_matlab(model, camera_name, width, height):
    id_ = mujoco.mj_name2id(model, int(mujoco.mjtObj.mjOBJ_CAMERA), camera_name)
    if id_ < 0:
        raise ValueError("camera not found: %s" % camera_name)
    wh = np.float64([width, height])
    S = np.float64(model.cam_sensorsize[id_])
    I = np.float64(model.cam_intrinsic[id_])
    f_fov = wh[1] / 2 / np.tan(np.deg2rad(model.cam_fovy[id_]) / 2)
    S1 = np.where(S > 0, S, 1.0)
    f = np.where(S > 0, I[:2] / S1 * wh, f_fov)
    c = (wh - 1) / 2 - np.where(S > 0, I[2:] / S1 * wh, 0.0)
    K = np.float32([[f[0], 0, c[0]], [0, f[1], c[1]], [0, 0, 1]])
    return K, np.arctan2(c[1] + 0.5, f[1]) + np.arctan2(wh[1] - 0.5 - c[1], f[1])


ANSWERS = [intrinsics_name2id, intrinsics_named, intrinsics_beginner, intrinsics_rays,
           intrinsics_java, intrinsics_frustum, intrinsics_opencv, intrinsics_matlab]
