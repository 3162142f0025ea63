"""Right answers to get_camera_intrinsics, written in ways that the card does not contain."""

from typing import Any

import mujoco
import numpy as np


def intrinsics_by_diagonal(fov_y: float, width: int, height: int) -> np.ndarray:
    K = np.eye(3, dtype=np.float32)
    K[0, 0] = K[1, 1] = height / (2 * np.tan(fov_y / 2))
    K[:2, 2] = (width - 1) / 2, (height - 1) / 2
    return K


def camera_by_lookup(
    model: mujoco.MjModel, camera_name: str, width: int, height: int
) -> tuple[np.ndarray, float]:
    names = [model.camera(number).name for number in range(model.ncam)]
    camera = names.index(camera_name)  # ValueError for an unknown name
    fov_y = np.radians(model.cam_fovy[camera])
    K = intrinsics_by_diagonal(fov_y, width, height).astype(np.float64)
    sensor = model.cam_sensorsize[camera]
    if sensor.any():
        focal, shift = np.split(model.cam_intrinsic[camera], 2)
        scale = np.array([width, height]) / sensor
        K[[0, 1], [0, 1]] = focal * scale
        K[:2, 2] -= shift * scale
        top, bottom = (sensor[1] / 2 - shift[1]), (-sensor[1] / 2 - shift[1])
        fov_y = np.arctan2(top, focal[1]) - np.arctan2(bottom, focal[1])
    return K, fov_y


def camera_in_single_precision(
    model: mujoco.MjModel, camera_name: str, width: int, height: int
) -> tuple[np.ndarray, np.float32]:
    K, fov_y = camera_by_lookup(model, camera_name, width, height)
    return K.astype(np.float32), np.float32(fov_y)


def camera_as_lists(model: mujoco.MjModel, camera_name: str, width: int, height: int) -> list[Any]:
    K, fov_y = camera_by_lookup(model, camera_name, width, height)
    return [K.tolist(), np.array(fov_y)]


VARIANTS = [camera_by_lookup, camera_in_single_precision, camera_as_lists]
