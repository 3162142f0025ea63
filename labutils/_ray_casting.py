"""One ray per pixel, cast against the exact geometry of a scene by MuJoCo."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING

import mujoco
import numpy as np

from labutils._guards import check_image_size
from labutils._versions import check_mujoco_version
from labutils.cameras import get_camera_intrinsics, get_camera_pose

if TYPE_CHECKING:
    from labutils.cameras import Camera

check_mujoco_version(
    getattr(mujoco, "__version__", "")
)  # before a ray passes through what it should hit


def get_pixel_rays(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: Camera, width: int, height: int
) -> np.ndarray:
    """Compute the direction of the ray through every pixel center, in the world frame.

    Returns
    -------
    ndarray, float64, shape (H, W, 3)
        Directions with a length of one meter along the optical axis, so that position plus depth
        times direction is the point seen.

    Raises
    ------
    TypeError, ValueError
        If the model has no such camera, or the state was never forwarded.
    """
    width, height = check_image_size(width, height)
    K, _ = get_camera_intrinsics(model, camera_name, width, height)
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    rays_cam = np.stack(
        [(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(u.shape)], axis=-1
    )  # HxWx3
    rotation_world_cv = get_camera_pose(model, data, camera_name)[:3, :3]
    if not (is_forwarded(data) and rotation_world_cv.any()):
        raise ValueError(
            "data: expected a forwarded state, got one in which nothing has a direction; "
            "call mj_forward(model, data)"
        )
    return rays_cam @ rotation_world_cv.T


def is_forwarded(data: mujoco.MjData) -> bool:
    """Tell whether a state has poses: a rotation is never all zeros, the memory of a new one is."""
    return bool(data.xmat[0].any())


def cast_rays(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    origin: np.ndarray,
    rays: np.ndarray,
    scene_option: mujoco.MjvOption | None = None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cast all rays from one point.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene, forwarded.
    origin : ndarray, shape (3,)
        World coordinates in meters.
    rays : ndarray, shape (H, W, 3)
        As `get_pixel_rays` gives them.
    scene_option : mujoco.MjvOption, optional
        Its groups of geoms and its flag ``mjVIS_STATIC`` say what can be hit; without it, what
        MuJoCo draws by default.

    Returns
    -------
    depth : ndarray, float64, shape (H, W)
        Meters; NaN where nothing is hit.
    geom_ids : ndarray, int32, shape (H, W)
        -1 where nothing is hit.
    normals : ndarray, float64, shape (H, W, 3)
        Of unit length, in the world frame.
    """
    option = mujoco.MjvOption() if scene_option is None else scene_option
    lengths = np.linalg.norm(rays, axis=-1)
    count = lengths.size
    geom_ids = np.full(count, -1, dtype=np.int32)
    distances = np.full(count, -1.0)
    normals = np.zeros(count * 3)
    mujoco.mj_multiRay(
        _look_at_every_geom(model),
        data,
        np.asarray(origin, dtype=np.float64),
        (rays / lengths[..., None]).ravel(),
        np.array(option.geomgroup, dtype=np.uint8),
        bool(option.flags[mujoco.mjtVisFlag.mjVIS_STATIC]),
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


def _look_at_every_geom(model: mujoco.MjModel) -> mujoco.MjModel:
    """Return a copy of which ``mj_multiRay`` skips no geom.

    It skips a body whose bounding sphere a ray misses, and that sphere holds only geoms that
    collide: what is there to be seen alone, as a robot's visual meshes, it may pass through. A body
    without a tree of bounds is never skipped. ``mj_ray`` skips nothing either, one ray at a time.
    """
    shown = copy.copy(model)
    shown.body_bvhadr[:] = -1
    return shown
