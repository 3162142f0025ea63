"""Cameras that are no part of a model: ``mujoco.MjvCamera``, as a viewer has one.

Stands on NumPy alone: such a camera is only read, by attribute. `labutils.cameras` asks here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeGuard

import numpy as np

if TYPE_CHECKING:
    import mujoco

#: ``mjtCamera``, written out because MuJoCo is not imported here.
_FREE, _TRACKING, _FIXED = 0, 1, 2


def is_viewer_camera(camera: Any) -> TypeGuard[mujoco.MjvCamera]:
    """Tell whether something is a ``mujoco.MjvCamera``, whatever its type."""
    return all(hasattr(camera, name) for name in ("fixedcamid", "lookat", "azimuth"))


def is_free(camera: Any) -> TypeGuard[mujoco.MjvCamera]:
    """Tell whether a camera has a pose of its own: a viewer's camera that is free or tracks a body.

    Raises
    ------
    ValueError
        If the camera is of the type ``mjCAMERA_USER``, whose pose only its owner knows.
    """
    if not is_viewer_camera(camera):
        return False
    if camera.type not in (_FREE, _TRACKING, _FIXED):
        raise ValueError(
            "camera_name: expected an MjvCamera of type mjCAMERA_FREE, mjCAMERA_TRACKING or "
            f"mjCAMERA_FIXED, got type {int(camera.type)}"
        )
    return camera.type != _FIXED


def describe(camera: Any) -> str:
    """Name a camera in a message: its name in quotes, its number, or what kind it is."""
    if is_viewer_camera(camera):
        return f"number {camera.fixedcamid}" if camera.type == _FIXED else "the free camera"
    return repr(str(camera)) if isinstance(camera, str) else f"number {camera}"


def get_free_pose(data: mujoco.MjData, camera: mujoco.MjvCamera) -> np.ndarray:
    """Compute the pose of a free or tracking camera as the transform from its frame to the world.

    Convention
    ----------
    The camera looks at a point from a distance. Azimuth turns it around the vertical axis of the
    world, elevation tilts it: at 0 and 0 it looks along +x. A tracking camera looks at the center
    of mass of the body it follows and of all bodies attached to it.

    Parameters
    ----------
    data : mujoco.MjData
        Gives the center of mass; with ``mj_comPos`` up to date.
    camera : mujoco.MjvCamera
        Free or tracking.

    Returns
    -------
    ndarray, float64, shape (4, 4)
        ``T_world_cam``, the camera frame being OpenCV's: x right, y down, z forward.

    References
    ----------
    .. [1] MuJoCo documentation, API reference, ``mjvCamera`` and ``mjv_cameraFrame``.
    """
    azimuth, elevation = np.deg2rad([camera.azimuth, camera.elevation])
    forward = np.array(
        [
            np.cos(elevation) * np.cos(azimuth),
            np.cos(elevation) * np.sin(azimuth),
            np.sin(elevation),
        ]
    )
    # Never from the cross product with "up", which vanishes where the camera looks straight down.
    right = np.array([np.sin(azimuth), -np.cos(azimuth), 0.0])
    is_tracking = camera.type == _TRACKING
    target = data.subtree_com[camera.trackbodyid] if is_tracking else camera.lookat
    T_world_cam = np.eye(4)
    T_world_cam[:3, :3] = np.stack([right, np.cross(forward, right), forward], axis=1)
    T_world_cam[:3, 3] = np.asarray(target) - camera.distance * forward
    return T_world_cam
