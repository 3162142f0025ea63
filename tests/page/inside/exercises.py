"""What the checks say of references, starters and known mistakes: in the page, and here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import solutions
from labutils.checks import judge
from labutils.checks.kinds import get_kind
from labutils.checks.table import load_table
from solutions import load_exercises

_STARTERS = Path(solutions.__file__).parents[1] / "exercises" / "_generated"


def judge_all() -> dict[str, list[Any]]:
    """Return what is said of each function: the result, the property and the name of a mistake."""
    return {label: said for name in load_exercises() for label, said in _judge_all(name).items()}


def _judge_all(name: str) -> dict[str, list[Any]]:
    exercise = load_exercises()[name]
    starter: dict[str, Any] = {}
    source = (_STARTERS / f"{name}.py").read_text(encoding="utf-8")
    exec(compile(source, name, "exec"), starter)  # noqa: S102 - our own derived file
    combinations = exercise.get_combinations()
    if not all(get_kind(part).is_repeatable for part in exercise.parts):
        # Loops take seconds in the page: one mistake at a time shows what is computed there.
        combinations = tuple(made for made in combinations if len(made) == 1)
    functions = {
        "reference": exercise.reference,
        "starter": starter[name],
        **{" + ".join(made): exercise.make_wrong(made) for made in combinations},
    }
    return {f"{name}: {label}": _judge(name, one) for label, one in functions.items()}


def _judge(name: str, function: Any) -> list[Any]:
    verdict = judge(load_table(name), function)
    return [verdict.result, verdict.property, verdict.misconception]
