"""Changes of one argument after which a function that is wrong may answer right.

Whoever mixes up degrees and radians, a matrix and its transpose, or width and height, is right as
soon as the argument is what they took it for.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.explain.arguments import find_places, with_argument

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from labutils.checks.table import Case, CheckTable


@dataclass(frozen=True)
class Repair:
    """A change of a case; the text goes before "your answer would be right"."""

    name: str
    text: str
    change: Callable[[Case], Case | None]


def list_repairs(table: CheckTable) -> Iterator[Repair]:
    """List the repairs that make sense for the arguments of an exercise."""
    places = find_places(table)
    for name, place in places.items():
        for key, words, change in _list_changes(name, table.cases[0].args[place]):
            yield Repair(f"{name}:{key}", f"With {words},", partial(_change_one, place, change))
    for one, other in itertools.combinations(places, 2):
        if _are_alike(table, places[one], places[other]):
            yield Repair(
                f"swap:{one}:{other}",
                f"With {one} and {other} exchanged,",
                partial(_swap, places[one], places[other]),
            )
            for taken, meant in ((one, other), (other, one)):
                yield Repair(
                    f"same:{taken}:{meant}",
                    f"With {meant} in place of {taken},",
                    partial(_copy, places[taken], places[meant]),
                )


def _change_one(place: int, change: Callable[[Any], Any], case: Case) -> Case | None:
    try:
        return with_argument(case, place, change(case.args[place]))
    except (ValueError, TypeError, np.linalg.LinAlgError):
        return None


def _swap(one: int, other: int, case: Case) -> Case:
    exchanged = with_argument(case, one, case.args[other])
    return with_argument(exchanged, other, case.args[one])


def _copy(place: int, source: int, case: Case) -> Case:
    return with_argument(case, place, case.args[source])


def _are_alike(table: CheckTable, one: int, other: int) -> bool:
    """Tell whether two arguments could be taken for each other: numbers, or arrays of one shape."""
    for case in table.cases:
        a, b = case.args[one], case.args[other]
        if any(isinstance(value, str | tuple | bool) or value is None for value in (a, b)):
            return False
        if np.shape(a) != np.shape(b):
            return False
    return True


_Change = tuple[str, str, "Callable[[Any], Any]"]


def _list_changes(name: str, value: Any) -> list[_Change]:  # noqa: PLR0911 - one per type
    """List changes of one argument, each with a short name and words."""
    if isinstance(value, bool):
        return []
    if isinstance(value, float):
        return _list_number_changes(name)
    if isinstance(value, int):
        return [
            ("+1", f"{name} larger by one", lambda v: v + 1),
            ("-1", f"{name} smaller by one", lambda v: v - 1),
        ]
    if not isinstance(value, np.ndarray):
        return []
    if value.shape in ((3, 3), (4, 4), (9,)):
        return _list_matrix_changes(name, value.size)
    if value.dtype == np.uint8 and value.ndim == 3:
        return [("bgr", f"red and blue of {name} exchanged", lambda v: v[..., ::-1].copy())]
    if value.dtype.kind == "f" and value.ndim in (1, 2) and value.shape[-1] in (2, 3):
        return _list_vector_changes(name, value.shape[-1])
    return []


def _list_number_changes(name: str) -> list[_Change]:
    changes: list[_Change] = [
        (f"x{factor:.3g}", f"{name} {words}", partial(np.multiply, factor))
        for factor, words in (
            (0.5, "half as large"),
            (2.0, "twice as large"),
            (np.pi / 180, "turned into radians first"),
            (180 / np.pi, "turned into degrees first"),
            (-1.0, "of the other sign"),
            (1000.0, "1000 times as large"),
            (0.001, "1000 times as small"),
        )
    ]
    changes += [
        ("+0.5", f"{name} larger by a half", lambda v: v + 0.5),
        ("-0.5", f"{name} smaller by a half", lambda v: v - 0.5),
    ]
    return [(key, words, _as_float(change)) for key, words, change in changes]


def _as_float(change: Callable[[Any], Any]) -> Callable[[Any], float]:
    return lambda value: float(change(value))


def _list_matrix_changes(name: str, size: int) -> list[_Change]:
    side = 3 if size == 9 else 4
    changes: list[_Change] = [
        ("transposed", f"{name} transposed", partial(_turn, side)),
        ("inverted", f"the inverse of {name}", partial(_invert, side)),
    ]
    if name == "K":
        for key, words, pairs in (
            ("focal", "fx and fy exchanged in K", ((0, 4), (4, 0))),
            ("center", "cx and cy exchanged in K", ((2, 5), (5, 2))),
            ("fx", "fx in place of fy in K", ((4, 0),)),
            ("fy", "fy in place of fx in K", ((0, 4),)),
        ):
            changes.append((key, words, partial(_put, pairs)))
        for shift in (0.5, -0.5, 1.0, -1.0):
            side_word = "larger" if shift > 0 else "smaller"
            words = f"the center in K {abs(shift):g} {side_word}"
            changes.append((f"center{shift:+g}", words, partial(_move_center, shift)))
    else:
        for axis, word in enumerate("xyz"):
            words = f"the {word} axis (column {axis}) of {name} of the other sign"
            changes.append((f"column:{axis}", words, partial(_flip_columns, side, (axis,))))
        for axes in ((0, 1), (0, 2), (1, 2)):
            words = f"columns {axes[0]} and {axes[1]} of {name} of the other sign"
            key = f"columns:{axes[0]}{axes[1]}"
            changes.append((key, words, partial(_flip_columns, side, axes)))
    return changes


def _turn(side: int, value: np.ndarray) -> np.ndarray:
    return value.reshape(side, side).T.reshape(value.shape).copy()


def _invert(side: int, value: np.ndarray) -> np.ndarray:
    matrix = value.reshape(side, side)
    # The inverse of a rotation is its transpose: said once.
    if np.allclose(matrix @ matrix.T, np.eye(side)):
        raise ValueError("a rotation")
    return np.linalg.inv(matrix).reshape(value.shape)


def _put(pairs: tuple[tuple[int, int], ...], value: np.ndarray) -> np.ndarray:
    changed = value.copy()
    for place, source in pairs:
        changed.flat[place] = value.flat[source]
    return changed


def _move_center(shift: float, value: np.ndarray) -> np.ndarray:
    changed = value.copy()
    changed.flat[2] += shift
    changed.flat[5] += shift
    return changed


def _flip_columns(side: int, axes: tuple[int, ...], value: np.ndarray) -> np.ndarray:
    changed = value.reshape(side, side).copy()
    changed[:3, list(axes)] *= -1
    return changed.reshape(value.shape)


def _list_vector_changes(name: str, width: int) -> list[_Change]:
    letters = "xyz" if width == 3 else "uv"
    changes: list[_Change] = [
        (f"-{letters[axis]}", f"{letters[axis]} of {name} of the other sign", _flip(axis, width))
        for axis in range(width)
    ]
    changes.append(("negative", f"{name} of the other sign", np.negative))
    changes.append(
        ("reversed", f"the columns of {name} in the reverse order", lambda v: v[..., ::-1].copy())
    )
    return changes


def _flip(axis: int, width: int) -> Callable[[np.ndarray], np.ndarray]:
    signs = np.where(np.arange(width) == axis, -1.0, 1.0)
    return lambda value: (value * signs).astype(value.dtype)
