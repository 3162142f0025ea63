"""Take complications out of cases, one at a time: a check asks a wrong function whether that helps.

Whoever is right as soon as the camera is not turned has trouble with its rotation. A simplification
changes the arguments of a case into others that are valid, too.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from labutils import find_valid_depth
from labutils.checks.explain.arguments import find_places, with_argument
from labutils.checks.inputs import is_same
from labutils.checks.kinds import get_kind
from labutils.checks.table import Case, Simpler

if TYPE_CHECKING:
    from labutils.checks.table import CheckTable
    from solutions._model import Exercise

#: From the arguments of a case by name, those that change.
Change: TypeAlias = Callable[[dict[str, Any]], dict[str, Any]]


@dataclass(frozen=True)
class Simplification:
    """One complication: its name, a clause that follows "as soon as", and what takes it away."""

    name: str
    words: str
    change: Change


def put(**values: Any) -> Change:
    """Return the change that gives arguments other values."""
    return lambda _: values


def simplify(exercise: Exercise, table: CheckTable) -> tuple[Simpler, ...]:
    """Make the simpler cases of an exercise, with their right answers.

    A case that stays as it is, or whose right answer is without any number, is left out.
    """
    found = []
    places = find_places(table)
    for one in (*list_valid(exercise), *exercise.simpler, *list_common(exercise)):
        numbers: list[int] = []
        cases: list[Case] = []
        for number, case in enumerate(table.cases):
            if case.raises:
                continue
            changed = change_arguments(case, places, one.change)
            if not is_same(changed.args, case.args):
                numbers.append(number)
                cases.append(replace(changed, label=""))
        if not cases:
            continue
        expected = exercise.collect_due(tuple(cases))
        kept = [n for n, due in enumerate(expected) if isinstance(due, tuple) and _says_much(due)]
        found.append(
            Simpler(
                one.name,
                one.words,
                tuple(numbers[n] for n in kept),
                tuple(cases[n] for n in kept),
                tuple(expected[n] for n in kept),
            )
        )
    return tuple(one for one in found if one.cases)


def change_arguments(case: Case, places: dict[str, int], change: Change) -> Case:
    """Return a case with a change of its arguments by name; a scene stays as it is."""
    given = {name: case.args[place] for name, place in places.items()}
    copies = {
        name: value.copy() if isinstance(value, np.ndarray) else value
        for name, value in given.items()
    }
    for name, value in change(copies).items():
        case = with_argument(case, places[name], value)
    return case


def _says_much(due: tuple[Any, ...]) -> bool:
    """Tell whether an answer holds numbers that are not all alike."""
    return any(
        part is not None and part.size and (part.dtype.kind != "f" or np.isfinite(part).any())
        for part in due
    )


# ---- What makes many exercises hard


def list_valid(exercise: Exercise) -> tuple[Simplification, ...]:
    """List the first of all complications, where there is a depth image: invalid pixels.

    Not where they are all that the exercise is about, or where its card knows better.
    """
    known = {one.name for one in exercise.simpler}
    if "depth_metric" not in exercise.parameters[:-1] or "all-valid" in known:
        return ()
    return (Simplification("all-valid", "no pixel is invalid", fill_invalid),)


def list_common(exercise: Exercise) -> tuple[Simplification, ...]:
    """List the complications that follow from the names of the arguments.

    Where points or pixels are given beside the camera, they would have to move with it.
    """
    names = exercise.parameters
    if {"points_world", "pixels"} & set(names) or not _is_repeatable(exercise):
        return ()
    found = []
    if "K" in names:
        found += [
            Simplification("square-pixels", "fx and fy are equal", _square_pixels),
            Simplification("centered", "the principal point is pixel (0, 0)", _center),
        ]
    if {"width", "height"} <= set(names):
        found.append(Simplification("square", "the picture is as high as it is wide", _square))
    return tuple(found)


def _is_repeatable(exercise: Exercise) -> bool:
    """Tell whether its arguments stand in its cases, instead of being made while it acts."""
    return all(get_kind(part).is_repeatable for part in exercise.parts)


def _square_pixels(args: dict[str, Any]) -> dict[str, Any]:
    K = args["K"]
    K[1, 1] = K[0, 0]
    return {"K": K}


def _center(args: dict[str, Any]) -> dict[str, Any]:
    K = args["K"]
    K[:2, 2] = 0
    return {"K": K}


def _square(args: dict[str, Any]) -> dict[str, Any]:
    return {"height": args["width"]}


def fill_invalid(args: dict[str, Any]) -> dict[str, Any]:
    """Give every invalid pixel the median depth; 1 m where there is none."""
    depth = args["depth_metric"]
    valid = find_valid_depth(depth)
    depth[~valid] = np.median(depth[valid]) if valid.any() else 1.0
    return {"depth_metric": depth}


def stay_straight(pose: str) -> Change:
    """Return the change that turns a pose straight, at its place, and points_world with it."""
    return partial(_move, pose, face_along)


def stay_at_origin(pose: str) -> Change:
    """Return the change that moves a pose to the origin, and points_world with it."""
    return partial(_move, pose, move_to_origin)


def _move(
    pose: str, change: Callable[[np.ndarray], np.ndarray], args: dict[str, Any]
) -> dict[str, Any]:
    old = args[pose]
    new = change(old)
    return {pose: new, "points_world": carry(args["points_world"], old, new)}


def face_along(T: np.ndarray) -> np.ndarray:
    """Return a pose at the same place, not turned."""
    straight = np.eye(4)
    straight[:3, 3] = T[:3, 3]
    return straight


def move_to_origin(T: np.ndarray) -> np.ndarray:
    """Return a pose turned the same way, at the origin."""
    moved = T.copy()
    moved[:3, 3] = 0
    return moved


def carry(points: np.ndarray, old: np.ndarray, new: np.ndarray) -> np.ndarray:
    """Move points with a pose, so that they look the same from it."""
    motion = new @ np.linalg.inv(old)
    return np.asarray(points @ motion[:3, :3].T + motion[:3, 3])
