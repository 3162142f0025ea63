"""Count the steps of an exercise's solution, and rate the exercise by them."""

from __future__ import annotations

import ast
import inspect
import textwrap
from typing import TYPE_CHECKING

from content.difficulty import Difficulty, rate

if TYPE_CHECKING:
    from collections.abc import Sequence

    from solutions import Exercise

#: Statements inside a statement.
BLOCKS = ("body", "orelse", "finalbody")


def rate_exercise(exercise: Exercise) -> Difficulty:
    """Return the level of an exercise."""
    return rate(count_steps(inspect.getsource(exercise.reference)), len(exercise.objectives))


def count_steps(source: str) -> int:
    """Count the statements of a function, those inside others too, checks of arguments not.

    Parameters
    ----------
    source : str
        The code of one function.
    """
    function = ast.parse(textwrap.dedent(source)).body[0]
    if not isinstance(function, ast.FunctionDef):
        raise TypeError(f"source: expected a function, got {type(function).__name__}")
    return _count(function.body)


def _count(statements: Sequence[ast.stmt]) -> int:
    return sum(
        1 + sum(_count(getattr(one, block, [])) for block in BLOCKS)
        for one in statements
        if not _is_check(one)
    )


def _is_check(statement: ast.stmt) -> bool:
    """Tell whether a statement is a docstring or does nothing but refuse arguments."""
    match statement:
        case ast.Raise() | ast.Expr(value=ast.Constant()):
            return True
        case ast.If(body=body):
            return any(isinstance(one, ast.Raise) for one in body)
        case ast.Assign(value=ast.Call(func=called)) | ast.Expr(value=ast.Call(func=called)):
            return ast.unparse(called).startswith("check_")
        case _:
            return False
