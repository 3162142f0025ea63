"""Draw with rays: exact depth and labels, flat colors, no OpenGL."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Self, TypeAlias

import mujoco
import numpy as np

from labutils._guards import check_image_size
from labutils._ray_casting import cast_rays, get_pixel_rays, is_forwarded
from labutils._scene_guards import check_model
from labutils.cameras import get_camera_id, get_camera_pose
from labutils.depth_values import get_clip_planes, metric_to_raw
from labutils.free_camera import is_free, is_viewer_camera
from labutils.renderers.omissions import warn_once

if TYPE_CHECKING:
    from labutils.cameras import Camera
    from labutils.renderers.protocol import Renderer

#: Depth, geom ids, normals and rays of every pixel.
_Frame: TypeAlias = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]

#: The number that `mujoco.Renderer` takes for the free camera of the model.
_DEFAULT_FREE_CAMERA = -1

_SKY_RGB = np.array([0.62, 0.74, 0.86])


class RaycastRenderer:
    """Draw with rays instead of OpenGL, with the methods of ``mujoco.Renderer``.

    Depth and segmentation of geoms are exact; color is the geom's own color under one light at
    the camera, without textures, shadows or anti-aliasing.

    Convention
    ----------
    Where rays and OpenGL see different things, each is true to itself:

    - rays pass through what is no geom: sites, tendons, skins, flexes, range-finder lines;
    - rays hit the back of a mesh, OpenGL does not draw it; a plane seen from behind is the reverse;
    - with the camera inside a geom, rays hit its inner side and OpenGL looks through it;
    - a sphere is round for rays and made of triangles for OpenGL, a few millimeters inside;
    - OpenGL cuts off what is nearer than the near plane, and draws a pixel of an outline from
      several samples.

    Parameters
    ----------
    model : mujoco.MjModel
        The compiled scene.
    height, width : int
        Picture size in pixels.
    max_geom, font_scale
        As ``mujoco.Renderer`` takes them; they change no picture by rays.

    Raises
    ------
    TypeError, ValueError
        If `height` or `width` is not a positive whole number, or larger than the model's
        off-screen buffer (the same limit as MuJoCo's renderer has).

    Warns
    -----
    NotDrawnWarning
        Once per model, with the list of what OpenGL would draw of it and rays do not.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        height: int = 240,
        width: int = 320,
        max_geom: int = 10000,
        font_scale: Any = None,
    ) -> None:
        del font_scale  # nothing is written into a picture by rays
        width, height = check_image_size(width, height)
        check_model(model)
        limits = model.vis.global_
        for name, size, limit in (
            ("width", width, limits.offwidth),
            ("height", height, limits.offheight),
        ):
            if size > limit:
                raise ValueError(
                    f"{name}: expected at most {limit} (the model's off{name}), got {size}"
                )
        warn_once(model, stacklevel=2)
        self._model = model
        self._height = height
        self._width = width
        self._max_geom = max_geom
        self._gives_depth = self._gives_segmentation = self._is_closed = False
        self._frame: _Frame | None = None
        self._scene: mujoco.MjvScene | None = None
        self._shown: tuple[mujoco.MjData, Camera, mujoco.MjvOption] | None = None

    @property
    def model(self) -> mujoco.MjModel:
        """The model it was made for."""
        return self._model

    @property
    def height(self) -> int:
        """Rows of every picture."""
        return self._height

    @property
    def width(self) -> int:
        """Columns of every picture."""
        return self._width

    @property
    def scene(self) -> mujoco.MjvScene:
        """What OpenGL would draw: its geoms, lights and cameras; rays do not read it."""
        if self._scene is None:
            self._scene = mujoco.MjvScene(self._model, self._max_geom)
            self._fill_scene()
        return self._scene

    def _fill_scene(self) -> None:
        if self._scene is None or self._shown is None:
            return  # nobody has asked for it, or there is nothing to show
        data, camera, option = self._shown
        if not is_viewer_camera(camera):
            number, camera = camera, mujoco.MjvCamera()
            camera.type, camera.fixedcamid = int(mujoco.mjtCamera.mjCAMERA_FIXED), int(number)
        catch_all = int(mujoco.mjtCatBit.mjCAT_ALL)
        mujoco.mjv_updateScene(self._model, data, option, None, camera, catch_all, self._scene)

    def update_scene(
        self,
        data: mujoco.MjData,
        camera: Camera = -1,
        scene_option: mujoco.MjvOption | None = None,
    ) -> None:
        """Cast the rays of one frame.

        Parameters
        ----------
        data : mujoco.MjData
            The state, forwarded; of one that never was, nothing but sky is drawn.
        camera : str, int or mujoco.MjvCamera
            A camera of the model by name or number, or a free camera; -1 is MuJoCo's default one.
        scene_option : mujoco.MjvOption, optional
            Its groups of geoms and its flag ``mjVIS_STATIC`` count here.

        Raises
        ------
        TypeError, ValueError
            If the model has no such camera, or it is orthographic.
        """
        if not isinstance(camera, str) and camera == _DEFAULT_FREE_CAMERA:
            camera = mujoco.MjvCamera()
            mujoco.mjv_defaultFreeCamera(self.model, camera)
        elif not is_free(camera):
            camera = get_camera_id(self.model, camera)
        option = mujoco.MjvOption() if scene_option is None else scene_option
        self._shown = data, camera, option
        self._fill_scene()
        if not is_forwarded(data):
            # OpenGL draws nothing but sky then, and so do we.
            shape = (self.height, self.width)
            nothing = np.full(shape, np.nan), np.full(shape, -1), np.zeros((*shape, 3))
            self._frame = (*nothing, np.ones((*shape, 3)))
            return
        rays = get_pixel_rays(self.model, data, camera, self.width, self.height)
        origin = get_camera_pose(self.model, data, camera)[:3, 3]
        self._frame = (*cast_rays(self.model, data, origin, rays, option), rays)

    def enable_depth_rendering(self) -> None:
        """Make `render` return meters."""
        self._gives_depth, self._gives_segmentation = True, False

    def disable_depth_rendering(self) -> None:
        """Make `render` return color again, if it returned meters."""
        self._gives_depth = False

    def enable_segmentation_rendering(self) -> None:
        """Make `render` return (object id, object type) pairs."""
        self._gives_depth, self._gives_segmentation = False, True

    def disable_segmentation_rendering(self) -> None:
        """Make `render` return color again, if it returned pairs."""
        self._gives_segmentation = False

    def render(self, *, out: np.ndarray | None = None) -> np.ndarray:
        """Return the frame in the current mode.

        Parameters
        ----------
        out : ndarray, optional
            Where to write the picture; of its shape, of any type that can hold numbers.

        Returns
        -------
        ndarray
            Color: uint8 (H, W, 3). Depth: float32 (H, W), meters, the far plane where nothing is
            hit, as OpenGL gives it. Segmentation: int32 (H, W, 2), -1 where nothing is hit.
            `out` itself where it was given.

        Raises
        ------
        RuntimeError
            If `update_scene` was never called, or the renderer is closed.
        ValueError
            If `out` has another shape.
        """
        if self._is_closed:
            raise RuntimeError("render: expected an open renderer, got one after close")
        if self._frame is None:
            raise RuntimeError("render: expected a call of update_scene first, got none")
        picture = self._draw(*self._frame)
        if out is None:
            return picture
        if out.shape != picture.shape:
            raise ValueError(f"out: expected shape {picture.shape}, got {out.shape}")
        np.copyto(out, picture, casting="unsafe")
        return out

    def _draw(
        self, depth: np.ndarray, geom_ids: np.ndarray, normals: np.ndarray, rays: np.ndarray
    ) -> np.ndarray:
        if self._gives_depth:
            far = self.model.vis.map.zfar * self.model.stat.extent
            return np.where(np.isnan(depth), far, np.minimum(depth, far)).astype(np.float32)
        if self._gives_segmentation:
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
        self._is_closed = True
        self._frame = self._scene = self._shown = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.close()


def read_raw_depth(model: mujoco.MjModel, renderer: Renderer) -> np.ndarray:
    """Make what a depth buffer would hold: rays fill none, so exact depth is converted backward.

    Parameters
    ----------
    model : mujoco.MjModel
        Gives the clip planes.
    renderer : Renderer
        With its scene up to date; left in color mode.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Window depth, 0 at the near plane, 1 at the far plane.
    """
    try:
        renderer.enable_depth_rendering()
        depth = renderer.render()
    finally:
        renderer.disable_depth_rendering()
    return metric_to_raw(depth, *get_clip_planes(model)).astype(np.float32)


def _get_geom_colors(model: mujoco.MjModel) -> np.ndarray:
    """Return one color per geom, (ngeom, 3) in [0, 1]: the material's where there is one."""
    colors = model.geom_rgba[:, :3].copy()
    has_material = model.geom_matid >= 0
    colors[has_material] = model.mat_rgba[model.geom_matid[has_material], :3]
    return colors
