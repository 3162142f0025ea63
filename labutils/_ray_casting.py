"""One ray per pixel, cast against the exact geometry of a scene by MuJoCo."""

from __future__ import annotations

import copy
from itertools import pairwise
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

#: Rows and columns of tiles into which a picture is split.
_TILES = (3, 4)
#: Radians that no rounding reaches.
_SLACK = 1e-6


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
    directions = rays / lengths[..., None]
    origin = np.asarray(origin, dtype=np.float64)
    groups = np.array(option.geomgroup, dtype=np.uint8)
    sees_static = bool(option.flags[mujoco.mjtVisFlag.mjVIS_STATIC])
    geom_ids = np.full(lengths.shape, -1, dtype=np.int32)
    distances = np.full(lengths.shape, -1.0)
    normals = np.zeros(rays.shape)
    nearby = _NearbyGeoms(model, data, origin)
    for tile in _split(*lengths.shape):
        seen = directions[tile]
        count = seen[..., 0].size
        answer = np.full(count, -1, dtype=np.int32), np.full(count, -1.0), np.zeros(3 * count)
        mujoco.mj_multiRay(
            nearby.choose(seen.reshape(-1, 3)),
            data,
            origin,
            seen.ravel(),
            groups,
            sees_static,
            -1,  # no body is left out
            *answer,
            count,
            mujoco.mjMAXVAL,
        )
        for whole, part in zip((geom_ids, distances, normals), answer, strict=True):
            whole[tile] = part.reshape(whole[tile].shape)
    return np.where(geom_ids >= 0, distances / lengths, np.nan), geom_ids, normals


def _split(height: int, width: int) -> list[tuple[slice, slice]]:
    """Split a picture into tiles: few things are seen in each, and each costs a call."""
    rows, columns = (
        np.linspace(0, size, min(most, size) + 1).round().astype(int)
        for size, most in zip((height, width), _TILES, strict=True)
    )
    return [
        (slice(top, bottom), slice(left, right))
        for top, bottom in pairwise(rows)
        for left, right in pairwise(columns)
    ]


class _NearbyGeoms:
    """A copy of a model of which ``mj_multiRay`` tries no geom that a bundle of rays cannot hit.

    A ray that misses the sphere around a geom misses the geom, so what is hit stays the same, to
    the last bit. MuJoCo itself skips whole bodies, and too many: the sphere around a body holds
    only geoms that collide, so rays would pass through what is there to be seen alone, as a
    robot's visual meshes. A body without a tree of bounds is never skipped.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, origin: np.ndarray) -> None:
        self._shown = copy.copy(model)
        self._shown.body_bvhadr[:] = -1
        self._materials = model.geom_matid.copy()
        self._alphas = model.geom_rgba[:, 3].copy()
        away = data.geom_xpos - origin
        distances = np.maximum(np.linalg.norm(away, axis=1), mujoco.mjMINVAL)
        self._directions = away / distances[:, None]
        radii = model.geom_rbound
        self._spreads = np.arcsin(np.minimum(radii / distances, 1.0)) + _SLACK
        # a plane has no end, and a radius of 0; who is inside a sphere looks at it everywhere
        self._spreads[(radii <= 0) | (distances <= radii)] = np.pi

    def choose(self, directions: np.ndarray) -> mujoco.MjModel:
        """Hide what no ray (unit vectors, (N, 3)) can hit; the copy is good until the next call."""
        axis = directions.mean(axis=0)
        axis /= max(float(np.linalg.norm(axis)), mujoco.mjMINVAL)
        width = np.arccos(np.clip((directions @ axis).min(), -1.0, 1.0))
        angles = np.arccos(np.clip(self._directions @ axis, -1.0, 1.0))
        can_be_hit = angles <= width + self._spreads
        # MuJoCo's rays pass through what is transparent by a color of its own
        self._shown.geom_matid[:] = np.where(can_be_hit, self._materials, -1)
        self._shown.geom_rgba[:, 3] = np.where(can_be_hit, self._alphas, 0.0)
        return self._shown
