"""Render color, depth and labels from a camera of the scene, and derive what that camera is.

Taught in: step 1 (rendering) and step 2 (intrinsics).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from labutils._constants import FLIP_YZ
from labutils._guards import check_image_size

if TYPE_CHECKING:
    from labutils.rendering import AnyRenderer


def render_camera(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    renderer: AnyRenderer,
    camera_name: str,
) -> tuple[np.ndarray, np.ndarray]:
    """Render color and depth from a named camera.

    Convention
    ----------
    The picture shows the *current* ``data.qpos`` (and mocap poses): positions are brought up to
    date by ``mj_kinematics`` and ``mj_camlight`` first, which change no state. Depth is metric:
    meters along the optical axis, not along the ray. Pixels that see nothing read the far plane.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene and its state.
    renderer : mujoco.Renderer or RaycastRenderer
        From `make_renderer`; its size is the picture size.
    camera_name : str
        Name of a camera of the model.

    Returns
    -------
    rgb : ndarray, uint8, shape (H, W, 3)
        The color picture. The renderer is left in color mode.
    depth : ndarray, float32, shape (H, W)
        Meters.

    Raises
    ------
    ValueError
        If the model has no such camera.

    References
    ----------
    .. [1] MuJoCo documentation, Python bindings, ``mujoco.Renderer``.
    """
    get_camera_id(model, camera_name)
    _update_positions(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.disable_segmentation_rendering()
    renderer.disable_depth_rendering()
    rgb = renderer.render()
    try:
        renderer.enable_depth_rendering()
        depth = renderer.render()
    finally:
        renderer.disable_depth_rendering()
    return rgb, depth


def render_segmentation(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    renderer: AnyRenderer,
    camera_name: str,
) -> np.ndarray:
    """Render which body every pixel belongs to: labels a real camera does not have.

    Parameters
    ----------
    model, data, renderer, camera_name
        As in `render_camera`.

    Returns
    -------
    ndarray, int32, shape (H, W)
        Body ids as in ``model.body(name).id``; -1 where nothing is seen.

    Raises
    ------
    ValueError
        If the model has no such camera.
    """
    get_camera_id(model, camera_name)
    _update_positions(model, data)
    renderer.update_scene(data, camera=camera_name)
    try:
        renderer.enable_segmentation_rendering()
        pairs = renderer.render()
    finally:
        renderer.disable_segmentation_rendering()
    object_ids, kinds = pairs[..., 0], pairs[..., 1]
    is_geom = kinds == int(mujoco.mjtObj.mjOBJ_GEOM)
    # Pixels of anything else (a site, a contact arrow) carry no body: they count as nothing.
    return np.where(is_geom, model.geom_bodyid[np.where(is_geom, object_ids, 0)], -1).astype(
        np.int32
    )


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
    if model.cam_projection[camera_id] == int(mujoco.mjtProjection.mjPROJ_ORTHOGRAPHIC):
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
    camera_id = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, str(camera_name))
    if camera_id < 0:
        known = ", ".join(model.camera(i).name for i in range(model.ncam)) or "none at all"
        raise ValueError(f"camera_name: expected one of {known}, got {camera_name!r}")
    return camera_id


def _update_positions(model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Bring body, geom, camera and light poses up to date with qpos.

    The full ``mj_forward`` would also run contacts, forces and sensors, which no picture shows:
    these two calls do what a picture needs, and leave accelerations and sensor data alone.
    """
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
