"""A run of the following loop, one command at a time, with what a view shows of each."""

from __future__ import annotations

import inspect
import traceback
from typing import TYPE_CHECKING, Any, NamedTuple

import mujoco
import numpy as np

from labutils.camera_utils import render_camera
from labutils.cameras import get_camera_pose
from labutils.following.loop import DT, FollowingLoop
from labutils.following.record import SETTLING_S
from labutils.following.scene import CAMERA
from labutils.projection import points_to_pixels
from labutils.renderers.rays import RaycastRenderer

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from labutils.following.loop import Control
    from labutils.following.record import FollowingMoment

#: How long the board hides the ball when the reader asks for it, in seconds.
HIDE_S = 0.8
#: The view from outside: head, board and ball, from the robot's left.
_LOOK_AT, _DISTANCE, _AZIMUTH_DEG, _ELEVATION_DEG = (0.55, 0.0, 1.24), 1.75, 122.0, -14.0


class FollowingSettings(NamedTuple):
    """What a reader sets: see `FollowingLoop` for what each does."""

    gain: float
    delay: int
    noise: float
    speed: float


class FollowingRun:
    """A head that follows the ball, and what is seen of it.

    Parameters
    ----------
    control : callable
        ``control(rgb, depth, K, state)``; may be exchanged at any time.
    settings : FollowingSettings
        Taken over by the next step, whenever they are set.
    seed, width, height
        As for `FollowingLoop`.
    hidden : iterable of (float, float)
        From when to when the board hides the ball, in seconds.

    Raises
    ------
    TypeError, ValueError
        If `control` cannot be called, or the size is no size.
    """

    def __init__(
        self,
        control: Control,
        settings: FollowingSettings,
        *,
        seed: int = 0,
        width: int = 160,
        height: int = 120,
        hidden: Iterable[tuple[float, float]] = (),
    ) -> None:
        if not callable(control):
            raise TypeError(
                "control: expected a function of (rgb, depth, K, state), "
                f"got {type(control).__name__}"
            )
        self.control = control
        self.settings = settings
        self._make_loop: Callable[[], FollowingLoop] = lambda: FollowingLoop(
            width, height, seed=seed, hidden=tuple(hidden), renderer_maker=RaycastRenderer
        )
        self._size = height, width
        self.start_again()

    def start_again(self) -> None:
        """Put head and ball where they were at first, and forget what happened since."""
        self.loop = self._make_loop()
        self._renderer = RaycastRenderer(self.loop.model, *self._size)
        #: What is told of each command, in their order.
        self.moments: list[dict[str, Any]] = []
        self._balls: dict[float, np.ndarray] = {}  # by the time at which the ball was there
        self._was_hidden, self._revealed = False, 0.0

    def hide(self) -> None:
        """Let the board hide the ball for `HIDE_S`, from when the neck has moved next."""
        start = self.loop.time + DT / 2
        self.loop.hidden = (*self.loop.hidden, (start, start + HIDE_S))

    def step(self) -> dict[str, Any]:
        """Give one command; return what was true when it was given.

        Raises
        ------
        Exception
            What `control` raises.
        """
        loop = self.loop
        loop.gain, loop.delay, loop.noise, loop.speed = self.settings
        T_world_cam = get_camera_pose(loop.model, loop.data, CAMERA)
        moment = loop.step(self.control)
        told = self._tell(moment, T_world_cam)
        self.moments.append(told)
        return told

    def draw_eye(self) -> np.ndarray:
        """Return what the robot saw at the last command, or sees before the first."""
        if self.moments:
            return self.loop.picture
        return render_camera(self.loop.model, self.loop.data, self._renderer, CAMERA)[0]

    def draw_outside(self) -> np.ndarray:
        """Draw the robot as it stands now, from outside."""
        return render_camera(self.loop.model, self.loop.data, self._renderer, _make_camera())[0]

    def _tell(self, moment: FollowingMoment, T_world_cam: np.ndarray) -> dict[str, Any]:
        """Say in plain numbers what was true; None stands for what is not known."""
        self._balls[moment.time] = moment.ball
        if self._was_hidden and not moment.is_hidden:
            self._revealed = moment.time
        self._was_hidden = moment.is_hidden
        # as `FollowingRecord.is_measured`, which knows the whole run
        follows = not moment.is_hidden and moment.time >= self._revealed + SETTLING_S
        off = np.hypot(*(moment.pixel - self.loop.K[:2, 2]))
        wrong = np.linalg.norm(moment.center - self._balls[moment.seen_time])
        in_camera = (np.linalg.inv(T_world_cam) @ [*moment.center, 1.0])[None, :3]
        told_u, told_v = points_to_pixels(in_camera, self.loop.K)[0]
        return {
            "time": round(moment.time, 6),
            "u": _to_plain(moment.pixel[0], 2),
            "v": _to_plain(moment.pixel[1], 2),
            "told_u": _to_plain(told_u, 2),
            "told_v": _to_plain(told_v, 2),
            "error_px": _to_plain(off, 3),
            "error_mm": _to_plain(1000 * float(wrong), 2),
            "is_hidden": moment.is_hidden,
            "is_measured": follows,
            "delay_ms": round(1000 * (moment.time - moment.seen_time)),
            "render_ms": round(1000 * moment.render_s),
            "control_ms": round(1000 * moment.control_s, 1),
        }


def describe_problem(error: Exception, control: Control, time: float) -> dict[str, Any]:
    """Say what went wrong in a controller: its kind, its words, and where it happened.

    Parameters
    ----------
    error : Exception
        What `control` has raised, or what was said about its answer.
    control : callable
        Tells which lines are the reader's.
    time : float
        When, in seconds of the run.

    Returns
    -------
    dict
        With ``kind``, ``message``, ``line`` (None where no line of the reader's is to blame),
        ``code`` and ``time``.
    """
    code = getattr(inspect.unwrap(control), "__code__", None)
    file = getattr(code, "co_filename", None)
    own = [one for one in traceback.extract_tb(error.__traceback__) if one.filename == file]
    return {
        "kind": type(error).__name__,
        "message": str(error),
        "line": own[-1].lineno if own else None,
        "code": (own[-1].line or "") if own else "",
        "time": round(time, 6),
    }


def _make_camera() -> mujoco.MjvCamera:
    camera = mujoco.MjvCamera()
    camera.lookat[:] = _LOOK_AT
    camera.distance = _DISTANCE
    camera.azimuth, camera.elevation = _AZIMUTH_DEG, _ELEVATION_DEG
    return camera


def _to_plain(value: float, digits: int) -> float | None:
    return round(float(value), digits) if np.isfinite(value) else None
