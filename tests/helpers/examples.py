"""Run the example of an exercise as a learner does: below a function, on its page."""

from __future__ import annotations

import contextlib
import io
import json
from collections.abc import Callable
from functools import cache
from typing import Any

import jupytext

from solutions import Exercise, load_exercises
from tests.helpers.chapters import ROOT


def _read_set_up(page: str) -> tuple[str, ...]:
    """Read the cells of an exercise page that stand before its first exercise."""
    cells = jupytext.read((ROOT / page).with_suffix(".md")).cells
    code = [cell for cell in cells if cell.cell_type == "code"]
    first = next(n for n, cell in enumerate(code) if "exercise" in cell.metadata.get("tags", []))
    return tuple(cell.source for cell in code[:first])


@cache
def run_set_up(page: str) -> dict[str, Any]:
    """Run the cells of an exercise page that stand before its first exercise, once a process."""
    names: dict[str, Any] = {}
    for code in _read_set_up(page):
        exec(code, names)  # noqa: S102 - our own page
    return names


def make_names(exercise: Exercise) -> dict[str, Any]:
    """Return what the cells at the top of an exercise's page and its starter's imports make.

    The objects are shared by all examples of the page, which leave them as they are.
    """
    names = dict(run_set_up(exercise.home.exercises))
    exec("\n".join(exercise.imports), names)  # noqa: S102 - our own card
    return names


def run_example(exercise: Exercise, function: Callable[..., Any], names: dict[str, Any]) -> str:
    """Run an example with a function under its name; return what it prints, pictures in words."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(exercise.example, {**names, exercise.name: function})  # noqa: S102 - our own card
    return printed.getvalue()


def run_all() -> None:
    """Print as JSON what the example of every reference prints."""
    print(
        json.dumps(
            {
                name: run_example(exercise, exercise.reference, make_names(exercise))
                for name, exercise in load_exercises().items()
            }
        )
    )
