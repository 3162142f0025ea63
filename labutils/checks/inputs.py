"""Watch whether the arguments of a call come back as they went in.

Every statement says that they stay as they are: whoever calls a function goes on with them.
"""

from __future__ import annotations

import copy
from functools import wraps
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.calls import call_once, unify_answers
from labutils.checks.table import Scene

if TYPE_CHECKING:
    from collections.abc import Callable

    from labutils.checks.table import Case, CheckTable, Outcome

#: What a simulation goes on from. Velocities and forces that follow from these are brought up to
#: date by whoever draws a picture, and count as unchanged.
_STATE = ("time", "qpos", "qvel", "act", "ctrl", "mocap_pos", "mocap_quat", "userdata")

#: What others read without computing it anew: as it was before, or as MuJoCo computes it.
_PLACES = (
    *("xpos", "xmat", "geom_xpos", "geom_xmat", "site_xpos", "site_xmat"),
    *("cam_xpos", "cam_xmat", "light_xpos", "light_xdir"),
)
#: Meters, and parts of a unit vector: rounding, whatever order MuJoCo computes in.
_ROUNDING = 1e-9


def collect_and_watch(
    table: CheckTable, function: Callable[..., object]
) -> tuple[tuple[Outcome, ...], tuple[str, ...]]:
    """Call the function once per case, as `collect_answers` does, and watch its arguments.

    Returns
    -------
    answers : tuple of Outcome
        One per case.
    changed : tuple of str
        The arguments that came back changed in some case, in the order of the statement.
    """
    answers = []
    changed: set[str] = set()
    for case in table.cases:
        watches: list[Watch] = []
        answers.append(call_once(table.parts, case, _watch(table, case, function, watches)))
        changed |= {name for watch in watches for name in watch.find_changed()}
    in_order = tuple(name for name in table.parameters if name in changed)
    return unify_answers(table, tuple(answers)), in_order


def _watch(
    table: CheckTable, case: Case, function: Callable[..., object], watches: list[Watch]
) -> Callable[..., object]:
    """Return the function with a look at its arguments before; it passes for the learner's own."""

    @wraps(function)
    def watched(*args: Any) -> object:
        watches.append(Watch(case, args, table.parameters))
        return function(*args)

    return watched


class Watch:
    """The arguments of one call as they were before it.

    Parameters
    ----------
    case : Case
        The case they were made from.
    args : tuple
        What the function is called with: copies that it may write into.
    parameters : tuple of str
        What they are called.
    """

    def __init__(self, case: Case, args: tuple[Any, ...], parameters: tuple[str, ...]) -> None:
        self._named = dict(zip(parameters, args, strict=False))
        self._scene = next((value for value in case.args if isinstance(value, Scene)), None)
        given = self._scene.gives if self._scene else ()
        self._before = {
            name: _copy(value) for name, value in self._named.items() if name not in given
        }
        self._state = None
        if self._scene:
            self._before |= _read_scene(self._named)
            # A copy holds all that was computed, too.
            self._state = copy.copy(self._named.get("data"))

    def find_changed(self) -> tuple[str, ...]:
        """Name the arguments that are not as they were."""
        after = dict(self._named)
        if self._scene:
            after |= _read_scene(self._named)
        changed = tuple(
            name for name, value in self._before.items() if not is_same(value, after[name])
        )
        # What MuJoCo computes of another model, or of another state, says nothing.
        if self._state is None or {"model", "data"} & set(changed):
            return changed
        model, data = self._named["model"], self._named["data"]
        return (*changed, "data") if _are_places_spoiled(model, self._state, data) else changed


def _read_scene(named: dict[str, Any]) -> dict[str, Any]:
    """Read the model as bytes and the state as arrays."""
    import mujoco  # noqa: PLC0415 - every other exercise runs without it

    found: dict[str, Any] = {}
    for name, value in named.items():
        if isinstance(value, mujoco.MjModel):
            content = np.zeros(mujoco.mj_sizeModel(value), np.uint8)
            mujoco.mj_saveModel(value, None, content)
            found[name] = content
        elif isinstance(value, mujoco.MjData):
            found[name] = [np.array(getattr(value, one)) for one in _STATE]
    return found


def _are_places_spoiled(model: Any, before: Any, after: Any) -> bool:
    """Tell whether some places are neither as they were nor as MuJoCo computes them.

    Of the same state, so what was stale may have been brought up to date in part.
    """
    import mujoco  # noqa: PLC0415 - every other exercise runs without it

    moved = [name for name in _PLACES if not _is_near(before, after, name)]
    if not moved:
        return False
    full, partly = copy.copy(after), copy.copy(before)
    mujoco.mj_forward(model, full)
    # Without mj_comPos between the two: cameras that follow a center of mass stay behind.
    mujoco.mj_kinematics(model, partly)
    mujoco.mj_camlight(model, partly)
    return not all(any(_is_near(one, after, name) for one in (full, partly)) for name in moved)


def _is_near(one: Any, other: Any, name: str) -> bool:
    pair = getattr(one, name), getattr(other, name)
    return bool(np.allclose(*pair, rtol=0, atol=_ROUNDING, equal_nan=True))


def _copy(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.copy()
    if isinstance(value, list):
        return [_copy(one) for one in value]
    if isinstance(value, dict):
        return {key: _copy(one) for key, one in value.items()}
    return value


def is_same(one: Any, other: Any) -> bool:
    """Tell whether two values agree to the last bit, arrays in their dtype too."""
    if isinstance(one, np.ndarray):
        return (
            isinstance(other, np.ndarray)
            and one.dtype == other.dtype
            and bool(np.array_equal(one, other, equal_nan=one.dtype.kind == "f"))
        )
    if isinstance(one, list | tuple):
        return (
            isinstance(other, list | tuple)
            and len(one) == len(other)
            and all(is_same(x, y) for x, y in zip(one, other, strict=True))
        )
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(is_same(one[key], other[key]) for key in one)
    if isinstance(other, np.ndarray):
        return False  # None == array compares element by element
    return one is other or bool(one == other)
