"""Call a wrong function on simpler input: which complication must go for it to be right.

A card names the complications of its exercise (a camera that is turned, a pixel without depth), and
the right answers without them are in the table.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from labutils.checks.calls import collect_answers
from labutils.checks.compare import is_same_outcome
from labutils.checks.explain.told import Explanation

if TYPE_CHECKING:
    from collections.abc import Callable

    from labutils.checks.table import CheckTable, Outcome

#: A single answer of fewer numbers may be right by accident.
_MIN_VALUES = 6


def find_simpler(
    table: CheckTable,
    answers: tuple[Outcome, ...],
    function: Callable[..., object],
    deadline: float,
) -> Explanation | None:
    """Find the first complication without which every case that was wrong is right.

    Parameters
    ----------
    table : CheckTable
        The cases, and the simpler ones in the order in which they are told.
    answers : tuple of Outcome
        What came, one per case.
    function : callable
        The learner's.
    deadline : float
        Seconds of the monotonic clock after which nothing more is tried.

    Returns
    -------
    Explanation or None
    """
    wrong = {
        number
        for number, (due, yours) in enumerate(zip(table.expected, answers, strict=True))
        if not is_same_outcome(table.parts, due, yours)
    }
    # Where a case was wrong without the complication, it is not what is wrong.
    for simpler in table.simpler:
        if time.monotonic() > deadline:
            return None
        plain = table.with_cases(simpler.cases, simpler.expected)
        if wrong and wrong <= set(simpler.of) and _is_right(plain, function):
            return Explanation(
                f"simpler:{simpler.name}",
                f"As soon as {simpler.words}, your answer is right.",
            )
    return None


def _is_right(table: CheckTable, function: Callable[..., object]) -> bool:
    """Tell whether a function answers right, in cases enough to mean something."""
    values = sum(
        part.size
        for due in table.expected
        if isinstance(due, tuple)
        for part in due
        if part is not None
    )
    if len(table.cases) < 2:
        return values >= _MIN_VALUES and _agrees(table, function)
    # One before all: most functions fail the first.
    first = table.with_cases(table.cases[:1], table.expected[:1])
    return _agrees(first, function) and _agrees(table, function)


def _agrees(table: CheckTable, function: Callable[..., object]) -> bool:
    return all(
        is_same_outcome(table.parts, due, yours)
        for due, yours in zip(table.expected, collect_answers(table, function), strict=True)
    )
