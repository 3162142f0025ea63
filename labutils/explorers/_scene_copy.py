"""A state of its own in which a reader turns the head and moves the ball, and what is seen then."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import mujoco
import numpy as np

from labutils._scene_guards import check_state
from labutils.camera_utils import render_camera
from labutils.cameras import get_camera_intrinsics, get_camera_pose
from labutils.projection import points_to_pixels
from labutils.renderers.rays import RaycastRenderer

if TYPE_CHECKING:
    from labutils.cameras import Camera

PAN, TILT, BALL = "neck_pan", "neck_tilt", "red_ball"
#: Where the ball may lie: on the table top and not over its edge, in meters of the world.
BALL_X, BALL_Y = (0.50, 1.40), (-0.66, 0.66)
#: What is nearer than the middle of the ball by this many of its radii is not the ball.
_HIDING = 1.5


class ScenePose(NamedTuple):
    """What a reader sets: two angles in degrees, and the place of the ball in meters."""

    pan_deg: float
    tilt_deg: float
    ball_x: float
    ball_y: float


class SceneCopy:
    """The scene with another pose.

    Parameters
    ----------
    model, data : mujoco.MjModel, mujoco.MjData
        The scene to start from; it is left as it is.
    camera_name : str, int or mujoco.MjvCamera
        Where to look from.
    width, height : int
        Picture size in pixels.

    Raises
    ------
    TypeError, ValueError
        If the two do not belong together, the model has no neck or no ball to move, no such
        camera, or the size is none.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        camera_name: Camera,
        width: int,
        height: int,
    ) -> None:
        check_state(model, data)
        self._model = model
        self._camera_name = camera_name
        joints = [_find(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in (PAN, TILT)]
        self._addresses = [int(model.jnt_qposadr[joint]) for joint in joints]
        #: Limits of both angles in degrees.
        self.limits_deg = np.degrees([model.jnt_range[joint] for joint in joints])
        body = _find(model, mujoco.mjtObj.mjOBJ_BODY, BALL)
        self._ball = int(model.body_mocapid[body])
        if self._ball < 0:
            raise ValueError(
                f"model: expected {BALL} to be a mocap body, which data.mocap_pos moves"
            )
        self._radius = float(model.geom_rbound[model.body_geomadr[body]])
        self.data = mujoco.MjData(model)
        self.data.qpos[:] = data.qpos
        self.data.mocap_pos[:] = data.mocap_pos
        self.data.mocap_quat[:] = data.mocap_quat
        self._renderer = RaycastRenderer(model, height, width)
        self._K, fov_y = get_camera_intrinsics(model, camera_name, width, height)
        #: Field of view from top to bottom in degrees.
        self.fov_y_deg = float(np.degrees(fov_y))
        mujoco.mj_forward(model, self.data)

    @property
    def pose(self) -> ScenePose:
        """The pose of now."""
        pan, tilt = np.degrees([self.data.qpos[address] for address in self._addresses])
        x, y, _ = self.data.mocap_pos[self._ball]
        return ScenePose(*(round(float(value), 9) for value in (pan, tilt, x, y)))

    def move(self, pose: ScenePose) -> None:
        """Take another pose, as near to it as neck and table let it, and bring all up to date."""
        for address, angle, limits in zip(self._addresses, pose[:2], self.limits_deg, strict=True):
            self.data.qpos[address] = np.radians(np.clip(angle, *limits))
        self.data.mocap_pos[self._ball, :2] = (
            np.clip(pose.ball_x, *BALL_X),
            np.clip(pose.ball_y, *BALL_Y),
        )
        mujoco.mj_forward(self._model, self.data)

    def draw(self) -> tuple[np.ndarray, np.ndarray]:
        """Cast one ray per pixel: color, uint8 (H, W, 3), and depth in meters, float32 (H, W)."""
        return render_camera(self._model, self.data, self._renderer, self._camera_name)

    def find_ball(self, depth_metric: np.ndarray) -> tuple[float, float] | None:
        """Find (u, v) of the ball's middle in a depth image of now; None where it is unseen."""
        T_world_cam = get_camera_pose(self._model, self.data, self._camera_name)
        middle = np.linalg.inv(T_world_cam) @ [*self.data.mocap_pos[self._ball], 1.0]
        u, v = points_to_pixels(middle[None, :3], self._K)[0].tolist()
        height, width = depth_metric.shape
        if not (-0.5 <= u < width - 0.5 and -0.5 <= v < height - 0.5):  # neither does NaN, behind
            return None
        nearest = middle[2] - _HIDING * self._radius
        return (u, v) if depth_metric[round(v), round(u)] > nearest else None


def _find(model: mujoco.MjModel, kind: mujoco.mjtObj, name: str) -> int:
    number = mujoco.mj_name2id(model, kind, name)
    if number < 0:
        what = "joint" if kind == mujoco.mjtObj.mjOBJ_JOINT else "body"
        raise ValueError(f"model: expected a {what} {name!r} to move, got a model without it")
    return number
