"""Right answers to get_camera_intrinsics, as strangers wrote them."""
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


def angle_between_the_edges(model, camera_name, width, height):
    """As the first answer, but fov_y of a sensor camera is the true angle between top and bottom edge, also where the principal point is off the middle."""
    K, fov_y = step_by_step(model, camera_name, width, height)
    top, bottom = K[1, 2] + 0.5, height - 0.5 - K[1, 2]
    return K, float(np.arctan2(top, K[1, 1]) + np.arctan2(bottom, K[1, 1]))


# The first gives the angle of a camera that is not shifted, which the statement rules out by now.
ANSWERS = [angle_between_the_edges]
