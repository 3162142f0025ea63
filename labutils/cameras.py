"""What a camera of a model is: its number, its intrinsic matrix, its pose.

Stands on NumPy alone: a model and its state are only read, by attribute, so that whatever has the
same attributes will do. Taught in: step 2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._constants import FLIP_YZ
from labutils._guards import check_image_size

if TYPE_CHECKING:
    import mujoco

#: ``mjtProjection.mjPROJ_ORTHOGRAPHIC``, written out because MuJoCo is not imported here.
_ORTHOGRAPHIC = 1


def intrinsics_matrix(fov_y: float, width: int, height: int) -> np.ndarray:
    """Build the intrinsic matrix of an ideal camera from its vertical field of view.

    Convention
    ----------
    Integer (u, v) is a pixel's center, so the middle of W pixels is at (W-1)/2. Pixels are
    square: fx = fy.

    Parameters
    ----------
    fov_y : float
        Vertical field of view in radians, between 0 and pi.
    width, height : int
        Picture size in pixels.

    Returns
    -------
    ndarray, float64, shape (3, 3)
        ``[[f, 0, cx], [0, f, cy], [0, 0, 1]]`` in pixels.

    Raises
    ------
    TypeError, ValueError
        If `fov_y` is outside (0, pi) or the size is not positive whole numbers.

    Examples
    --------
    >>> intrinsics_matrix(np.pi / 2, 640, 480)
    array([[240. ,   0. , 319.5],
           [  0. , 240. , 239.5],
           [  0. ,   0. ,   1. ]])

    References
    ----------
    .. [1] Hartley and Zisserman, Multiple View Geometry, section 6.1.
    """
    width, height = check_image_size(width, height)
    if not 0.0 < float(fov_y) < np.pi:
        hint = " (this looks like degrees: use np.deg2rad)" if float(fov_y) >= np.pi else ""
        raise ValueError(f"fov_y: expected radians between 0 and pi, got {fov_y}{hint}")
    # Half the picture height, seen under half the field of view, gives the distance of the image
    # plane. The height is H, not H-1: the outer rows reach half a pixel past their centers.
    focal = 0.5 * height / np.tan(0.5 * float(fov_y))
    return np.array(
        [[focal, 0.0, 0.5 * (width - 1)], [0.0, focal, 0.5 * (height - 1)], [0.0, 0.0, 1.0]]
    )


def get_camera_intrinsics(
    model: mujoco.MjModel, camera_name: str, width: int, height: int
) -> tuple[np.ndarray, float]:
    """Compute the intrinsic matrix of a camera of the model for a picture size.

    Convention
    ----------
    A camera given by ``sensorsize`` is stretched to the picture: its own ``resolution`` plays no
    part, so fx and fy differ wherever the sensor and the picture differ in aspect.

    Parameters
    ----------
    model : mujoco.MjModel
        The compiled scene.
    camera_name : str
        Name of a camera of the model.
    width, height : int
        Picture size in pixels.

    Returns
    -------
    K : ndarray, float64, shape (3, 3)
        Pixels.
    fov_y : float
        Vertical field of view in radians.

    Raises
    ------
    ValueError
        If the model has no such camera, or the camera is orthographic.

    References
    ----------
    .. [1] MuJoCo documentation, XML reference, element ``camera``: ``fovy``, ``sensorsize``,
       ``focal``, ``principal``.
    """
    camera_id = get_camera_id(model, camera_name)
    width, height = check_image_size(width, height)
    if model.cam_projection[camera_id] == _ORTHOGRAPHIC:
        raise ValueError(f"camera {camera_name!r}: expected perspective, got orthographic")
    sensor_x, sensor_y = model.cam_sensorsize[camera_id]
    if sensor_x <= 0 or sensor_y <= 0:
        fov_y = float(np.deg2rad(model.cam_fovy[camera_id]))
        return intrinsics_matrix(fov_y, width, height), fov_y
    focal_x, focal_y, principal_x, principal_y = model.cam_intrinsic[camera_id]
    K = np.array(
        [
            [focal_x / sensor_x * width, 0.0, 0.5 * (width - 1) - principal_x / sensor_x * width],
            [
                0.0,
                focal_y / sensor_y * height,
                0.5 * (height - 1) - principal_y / sensor_y * height,
            ],
            [0.0, 0.0, 1.0],
        ]
    )
    # The angle between the rays through the upper and the lower edge of the sensor. With the
    # principal point off center the two halves differ, so they are added, not doubled.
    upper = np.arctan((0.5 * sensor_y - principal_y) / focal_y)
    lower = np.arctan((0.5 * sensor_y + principal_y) / focal_y)
    return K, float(upper + lower)


def get_camera_pose(model: mujoco.MjModel, data: mujoco.MjData, camera_name: str) -> np.ndarray:
    """Read the pose of a camera as the transform from its OpenCV frame to the world.

    Parameters
    ----------
    model, data, camera_name
        As in `render_camera`; `data` must be forwarded.

    Returns
    -------
    ndarray, float64, shape (4, 4)
        ``T_world_cam``: a point (x right, y down, z forward) in the camera frame, times this,
        is the point in the world frame.

    Raises
    ------
    ValueError
        If the model has no such camera.
    """
    camera_id = get_camera_id(model, camera_name)
    T_world_cam = np.eye(4)
    T_world_cam[:3, :3] = data.cam_xmat[camera_id].reshape(3, 3) @ FLIP_YZ
    T_world_cam[:3, 3] = data.cam_xpos[camera_id]
    return T_world_cam


def get_camera_id(model: mujoco.MjModel, camera_name: str) -> int:
    """Look up a camera by name; raise ValueError with the known names where there is none."""
    try:
        return int(model.camera(str(camera_name)).id)
    except KeyError:
        known = ", ".join(model.camera(i).name for i in range(model.ncam)) or "none at all"
        raise ValueError(f"camera_name: expected one of {known}, got {camera_name!r}") from None
