"""What a camera of a model is: its number, its intrinsic matrix, its pose.

Stands on NumPy alone: a model and its state are only read, by attribute, so that whatever has the
same attributes will do. Taught in: step 2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias, Union

import numpy as np

from labutils._constants import FLIP_YZ
from labutils._guards import check_image_size
from labutils.free_camera import describe, get_free_pose, is_free, is_viewer_camera

if TYPE_CHECKING:
    import mujoco

#: What names a camera: its name, its number, or a viewer's camera. (As text, because MuJoCo is
#: not imported here.)
Camera: TypeAlias = Union[str, int, "mujoco.MjvCamera"]

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
    model: mujoco.MjModel, camera_name: Camera, width: int, height: int
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
    camera_name : str, int or mujoco.MjvCamera
        Name or number of a camera of the model, or the free camera of a viewer.
    width, height : int
        Picture size in pixels.

    Returns
    -------
    K : ndarray, float64, shape (3, 3)
        Pixels.
    fov_y : float
        Vertical field of view in radians: the angle between the rays through the upper and the
        lower edge of the picture.

    Raises
    ------
    ValueError
        If the model has no such camera, or the camera is orthographic.

    References
    ----------
    .. [1] MuJoCo documentation, XML reference, element ``camera``: ``fovy``, ``sensorsize``,
       ``focal``, ``principal``.
    """
    width, height = check_image_size(width, height)
    if is_free(camera_name):
        _refuse_orthographic(camera_name, is_orthographic=bool(camera_name.orthographic))
        fov_y = float(np.deg2rad(model.vis.global_.fovy))
        return intrinsics_matrix(fov_y, width, height), fov_y
    camera_id = get_camera_id(model, camera_name)
    _refuse_orthographic(
        camera_name, is_orthographic=model.cam_projection[camera_id] == _ORTHOGRAPHIC
    )
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


def _refuse_orthographic(camera: Camera, *, is_orthographic: bool) -> None:
    if is_orthographic:
        raise ValueError(
            f"camera {describe(camera)}: expected perspective, got orthographic, whose rays are "
            "parallel: no K describes it. render_camera and its depth work; for a K, give the "
            "camera perspective and a fovy in degrees"
        )


def get_camera_pose(model: mujoco.MjModel, data: mujoco.MjData, camera_name: Camera) -> np.ndarray:
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
    TypeError, ValueError
        If the model has no such camera.
    """
    if is_free(camera_name):
        return get_free_pose(data, camera_name)
    camera_id = get_camera_id(model, camera_name)
    T_world_cam = np.eye(4)
    T_world_cam[:3, :3] = data.cam_xmat[camera_id].reshape(3, 3) @ FLIP_YZ
    T_world_cam[:3, 3] = data.cam_xpos[camera_id]
    return T_world_cam


def get_camera_id(model: mujoco.MjModel, camera_name: Camera) -> int:
    """Look up the number of a camera of the model.

    Parameters
    ----------
    model : mujoco.MjModel
        The compiled scene.
    camera_name : str, int or mujoco.MjvCamera
        A name, a number (which is verified), or a viewer's camera of the type ``mjCAMERA_FIXED``.

    Returns
    -------
    int
        0 to ``model.ncam - 1``.

    Raises
    ------
    TypeError
        If `camera_name` is none of these.
    ValueError
        If the model has no such camera; the message says which it has.
    """
    if is_viewer_camera(camera_name):
        if is_free(camera_name):
            raise ValueError("camera_name: expected a camera of the model, got the free camera")
        camera_name = camera_name.fixedcamid
    if isinstance(camera_name, str):
        try:
            return int(model.camera(str(camera_name)).id)
        except KeyError:
            raise _make_error(model, repr(str(camera_name))) from None
    if isinstance(camera_name, bool) or not isinstance(camera_name, int | np.integer):
        raise TypeError(
            "camera_name: expected a name, a number or an MjvCamera, got "
            f"{type(camera_name).__name__} {camera_name!r:.60}"
        )
    if not 0 <= camera_name < model.ncam:
        raise _make_error(model, str(camera_name))
    return int(camera_name)


def _make_error(model: mujoco.MjModel, got: str) -> ValueError:
    """Say which cameras there are, those without a name too."""
    names = [model.camera(number).name for number in range(model.ncam)]
    known = ", ".join(name for name in names if name)
    if not names:
        expected = "one of none at all: the model has no camera; place an mujoco.MjvCamera"
    elif all(names) and not got.lstrip("-").isdigit():
        expected = f"one of {known}"
    else:
        numbers_known = f"a number from 0 to {len(names) - 1}"
        expected = f"one of {known}, or {numbers_known}" if known else numbers_known
    # -1 is what MuJoCo answers for an unknown name; it must never mean the free camera here.
    hint = " (the free camera is an mujoco.MjvCamera)" if got == "-1" else ""
    return ValueError(f"camera_name: expected {expected}, got {got}{hint}")
