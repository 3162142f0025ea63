"""Find the code of a card: its own functions, and what they call outside of the library."""

from __future__ import annotations

import inspect
from types import CodeType
from typing import TYPE_CHECKING, Any

import labutils

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from solutions import Exercise


def is_answered_by_library(exercise: Exercise) -> bool:
    """Tell a lab exercise, whose answer everybody has in labutils, from a challenge."""
    return getattr(labutils, exercise.name, None) is exercise.reference


def find_called(*functions: Callable[..., Any]) -> list[Callable[..., Any]]:
    """List functions, and what they call of the same packages, in the order of the calls.

    The packages are those of the functions and ``solutions``. Of the library nothing is
    listed: it shows its code itself.
    """
    homes = {"solutions", *map(_get_package, functions)} - {"labutils"}
    found: list[Callable[..., Any]] = [
        one for one in functions if inspect.isfunction(one) and _get_package(one) in homes
    ]
    for one in found:
        for name in _list_names(one.__code__):
            called = one.__globals__.get(name)
            if inspect.isfunction(called) and called not in found and _get_package(called) in homes:
                found.append(called)
    return found


def _get_package(function: Callable[..., Any]) -> str:
    return function.__module__.split(".")[0]


def _list_names(code: CodeType) -> Iterator[str]:
    """List the names a function uses, those inside its comprehensions too."""
    yield from code.co_names
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            yield from _list_names(inner)
