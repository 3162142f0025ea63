"""Code of a learner as text, run as a notebook or the page runs a cell."""

from __future__ import annotations

import linecache
from collections.abc import Callable
from itertools import count
from typing import Any

from labutils.checks.calls import collect_answers
from labutils.checks.table import Raised, load_table

IMPORTS = "import math\nimport cv2\nimport mujoco\nimport numpy as np\n"

_NUMBERS = count()


def add_cell(code: str) -> str:
    """Let tracebacks show the lines of code, as notebooks and the page do; name it."""
    name = f"cell {next(_NUMBERS)}"
    linecache.cache[name] = (len(code), None, code.splitlines(keepends=True), name)
    return name


def run_cell(code: str, name: str) -> dict[str, Any]:
    namespace: dict[str, Any] = {"__name__": "__main__"}
    exec(compile(code, name, "exec", dont_inherit=True), namespace)  # noqa: S102 - a cell
    return namespace


def stop(function: Callable[..., object], *arguments: object) -> Exception:
    """Call what has to stop; return the exception, whatever it is."""
    try:
        function(*arguments)
    except Exception as error:  # noqa: BLE001 - of every kind
        return error
    raise AssertionError("nothing stopped")


def write(exercise: str, body: str, before: str = IMPORTS) -> Callable[..., Any]:
    """Write a learner's function: the parameters of the starter, another body."""
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    code = f"{before}\ndef {exercise}({', '.join(load_table(exercise).parameters)}):\n{lines}"
    function: Callable[..., Any] = run_cell(code, add_cell(code))[exercise]
    return function


def find_raised(exercise: str, function: Callable[..., Any]) -> Raised:
    """Return the first exception of the visible cases that is not due."""
    table = load_table(exercise)
    answers = collect_answers(table, function)
    return next(
        answer
        for case, answer in zip(table.cases, answers, strict=True)
        if isinstance(answer, Raised) and case.raises != answer.kind
    )
