"""Truth without OpenGL: one ray per pixel, cast against the scene's exact geometry.

The ray caster knows nothing of depth buffers, clip planes or focal lengths derived from pictures:
it asks MuJoCo where a straight line meets a surface. That makes it the reference that every
measured number of the book is compared with, and a stand-in renderer where no OpenGL works.
Taught in: step 3 and step 5.
"""

from __future__ import annotations

from typing import Any, Self

import mujoco
import numpy as np

from labutils._constants import FLIP_YZ
from labutils._guards import check_image_size
from labutils.camera_utils import get_camera_id, get_camera_intrinsics

#: MuJoCo draws the geom groups 0, 1 and 2 unless told otherwise; rays must see the same geoms.
_VISIBLE_GROUPS = np.array([1, 1, 1, 0, 0, 0], dtype=np.uint8)

#: Geoms of bodies that cannot move are drawn, so rays hit them too.
_HIT_STATIC_GEOMS = True

_SKY_RGB = np.array([0.62, 0.74, 0.86])


def raycast_depth(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: str, width: int, height: int
) -> np.ndarray:
    """Measure the true depth of every pixel.

    Convention
    ----------
    Rays leave through pixel centers: integer (u, v) is the center. Depth is the distance along
    the optical axis, not the length of the ray.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene, forwarded.
    camera_name : str
        Name of a camera of the model.
    width, height : int
        Picture size in pixels.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Meters; NaN where the ray meets nothing.

    Raises
    ------
    ValueError
        If the model has no such camera.
    """
    rays = get_pixel_rays(model, data, camera_name, width, height)
    return _cast(model, data, camera_name, rays)[0].astype(np.float32)


def raycast_points(
    model: mujoco.MjModel, data: mujoco.MjData, camera_name: str, width: int, height: int
) -> np.ndarray:
    """Find the world point that every pixel looks at.

    Parameters
    ----------
    model, data, camera_name, width, height
        As in `raycast_depth`.

    Returns
    -------
    ndarray, float64, shape (H, W, 3)
        World coordinates in meters; NaN where the ray meets nothing.

    Raises
    ------
    ValueError
        If the model has no such camera.
    """
    rays_world = get_pixel_rays(model, data, camera_name, width, height)
    depth = _cast(model, data, camera_name, rays_world)[0]
    camera_id = get_camera_id(model, camera_name)
    return data.cam_xpos[camera_id] + depth[..., None] * rays_world


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


def _cast(
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


class RaycastRenderer:
    """Draw with rays instead of OpenGL, with the methods of ``mujoco.Renderer``.

    Depth and segmentation are exact; color is the geom's own color under one light at the
    camera, without textures, shadows or anti-aliasing.

    Parameters
    ----------
    model : mujoco.MjModel
        The compiled scene.
    height, width : int
        Picture size in pixels.

    Raises
    ------
    TypeError, ValueError
        If `height` or `width` is not a positive whole number, or larger than the model's
        off-screen buffer (the same limit as MuJoCo's renderer has).
    """

    def __init__(self, model: mujoco.MjModel, height: int = 240, width: int = 320) -> None:
        width, height = check_image_size(width, height)
        limits = model.vis.global_
        for name, size, limit in (
            ("width", width, limits.offwidth),
            ("height", height, limits.offheight),
        ):
            if size > limit:
                raise ValueError(
                    f"{name}: expected at most {limit} (the model's off{name}), got {size}"
                )
        self.model = model
        self.height = height
        self.width = width
        self._mode = "color"
        self._frame: tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray] | None = None

    def update_scene(
        self, data: mujoco.MjData, camera: str | int = -1, scene_option: Any = None
    ) -> None:
        """Cast the rays of one frame; `camera` is a name or an id of a camera of the model."""
        if scene_option is not None:
            raise ValueError(
                "scene_option: the ray caster draws with MuJoCo's default options only"
            )
        name = camera if isinstance(camera, str) else _get_camera_name(self.model, camera)
        if not data.cam_xmat[get_camera_id(self.model, name)].any():
            # A state that was never forwarded: OpenGL draws nothing but sky then, and so do we.
            shape = (self.height, self.width)
            nothing = np.full(shape, np.nan), np.full(shape, -1), np.zeros((*shape, 3))
            self._frame = (*nothing, np.ones((*shape, 3)))
            return
        rays = get_pixel_rays(self.model, data, name, self.width, self.height)
        self._frame = (*_cast(self.model, data, name, rays), rays)

    def enable_depth_rendering(self) -> None:
        """Make `render` return meters."""
        self._mode = "depth"

    def disable_depth_rendering(self) -> None:
        """Make `render` return color again."""
        self._mode = "color"

    def enable_segmentation_rendering(self) -> None:
        """Make `render` return (object id, object type) pairs."""
        self._mode = "segmentation"

    def disable_segmentation_rendering(self) -> None:
        """Make `render` return color again."""
        self._mode = "color"

    def render(self) -> np.ndarray:
        """Return the frame in the current mode.

        Returns
        -------
        ndarray
            Color: uint8 (H, W, 3). Depth: float32 (H, W), meters, the far plane where nothing is
            hit, as OpenGL gives it. Segmentation: int32 (H, W, 2), -1 where nothing is hit.

        Raises
        ------
        RuntimeError
            If `update_scene` was never called, or the renderer is closed.
        """
        if self._frame is None:
            raise RuntimeError("render: expected a call of update_scene first, got none")
        depth, geom_ids, normals, rays = self._frame
        if self._mode == "depth":
            far = self.model.vis.map.zfar * self.model.stat.extent
            return np.where(np.isnan(depth), far, np.minimum(depth, far)).astype(np.float32)
        if self._mode == "segmentation":
            kind = np.where(geom_ids >= 0, int(mujoco.mjtObj.mjOBJ_GEOM), -1)
            return np.stack([geom_ids, kind], axis=-1).astype(np.int32)
        return self._shade(geom_ids, normals, rays)

    def _shade(self, geom_ids: np.ndarray, normals: np.ndarray, rays: np.ndarray) -> np.ndarray:
        rays = rays / np.linalg.norm(rays, axis=-1, keepdims=True)
        facing = np.abs(np.sum(normals * rays, axis=-1))  # 1 where the surface faces the camera
        # An empty model has no color to look up: the sky then fills the picture.
        base = _get_geom_colors(self.model)[geom_ids] if self.model.ngeom else np.zeros(rays.shape)
        lit = base * (0.35 + 0.65 * facing)[..., None]
        color = np.where((geom_ids >= 0)[..., None], lit, _SKY_RGB)
        return np.round(255.0 * np.clip(color, 0.0, 1.0)).astype(np.uint8)

    def close(self) -> None:
        """Forget the frame; nothing else has to be freed."""
        self._frame = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.close()


def _get_geom_colors(model: mujoco.MjModel) -> np.ndarray:
    """Return one color per geom, (ngeom, 3) in [0, 1]: the material's where there is one."""
    colors = model.geom_rgba[:, :3].copy()
    has_material = model.geom_matid >= 0
    colors[has_material] = model.mat_rgba[model.geom_matid[has_material], :3]
    return colors


def _get_camera_name(model: mujoco.MjModel, camera_id: int) -> str:
    if not 0 <= camera_id < model.ncam:
        raise ValueError(f"camera: expected an id from 0 to {model.ncam - 1}, got {camera_id}")
    return model.camera(camera_id).name
