"""The loop: render, let a controller decide, move the neck, and write down what was true."""

from __future__ import annotations

import time
from collections import deque
from typing import TYPE_CHECKING, NamedTuple, Self

import mujoco
import numpy as np

from labutils._constants import COMMAND_S
from labutils._guards import check_image_size
from labutils.camera_utils import render_camera
from labutils.cameras import get_camera_intrinsics, get_camera_pose
from labutils.following.ball_path import BallPath, Path
from labutils.following.record import FollowingMoment, FollowingRecord
from labutils.following.scene import (
    BALL,
    CAMERA,
    get_mocap_id,
    hide_ball,
    make_following_scene,
    park_board,
)
from labutils.following.state import FollowingState
from labutils.projection import points_to_pixels
from labutils.rendering import make_renderer

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from labutils.renderers.protocol import Renderer

    Control = Callable[[np.ndarray, np.ndarray, np.ndarray, FollowingState], object]

#: Seconds from one command to the next.
DT = COMMAND_S
#: The ball is hidden from the first to the second of these seconds.
HIDDEN = ((4.0, 4.8),)
#: Noise of the depth at 1 m, in meters, for each gray level of noise in the color; it grows with
#: the square of the distance, as that of a depth camera does.
_DEPTH_NOISE = 0.0005


class _Picture(NamedTuple):
    """What was taken, and the pose it was taken in."""

    rgb: np.ndarray
    depth: np.ndarray
    time: float
    pan: float
    tilt: float
    T_world_cam: np.ndarray


class FollowingLoop:
    """A head that follows a ball, one command at a time.

    Parameters
    ----------
    width, height : int
        Size of the robot's picture in pixels.
    seed : int
        Chooses the path of the ball and the noise.
    speed : float
        Of the ball, in m/s.
    delay : int
        How many commands a picture takes to arrive; 0 is at once.
    noise : float
        Standard deviation of the noise in the color, in gray levels; depth becomes noisy with it.
    gain : float
        Handed to the controller as ``state.gain``.
    hidden : iterable of (float, float)
        From when to when a board hides the ball, in seconds.
    path : BallPath, optional
        Another path than that of the seed: whatever has its `get_position`.
    renderer_maker : callable
        ``renderer_maker(model, height, width)`` makes what draws; `make_renderer` unless given.

    Attributes
    ----------
    speed, delay, noise, gain, hidden
        May be changed while it runs.

    Raises
    ------
    TypeError, ValueError
        If the size is no size.
    """

    def __init__(
        self,
        width: int = 640,
        height: int = 480,
        *,
        seed: int = 0,
        speed: float = 0.35,
        delay: int = 1,
        noise: float = 2.0,
        gain: float = 1.0,
        hidden: Iterable[tuple[float, float]] = HIDDEN,
        path: Path | None = None,
        renderer_maker: Callable[[mujoco.MjModel, int, int], Renderer] = make_renderer,
    ) -> None:
        width, height = check_image_size(width, height)
        self.speed, self.delay, self.noise, self.gain = speed, delay, noise, gain
        self.hidden = tuple(hidden)
        self.model, self.data = make_following_scene()
        self.K, _ = get_camera_intrinsics(self.model, CAMERA, width, height)
        self._renderer = renderer_maker(self.model, height, width)
        self._path: Path = BallPath(seed) if path is None else path
        self._random = np.random.default_rng([seed, 1])
        self._ball = get_mocap_id(self.model, BALL)
        self._meters = 0.0
        self._steps = round(DT / self.model.opt.timestep)
        self._pictures: deque[_Picture] = deque()
        self._memory: dict[str, object] = {}
        self._moments: list[FollowingMoment] = []
        self._place()

    @property
    def time(self) -> float:
        """Seconds since the start."""
        return float(self.data.time)

    @property
    def is_hidden(self) -> bool:
        """Whether the board is before the ball now."""
        return any(start <= self.time + 1e-9 < end for start, end in self.hidden)

    @property
    def picture(self) -> np.ndarray:
        """What the camera saw at the last command, uint8 (H, W, 3), as it was taken.

        Raises
        ------
        RuntimeError
            Before the first command.
        """
        if not self._pictures:
            raise RuntimeError("picture: expected a step before, got none")
        return self._pictures[-1].rgb

    @property
    def record(self) -> FollowingRecord:
        """What happened until now."""
        return FollowingRecord.from_moments(self._moments, self.K)

    def step(self, control: Control) -> FollowingMoment:
        """Take a picture, ask the controller, and let the neck move for `DT` seconds.

        Raises
        ------
        TypeError, ValueError
            If what the controller returns is not two finite numbers.
        """
        started = time.perf_counter()
        self._pictures.append(self._take_picture())
        while len(self._pictures) > max(int(self.delay), 0) + 1:
            self._pictures.popleft()
        seen = self._pictures[0]
        state = self._tell(seen)
        rendered = time.perf_counter()
        answer = control(seen.rgb.copy(), seen.depth.copy(), self.K.copy(), state)
        decided = time.perf_counter()
        moment = self._write_down(seen, check_command(answer))
        moment = moment._replace(render_s=rendered - started, control_s=decided - rendered)
        self._moments.append(moment)
        self._move(moment.command)
        return moment

    def run(self, control: Control, seconds: float) -> FollowingRecord:
        """Step until so many seconds have passed, and return the record."""
        for _ in range(round(seconds / DT)):
            self.step(control)
        return self.record

    def close(self) -> None:
        """Free what drawing took."""
        self._renderer.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _place(self) -> None:
        """Put ball and board where they belong now."""
        self.data.mocap_pos[self._ball] = self._path.get_position(self._meters)
        mujoco.mj_forward(self.model, self.data)
        if self.is_hidden:
            hide_ball(self.model, self.data)
        else:
            park_board(self.model, self.data)
        mujoco.mj_forward(self.model, self.data)

    def _take_picture(self) -> _Picture:
        rgb, depth = render_camera(self.model, self.data, self._renderer, CAMERA)
        if self.noise > 0:
            gray = self._random.normal(0, self.noise, rgb.shape)
            rgb = np.clip(np.rint(rgb + gray), 0, 255).astype(np.uint8)
            spread = _DEPTH_NOISE * self.noise * np.square(depth)
            depth = (depth + self._random.normal(0, 1, depth.shape) * spread).astype(np.float32)
        pan, tilt = (float(one) for one in self.data.qpos[:2])
        pose = get_camera_pose(self.model, self.data, CAMERA)
        return _Picture(rgb, depth, self.time, pan, tilt, pose)

    def _tell(self, seen: _Picture) -> FollowingState:
        (low_pan, high_pan), (low_tilt, high_tilt) = self.model.actuator_ctrlrange.tolist()
        return FollowingState(
            time=self.time,
            dt=DT,
            pan=float(self.data.qpos[0]),
            tilt=float(self.data.qpos[1]),
            seen_time=seen.time,
            seen_pan=seen.pan,
            seen_tilt=seen.tilt,
            T_world_cam=seen.T_world_cam.copy(),
            limits=((low_pan, high_pan), (low_tilt, high_tilt)),
            gain=self.gain,
            memory=self._memory,
        )

    def _write_down(self, seen: _Picture, command: np.ndarray) -> FollowingMoment:
        ball = self.data.mocap_pos[self._ball].copy()
        T_world_cam = get_camera_pose(self.model, self.data, CAMERA)
        in_camera = np.linalg.inv(T_world_cam) @ [*ball, 1.0]
        return FollowingMoment(
            time=self.time,
            ball=ball,
            pan=float(self.data.qpos[0]),
            tilt=float(self.data.qpos[1]),
            command=command,
            pixel=points_to_pixels(in_camera[None, :3], self.K)[0],
            is_hidden=self.is_hidden,
            seen_time=seen.time,
            center=check_center(self._memory.get("center")),
        )

    def _move(self, command: np.ndarray) -> None:
        """Let the servo pull for one period, while the ball goes on."""
        self.data.ctrl[:2] = command
        mujoco.mj_step(self.model, self.data, nstep=self._steps)
        self._meters += self.speed * DT
        self._place()


def check_command(answer: object) -> np.ndarray:
    """Return what a controller returned as two finite numbers, float64 (2,).

    Raises
    ------
    TypeError, ValueError
        If it is something else.
    """
    wanted = "control: expected (pan, tilt), two finite numbers in radians"
    try:
        command = np.asarray(answer, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(f"{wanted}, got {type(answer).__name__} {answer!r:.60}") from None
    if command.shape != (2,) or not np.isfinite(command).all():
        raise ValueError(f"{wanted}, got {answer!r:.60}")
    return command


def check_center(center: object) -> np.ndarray:
    """Return what a controller wrote into ``memory["center"]``, float64 (3,); NaN for None.

    Raises
    ------
    TypeError, ValueError
        If it is something else than three numbers.
    """
    if center is None:
        return np.full(3, np.nan)
    wanted = 'memory["center"]: expected (x, y, z) in meters of the world, or None'
    try:
        point = np.asarray(center, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(f"{wanted}, got {type(center).__name__} {center!r:.60}") from None
    if point.shape != (3,):
        raise ValueError(f"{wanted}, got {center!r:.60}")
    return point
