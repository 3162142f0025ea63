"""Pictures of the following loop by a few formulas: fast without OpenGL, and the same everywhere.

Drawn are the ball, the board, the red box, the table and a room without a window. The other objects
and the robot's own arms are left out: they are not red, and every ray costs time in a browser.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Self

import numpy as np

from labutils.cameras import get_camera_intrinsics, get_camera_pose
from labutils.following.scene import BALL, BOARD, BOARD_HALF_SIZE, CAMERA

if TYPE_CHECKING:
    from collections.abc import Iterable

    import mujoco

RADIUS = 0.045
_BOX = "red_box"
#: Colors of the scene's materials, without their textures.
_COLORS = {
    BALL: (219, 33, 20),
    BOARD: (194, 168, 133),
    _BOX: (214, 26, 48),
    "table": (200, 168, 128),
    "room": (200, 196, 188),
}
#: Height of the table, and its borders: low and high x, low and high y.
_TABLE_Z, _TABLE = 0.86, (0.45, 1.45, -0.72, 0.72)
#: The inside of the room: low and high corner.
_ROOM = np.array([[-1.95, -2.45, 0.0], [1.95, 2.45, 2.6]], np.float32)
#: Where the light comes from.
_LIGHT = np.array([-0.39, 0.39, 0.84])
_AMBIENT = 0.55


class LoopRenderer:
    """Draw what `render_camera` asks for: color, or depth in meters along the optical axis.

    Parameters
    ----------
    model : mujoco.MjModel
        From `make_following_scene`.
    height, width : int
        Of the picture.
    blind : iterable of (float, float)
        From when to when the depth of the ball's pixels is lost: 0 in its middle, NaN around.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        height: int,
        width: int,
        *,
        blind: Iterable[tuple[float, float]] = (),
    ) -> None:
        self.model, self.height, self.width = model, height, width
        self._blind = tuple(blind)
        self._K, _ = get_camera_intrinsics(model, CAMERA, width, height)
        v, u = np.mgrid[:height, :width]
        x, y = (u - self._K[0, 2]) / self._K[0, 0], (v - self._K[1, 2]) / self._K[1, 1]
        # Single precision, a tenth of a millimeter in the room, takes half the time.
        self._rays = np.stack([x, y, np.ones_like(x)], axis=-1).astype(np.float32)
        self._shows_depth = False
        self._rgb = np.zeros((height, width, 3), np.uint8)
        self._depth = np.zeros((height, width), np.float32)

    def update_scene(self, data: mujoco.MjData, camera: Any = -1, scene_option: Any = None) -> None:
        """Draw color and depth of a state from the robot's eye, whatever camera is named."""
        del camera, scene_option
        T = get_camera_pose(self.model, data, CAMERA)
        eye = T[:3, 3].astype(np.float32)
        x, y, z = np.moveaxis(self._rays.reshape(-1, 3) @ T[:3, :3].T.astype(np.float32), -1, 0)
        rays = [one.reshape(self.height, self.width) for one in (x, y, z)]
        depth = _leave_room(eye, rays)
        rgb = np.empty((self.height, self.width, 3), np.uint8)
        rgb[:] = _COLORS["room"]
        on_table = _meet_table(eye, rays)
        rgb[on_table < depth] = _COLORS["table"]
        depth = np.minimum(depth, on_table)
        for name, half in ((_BOX, (0.045,) * 3), (BOARD, BOARD_HALF_SIZE)):
            body = data.body(name)
            self._draw_box(
                rgb, depth, T, (body.xpos, body.xmat.reshape(3, 3), np.array(half)), name
            )
        is_ball = self._draw_ball(rgb, depth, T, data.body(BALL).xpos)
        if any(start <= data.time + 1e-9 < end for start, end in self._blind):
            depth[is_ball] = np.nan
            depth[is_ball & (np.roll(is_ball, 3, axis=0) & np.roll(is_ball, -3, axis=0))] = 0.0
        self._rgb, self._depth = rgb, depth

    def render(self, *, out: np.ndarray | None = None) -> np.ndarray:
        """Return what was drawn."""
        picture = self._depth if self._shows_depth else self._rgb
        if out is None:
            return picture.copy()
        out[:] = picture
        return out

    def enable_depth_rendering(self) -> None:
        """Make `render` return depth."""
        self._shows_depth = True

    def disable_depth_rendering(self) -> None:
        """Make `render` return color again."""
        self._shows_depth = False

    def enable_segmentation_rendering(self) -> None:
        """Refuse: nobody in the loop asks for labels."""
        raise NotImplementedError("LoopRenderer draws no labels")

    def disable_segmentation_rendering(self) -> None:
        """Do nothing: there is none."""

    def close(self) -> None:
        """Do nothing: there is nothing to free."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _find_window(self, T: np.ndarray, center: np.ndarray, reach: float) -> tuple[slice, slice]:
        """Return the rows and columns that a ball of this reach can cover."""
        x, y, z = T[:3, :3].T @ (center - T[:3, 3])
        if z < -reach:
            return slice(0), slice(0)
        if z < 2 * reach:
            return slice(self.height), slice(self.width)
        radius = 1.2 * reach / (z - reach)
        found = []
        for place, axis, size in ((y / z, 1, self.height), (x / z, 0, self.width)):
            focal, middle = self._K[axis, axis], self._K[axis, 2]
            low = middle + focal * (place - radius)
            high = middle + focal * (place + radius)
            found.append(slice(*np.clip([int(low), int(high) + 2], 0, size)))
        return found[0], found[1]

    def _draw_ball(
        self, rgb: np.ndarray, depth: np.ndarray, T: np.ndarray, center: np.ndarray
    ) -> np.ndarray:
        """Draw the ball into both pictures; return where it is, bool (H, W)."""
        is_ball = np.zeros(depth.shape, bool)
        window = self._find_window(T, center, RADIUS)
        rays = self._rays[window].astype(np.float64) @ T[:3, :3].T
        to_eye = T[:3, 3] - center
        a = (rays**2).sum(axis=-1)
        b = rays @ to_eye
        inside = b**2 - a * (to_eye @ to_eye - RADIUS**2)
        near = (-b - np.sqrt(np.maximum(inside, 0))) / a
        seen = (inside > 0) & (near > 0) & (near < depth[window])
        normal = (to_eye + near[..., None] * rays) / RADIUS
        shade = _AMBIENT + (1 - _AMBIENT) * np.clip(normal @ _LIGHT, 0, 1)
        rgb[window][seen] = np.rint(shade[seen, None] * _COLORS[BALL])
        depth[window][seen] = near[seen]
        is_ball[window] = seen
        return is_ball

    def _draw_box(
        self,
        rgb: np.ndarray,
        depth: np.ndarray,
        T: np.ndarray,
        box: tuple[np.ndarray, np.ndarray, np.ndarray],
        name: str,
    ) -> None:
        """Draw a box of a center, a rotation and half its sides into both pictures."""
        center, R, half = box
        window = self._find_window(T, center, float(np.linalg.norm(half)))
        rays = self._rays[window] @ (T[:3, :3].T @ R)
        near, axis = _meet_box(R.T @ (T[:3, 3] - center), rays, half)
        seen = near < depth[window]
        shade = np.array([0.8, 0.7, 1.0])[axis]
        rgb[window][seen] = np.rint(shade[seen, None] * _COLORS[name])
        depth[window][seen] = near[seen]


def _leave_room(eye: np.ndarray, rays: list[np.ndarray]) -> np.ndarray:
    """Return the depth of the walls, seen from within."""
    with np.errstate(divide="ignore"):
        reaches = [
            np.where(ray > 0, high - start, low - start) / ray
            for ray, start, low, high in zip(rays, eye, *_ROOM, strict=True)
        ]
    return np.minimum(np.minimum(reaches[0], reaches[1]), reaches[2])


def _meet_table(eye: np.ndarray, rays: list[np.ndarray]) -> np.ndarray:
    """Return the depth of the table top; infinite beside it."""
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = (_TABLE_Z - eye[2]) / rays[2]
        x, y = eye[0] + reach * rays[0], eye[1] + reach * rays[1]
    low_x, high_x, low_y, high_y = _TABLE
    hit = (reach > 0) & (low_x < x) & (x < high_x) & (low_y < y) & (y < high_y)
    return np.where(hit, reach, np.float32(np.inf))


def _meet_box(eye: np.ndarray, rays: np.ndarray, half: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Meet a box in its own frame: where rays enter (infinite: never), and by which axis."""
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = (-half - eye) / rays, (half - eye) / rays
    enter, leave = np.minimum(one, other), np.maximum(one, other)
    near = enter.max(axis=-1)
    hit = (near <= leave.min(axis=-1)) & (near > 0)
    return np.where(hit, near, np.inf), enter.argmax(axis=-1)
