"""Run the example of an exercise as a learner does: below a function, on its page."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import jupytext

from solutions import Exercise
from tests.helpers.chapters import ROOT


@cache
def read_set_up(page: str) -> tuple[str, ...]:
    """Read the cells of an exercise page that stand before its first exercise."""
    cells = jupytext.read((ROOT / page).with_suffix(".md")).cells
    code = [cell for cell in cells if cell.cell_type == "code"]
    first = next(n for n, cell in enumerate(code) if "exercise" in cell.metadata.get("tags", []))
    return tuple(cell.source for cell in code[:first])


def make_names(exercise: Exercise) -> dict[str, Any]:
    """Run the cells that set up the page of an exercise, and the imports of its starter."""
    names: dict[str, Any] = {}
    for code in (*read_set_up(exercise.home.exercises), "\n".join(exercise.imports)):
        exec(code, names)  # noqa: S102 - our own page
    return names


def run_example(
    exercise: Exercise, function: Callable[..., Any], names: dict[str, Any]
) -> None:
    """Run the example of an exercise with a function under its name."""
    exec(exercise.example, {**names, exercise.name: function})  # noqa: S102 - our own card
