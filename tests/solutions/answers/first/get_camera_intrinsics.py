"""Right answers to get_camera_intrinsics, as strangers wrote them."""
import math

import mujoco
import numpy as np


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


def angle_between_the_edges(model, camera_name, width, height):
    """As the first answer, but fov_y of a sensor camera is the true angle between top and bottom edge, also where the principal point is off the middle."""
    K, fov_y = step_by_step(model, camera_name, width, height)
    top, bottom = K[1, 2] + 0.5, height - 0.5 - K[1, 2]
    return K, float(np.arctan2(top, K[1, 1]) + np.arctan2(bottom, K[1, 1]))


ANSWERS = [angle_between_the_edges]
