"""Other values of one argument, valid and of the same size: what probes call again with."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.loops.scenario import Loop
from labutils.checks.table import Scene

if TYPE_CHECKING:
    from collections.abc import Iterator

    from labutils.checks.table import Case, CheckTable


def find_places(table: CheckTable) -> dict[str, int]:
    """Return where the arguments that are no part of a scene stand in a case.

    A scene, or a loop, stands once in a case and fills several parameters.
    """
    names = list(table.parameters)
    found: dict[str, int] = {}
    for place, value in enumerate(table.cases[0].args):
        if isinstance(value, Scene | Loop):
            del names[: len(value.gives)]
        else:
            found[names.pop(0)] = place
    return found


def with_argument(case: Case, place: int, value: Any) -> Case:
    """Return a case with another value of one argument."""
    return replace(case, args=(*case.args[:place], value, *case.args[place + 1 :]))


def list_others(table: CheckTable, place: int, case: Case) -> list[Any]:
    """List other values of an argument: two at least, since one change may be a symmetry.

    Empty where no other value is known to be valid.
    """
    value = case.args[place]
    if isinstance(value, bool) or value is None:
        return []
    if isinstance(value, float):
        return [value * 1.3, value * 0.8]
    if isinstance(value, int):
        return [value * 2 + 7, value + 4]
    if isinstance(value, np.ndarray):
        return _list_other_arrays(value)
    if isinstance(value, str | tuple):
        return [
            other.args[place]
            for other in table.cases
            if not other.raises
            and type(other.args[place]) is type(value)
            and other.args[place] != value
        ]
    return []


def _list_other_arrays(value: np.ndarray) -> list[np.ndarray]:
    if value.ndim == 0 or value.size < 2:
        return []
    moved = [value[::-1].copy(), np.roll(value, 3, -1 if value.ndim == 2 else 0)]
    return [*moved, value * 0.7] if value.dtype.kind == "f" else [*moved, np.zeros_like(value)]


def list_entries(name: str, value: Any) -> Iterator[tuple[str, int]]:
    """Name the entries of K and of short vectors, with their place in the flat array."""
    if not isinstance(value, np.ndarray) or value.dtype.kind != "f":
        return
    if value.shape == (3, 3) and name == "K":
        for row, column in ((0, 0), (1, 1), (0, 2), (1, 2)):
            yield f"K[{row}, {column}]", 3 * row + column
    elif value.shape == (3,):
        for place in range(3):
            yield f"{name}[{place}]", place


def list_other_entries(place: int, flat: int, case: Case) -> list[Any]:
    """List copies of an array among the arguments, with another value in one entry."""
    value = case.args[place]
    found: list[Any] = []
    for factor, shift in ((1.2, 0.1), (0.7, -0.2)):
        other = value.copy()
        other.flat[flat] = other.flat[flat] * factor + shift
        found.append(other)
    return found
