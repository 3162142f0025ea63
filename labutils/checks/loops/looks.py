"""Show a controller single pictures, and see what it does: which way it turns, and by what.

Every look starts with an empty memory. What is found is put into a few classes: see `Looks`.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

import mujoco
import numpy as np

from labutils.cameras import get_camera_intrinsics, get_camera_pose
from labutils.checks.loops.drawing import LoopRenderer
from labutils.checks.loops.places import get_place
from labutils.checks.loops.scenario import DT
from labutils.checks.loops.trace import SLACK_RAD, Looks
from labutils.following import FollowingState
from labutils.following.scene import BALL, CAMERA, get_mocap_id, make_following_scene

if TYPE_CHECKING:
    from collections.abc import Callable

_HEIGHT, _WIDTH = 120, 160

#: How far the ball is to the side and below, in radians, and how far away, in meters.
_ANGLE = np.array([-0.12, 0.1])
_METERS = 0.7

#: Who needs two pictures to begin gets some more.
_CALLS = 3

#: Shares of the angle: less is no turn, more is none that a gain explains.
_NOTHING, _TOO_MUCH = 0.05, 4.0

#: So long is the ball beyond the limit, and so long may a command stay there when it is back.
_WINDING, _UNWINDING = 40, 8
#: Stays at the limit: nearer to it than this.
_AT_LIMIT = 0.05

#: Where a look shows nothing that has a class: it stops, or turns this way once and then that.
_UNCLEAR = 9


class _Picture(NamedTuple):
    rgb: np.ndarray
    depth: np.ndarray
    T_world_cam: np.ndarray


class _Stage:
    """The scene for single pictures, and what is the same in all of them."""

    def __init__(self) -> None:
        self.model, self.data = make_following_scene()
        self.K, _ = get_camera_intrinsics(self.model, CAMERA, _WIDTH, _HEIGHT)
        self.limits = tuple((float(a), float(b)) for a, b in self.model.actuator_ctrlrange)
        self._ball = get_mocap_id(self.model, BALL)

    @cache  # noqa: B019 - there is one stage, which stays
    def take(self, neck: tuple[float, ...], off: tuple[float, ...], *, blind: bool) -> _Picture:
        """Take the picture of a ball that is off the middle by two angles."""
        pan, tilt = np.add(neck, off)
        self.data.mocap_pos[self._ball] = get_place(self.model, self.data, pan, tilt, _METERS)
        self.data.qpos[:2] = neck
        mujoco.mj_forward(self.model, self.data)
        T = get_camera_pose(self.model, self.data, CAMERA)
        whole = ((-1.0, np.inf),) if blind else ()
        renderer = LoopRenderer(self.model, _HEIGHT, _WIDTH, blind=whole)
        renderer.update_scene(self.data)
        rgb = renderer.render()
        renderer.enable_depth_rendering()
        return _Picture(rgb, renderer.render(), T)


_get_stage = cache(_Stage)


class _Asking:
    """A controller with a fresh memory, and the time that passes from picture to picture."""

    def __init__(self, decide: Callable[..., Any]) -> None:
        self._decide = decide
        self._memory: dict[str, Any] = {}
        self._count = 0

    def ask(
        self, neck: np.ndarray, off: np.ndarray, *, now: Any = None, blind: bool = False
    ) -> np.ndarray:
        """Return the command for a picture; NaN where it stops."""
        stage = _get_stage()
        seen = tuple(map(float, neck))
        picture = stage.take(seen, tuple(map(float, off)), blind=blind)
        pan, tilt = map(float, seen if now is None else now)
        self._count += 1
        state = FollowingState(
            time=self._count * DT,
            dt=DT,
            pan=pan,
            tilt=tilt,
            seen_time=(self._count - 1) * DT,
            seen_pan=seen[0],
            seen_tilt=seen[1],
            T_world_cam=picture.T_world_cam.copy(),
            limits=stage.limits,  # type: ignore[arg-type]
            memory=self._memory,
        )
        try:
            command = self._decide(picture.rgb.copy(), picture.depth.copy(), stage.K.copy(), state)
        except Exception:  # noqa: BLE001 - whatever a learner's code raises where no loop led it
            return np.full(2, np.nan)
        return np.asarray(command, dtype=np.float64)


def take_looks(decide: Callable[..., Any]) -> Looks:
    """Show all single pictures.

    Parameters
    ----------
    decide : callable
        ``decide(rgb, depth, K, state)`` returns pan and tilt, float64 (2,), of whatever size.
    """
    one, other = _turn(decide, _ANGLE), _turn(decide, -_ANGLE)
    shares = np.array([one / _ANGLE, other / -_ANGLE])
    blind = _turn(decide, _ANGLE, blind=True)
    is_same = np.abs(blind - one) <= 0.5 * np.abs(one)
    pan, size = _classify_sign(shares[:, 0]), _classify_size(shares)
    return Looks(
        pan=pan,
        tilt=_classify_sign(shares[:, 1]),
        size=size,
        # Of commands that are cut off at once, or lead to the other limit, this says nothing.
        stale=int(size == 1 and _is_stale(decide)),
        beyond=int(_is_beyond(decide)),
        blind=int(not is_same.all()),
        winds=int(size == 1 and pan == 1 and _winds(decide)),
    )


def _turn(decide: Callable[..., Any], off: np.ndarray, *, blind: bool = False) -> np.ndarray:
    """Return by what it turns, looking straight ahead: in the first call in which it does."""
    asking = _Asking(decide)
    turned = np.zeros(2)
    for _ in range(_CALLS):
        turned = asking.ask(np.zeros(2), off, blind=blind)
        if not (np.abs(turned) < _NOTHING * np.abs(off)).all():
            break
    return turned


def _classify_sign(shares: np.ndarray) -> int:
    signs = np.where(np.abs(shares) < _NOTHING, 0, np.sign(shares))
    return int(signs[0]) if signs[0] == signs[1] else _UNCLEAR


def _classify_size(shares: np.ndarray) -> int:
    if not np.isfinite(shares).all():
        return _UNCLEAR
    largest = np.abs(shares).max()
    return 0 if largest < _NOTHING else 1 + int(largest > _TOO_MUCH)


def _is_stale(decide: Callable[..., Any]) -> bool:
    """Tell whether the pose of now counts in full although the angle does, too.

    Right is the pose of the picture plus the angle; or of the pose of now as much less as of the
    angle more, as where the last command is followed in part.
    """
    moved = np.array([0.16, -0.12])
    commands = []
    for now in (np.zeros(2), moved):
        asking = _Asking(decide)
        for _ in range(_CALLS):
            command = asking.ask(np.zeros(2), _ANGLE, now=now)
        commands.append(command)
    of_now = (commands[1] - commands[0]) / moved
    of_angle = np.clip(np.abs(commands[0] / _ANGLE), 0.0, 1.0)
    return bool(((of_angle > _NOTHING) & (of_now > 1 - of_angle / 2)).any())


def _is_beyond(decide: Callable[..., Any]) -> bool:
    """Tell whether a ball beside a limit, on either side of it, leads beyond."""
    low, high = np.array(_get_stage().limits).T
    for neck in (low + 0.02, high - 0.02):
        for off in (0.2, -0.2):
            command = _Asking(decide).ask(neck, np.array([off, 0.75 * off]))
            if (command < low - SLACK_RAD).any() or (command > high + SLACK_RAD).any():
                return True
    return False


def _winds(decide: Callable[..., Any]) -> bool:
    """Tell whether a command stays at its limit long after the ball has come back."""
    high = _get_stage().limits[0][1]
    neck = np.array([high, 0.4])
    asking = _Asking(decide)
    for _ in range(_WINDING):
        asking.ask(neck, np.array([0.15, 0.0]))
    for _ in range(_UNWINDING):
        command = asking.ask(neck, np.array([-0.2, 0.0]))
    return bool(command[0] > high - _AT_LIMIT)
