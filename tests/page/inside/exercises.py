"""What the checks say of references, starters and known mistakes: in the page, and here."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import solutions
from labutils.checks import judge
from labutils.checks.table import load_table
from solutions import load_exercises

#: The exercises whose cases need a simulator.
NEED_MUJOCO = ("render_camera", "get_camera_intrinsics", "rank_cameras")
_STARTERS = Path(solutions.__file__).parents[1] / "exercises" / "_generated"


def judge_those_that_need_mujoco() -> dict[str, list[Any]]:
    return {label: said for name in NEED_MUJOCO for label, said in _judge_all(name).items()}


def judge_the_references_of_the_others() -> dict[str, list[Any]]:
    return {
        f"{name}: reference": _judge(name, exercise.reference)
        for name, exercise in load_exercises().items()
        if name not in NEED_MUJOCO
    }


def _judge_all(name: str) -> dict[str, list[Any]]:
    exercise = load_exercises()[name]
    starter: dict[str, Any] = {}
    source = (_STARTERS / f"{name}.py").read_text(encoding="utf-8")
    exec(compile(source, name, "exec"), starter)  # noqa: S102 - our own derived file
    functions = {
        "reference": exercise.reference,
        "starter": starter[name],
        **{" + ".join(made): exercise.make_wrong(made) for made in exercise.get_combinations()},
    }
    return {f"{name}: {label}": _judge(name, one) for label, one in functions.items()}


def _judge(name: str, function: Any) -> list[Any]:
    verdict = judge(load_table(name), function)
    return [verdict.result, verdict.property, verdict.misconception]
