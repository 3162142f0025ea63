"""Let a controller act in a `Loop`, and write down what happens."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import mujoco
import numpy as np

from labutils._constants import FULL_WIDTH
from labutils.checks.loops.drawing import LoopRenderer
from labutils.checks.loops.looks import take_looks
from labutils.checks.loops.places import PointPath, get_place
from labutils.checks.loops.scenario import DT
from labutils.checks.loops.trace import BOUND_PX, COLUMNS, PROPERTIES, Column
from labutils.following import FollowingLoop, FollowingState
from labutils.following.scene import make_following_scene

if TYPE_CHECKING:
    from collections.abc import Callable

    from labutils.checks.loops.scenario import Loop

    Decide = Callable[[np.ndarray, np.ndarray, np.ndarray, FollowingState], np.ndarray]

#: Small pictures, as on a page: checks are to answer while somebody waits.
WIDTH, HEIGHT = 160, 120

#: More than the picture is wide: where a ball behind the camera counts as being.
_LOST_PX = 2000.0


class Told(NamedTuple):
    """What a controller was asked, and what it answered; the last of a loop explains a stop."""

    args: tuple[np.ndarray, np.ndarray, np.ndarray, FollowingState]
    command: np.ndarray


class _NoCommandError(Exception):
    """A command that no neck can follow: the loop ends here."""


def act(loop: Loop, decide: Decide) -> np.ndarray:
    """Run a loop, and show single pictures afterwards where it says so.

    Parameters
    ----------
    loop : Loop
        What happens to the ball.
    decide : callable
        ``decide(rgb, depth, K, state)`` returns pan and tilt, float64 (2,), of whatever size.

    Returns
    -------
    ndarray, float64, shape (N, COLUMNS)
        A row per call; see `Column` and `Looks`.
    """
    rows: list[np.ndarray] = []
    with _make_loop(loop) as following:
        for _ in range(round(loop.seconds / DT)):
            row = np.full(COLUMNS, np.nan)
            rows.append(row)
            if not _act_once(loop, following, decide, row) or _is_lost(loop, rows):
                break
    trace = np.array(rows)
    if loop.has_looks:
        trace[:, len(Column) :] = take_looks(decide)
    return trace


def _is_lost(loop: Loop, rows: list[np.ndarray]) -> bool:
    """Tell whether no mean of this loop can come near its bound: the rest need not be drawn."""
    longest = max((end - start for _, start, end in loop.windows), default=np.inf)
    total = sum(row[Column.ERROR_PX] for row in rows if row[Column.MEASURED])
    return bool(total > 10 * BOUND_PX * longest / DT)


def _make_loop(loop: Loop) -> FollowingLoop:
    path = None
    if loop.places:
        scene = make_following_scene()
        points = [get_place(*scene, *place) for _, *place in loop.places]
        path = PointPath([time for time, *_ in loop.places], points)
    following = FollowingLoop(
        WIDTH,
        HEIGHT,
        seed=loop.seed,
        speed=1.0 if loop.places else loop.speed,
        delay=loop.delay,
        noise=loop.noise,
        hidden=loop.hidden,
        path=path,
        renderer_maker=partial(LoopRenderer, blind=loop.blind),
    )
    if loop.neck:
        following.data.qpos[:2] = loop.neck
        mujoco.mj_forward(following.model, following.data)
    return following


def _act_once(loop: Loop, following: FollowingLoop, decide: Decide, row: np.ndarray) -> bool:
    """Fill one row; return whether the neck got a command that it can follow."""
    limits = following.model.actuator_ctrlrange.T

    def control(*args: object) -> object:
        command = decide(*args)  # type: ignore[arg-type]
        row[Column.BEYOND] = np.max(np.maximum(limits[0] - command, command - limits[1]))
        if not np.isfinite(command).all():
            raise _NoCommandError
        row[Column.BEYOND] = max(row[Column.BEYOND], 0.0)
        return command

    row[[Column.TIME, Column.IS_HIDDEN]] = following.time, following.is_hidden
    row[Column.MEASURED] = _find_measured(loop, following.time)
    try:
        moment = following.step(control)
    except _NoCommandError:
        row[Column.BEYOND], row[Column.ERROR_PX] = np.inf, _LOST_PX
        return False
    off = float(np.hypot(*(moment.pixel - following.K[:2, 2])))
    # Behind the camera there is no pixel: fmin takes the number of the two.
    row[Column.ERROR_PX] = np.fmin(off * FULL_WIDTH / WIDTH, _LOST_PX)
    row[[Column.PAN, Column.TILT]] = moment.command
    return True


def _find_measured(loop: Loop, now: float) -> int:
    """Return the number of the property that is measured now; 0 for none."""
    for name, start, end in loop.windows:
        if start - 1e-9 <= now < end - 1e-9:
            return PROPERTIES.index(name)
    return 0
