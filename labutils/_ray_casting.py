"""One ray per pixel, cast against the exact geometry of a scene by MuJoCo."""

from __future__ import annotations

import mujoco
import numpy as np

from labutils._constants import FLIP_YZ
from labutils._guards import check_image_size
from labutils.cameras import get_camera_id, get_camera_intrinsics

#: MuJoCo draws the geom groups 0, 1 and 2 unless told otherwise; rays must see the same geoms.
_VISIBLE_GROUPS = np.array([1, 1, 1, 0, 0, 0], dtype=np.uint8)

#: Geoms of bodies that cannot move are drawn, so rays hit them too.
_HIT_STATIC_GEOMS = True


def get_pixel_rays(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: str, width: int, height: int
) -> np.ndarray:
    """Compute the direction of the ray through every pixel center, in the world frame.

    Returns
    -------
    ndarray, float64, shape (H, W, 3)
        Directions with a length of one meter along the optical axis, so that position plus depth
        times direction is the point seen.

    Raises
    ------
    ValueError
        If the model has no such camera, or the state was never forwarded.
    """
    width, height = check_image_size(width, height)
    K, _ = get_camera_intrinsics(model, camera_name, width, height)
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    rays_cam = np.stack(
        [(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(u.shape)], axis=-1
    )  # HxWx3
    camera_id = get_camera_id(model, camera_name)
    if not data.cam_xmat[camera_id].any():
        raise ValueError(
            "data: expected a forwarded state, got one in which the camera has no direction"
        )
    rotation_world_cv = data.cam_xmat[camera_id].reshape(3, 3) @ FLIP_YZ
    return rays_cam @ rotation_world_cv.T


def cast_rays(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: str, rays: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cast all rays (H, W, 3); return depth (H, W), geom ids (H, W) and normals (H, W, 3)."""
    lengths = np.linalg.norm(rays, axis=-1)
    count = lengths.size
    geom_ids = np.full(count, -1, dtype=np.int32)
    distances = np.full(count, -1.0)
    normals = np.zeros(count * 3)
    camera_id = get_camera_id(model, camera_name)
    mujoco.mj_multiRay(
        model,
        data,
        data.cam_xpos[camera_id],
        (rays / lengths[..., None]).ravel(),
        _VISIBLE_GROUPS,
        _HIT_STATIC_GEOMS,
        -1,  # no body is left out
        geom_ids,
        distances,
        normals,
        count,
        mujoco.mjMAXVAL,
    )
    depth = np.where(geom_ids >= 0, distances / lengths.ravel(), np.nan)
    shape = lengths.shape
    return depth.reshape(shape), geom_ids.reshape(shape), normals.reshape(*shape, 3)
