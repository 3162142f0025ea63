"""Call a wrong function again: the same twice, one argument changed, one repaired, all simpler.

What a probe tells was seen in every case. It is asked only after a failure that has no other
explanation, and it is no reason to fail by itself.
"""

from __future__ import annotations

import time
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks.calls import call_once, collect_answers
from labutils.checks.compare import is_same_outcome
from labutils.checks.explain.arguments import (
    find_places,
    list_entries,
    list_other_entries,
    list_others,
    with_argument,
)
from labutils.checks.explain.repairs import list_repairs
from labutils.checks.explain.simpler import find_simpler
from labutils.checks.explain.told import Explanation
from labutils.checks.inputs import is_same
from labutils.checks.table import Raised

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from labutils.checks.table import Case, CheckTable, Outcome

#: A slow function is not called again and again: after this long, nothing more is tried.
_TIME_LIMIT_S = 2.0

#: Fewer cases than this show no missing effect.
MIN_CASES = 2


def probe(
    table: CheckTable, answers: tuple[Outcome, ...], function: Callable[..., object]
) -> Explanation | None:
    """Find what calling again tells of a wrong function, or None.

    Parameters
    ----------
    table : CheckTable
        The cases and the answers due.
    answers : tuple of Outcome
        What came, one per case.
    function : callable
        The learner's.

    Returns
    -------
    Explanation or None
        Of a kept state, of arguments without effect, of the one repair of an argument after which
        every case would agree, or of the complication without which every case agrees.
    """
    deadline = time.monotonic() + _TIME_LIMIT_S
    with np.errstate(all="ignore"):
        for find in (_find_state, _find_no_effect, _find_repair, find_simpler):
            if time.monotonic() > deadline:
                return None
            if found := find(table, answers, function, deadline):
                return found
    return None


def _find_state(
    table: CheckTable,
    answers: tuple[Outcome, ...],
    function: Callable[..., object],
    deadline: float,
) -> Explanation | None:
    for _ in range(2):
        if time.monotonic() > deadline:
            return None
        # In the form that the answers have: a color map of the learner's own is read by all cases.
        again = collect_answers(table, function)
        if not all(
            is_same_outcome(table.parts, answer, one)
            for answer, one in zip(answers, again, strict=True)
            if isinstance(answer, tuple)
        ):
            return Explanation(
                "state",
                "Called again with the same arguments, your function answers something else: it "
                "keeps something between calls, or draws random numbers.",
            )
    return None


def _find_no_effect(
    table: CheckTable,
    answers: tuple[Outcome, ...],
    function: Callable[..., object],
    deadline: float,
) -> Explanation | None:
    """Name the arguments that matter and make no difference, to the last bit."""
    found: list[str] = []
    for name, place, make in list_changes(table):
        if name not in table.matters or name.partition("[")[0] in found:
            continue
        tried = 0
        for case, answer in zip(table.cases, answers, strict=True):
            if case.raises or isinstance(answer, Raised):
                continue
            others = make(case)
            if time.monotonic() > deadline:
                return None
            if not all(
                is_identical(
                    answer, call_once(table.parts, with_argument(case, place, other), function)
                )
                for other in others
            ):
                break
            tried += bool(others)
        else:
            found += [name] if tried >= MIN_CASES else []
    if not found:
        return None
    one = len(found) == 1
    return Explanation(
        f"no-effect:{'+'.join(found)}",
        f"{' and '.join(found)} make{'s' if one else ''} no difference: with other values of "
        f"{'it' if one else 'them'} your answer stays the same.",
    )


def list_changes(
    table: CheckTable,
) -> Iterator[tuple[str, int, Callable[[Case], list[Any]]]]:
    """List what can be changed alone: arguments, entries of K and of short vectors.

    Each comes with its place in a case, and what makes its other values from a case.
    """
    for name, place in find_places(table).items():
        yield name, place, partial(list_others, table, place)
        for entry, flat in list_entries(name, table.cases[0].args[place]):
            yield entry, place, partial(list_other_entries, place, flat)


def is_identical(one: Outcome, other: Outcome) -> bool:
    """Tell whether two answers agree to the last bit: little effect is an effect."""
    return isinstance(one, tuple) and is_same(one, other)


def _find_repair(
    table: CheckTable,
    answers: tuple[Outcome, ...],
    function: Callable[..., object],
    deadline: float,
) -> Explanation | None:
    """Find the one change of an argument after which every case agrees."""
    cases = []
    for case, due, yours in zip(table.cases, table.expected, answers, strict=True):
        if isinstance(due, tuple) and any(part is not None and part.size for part in due):
            cases.append((case, due))
        elif not is_same_outcome(table.parts, due, yours):
            return None  # no repair of an argument mends an answer that is nothing
    if len(cases) < MIN_CASES:
        return None
    found = []
    for repair in list_repairs(table):
        if time.monotonic() > deadline:
            return None
        # A repair that cannot be made repairs nothing.
        if all(
            (changed := repair.change(case)) is not None
            and is_same_outcome(table.parts, due, call_once(table.parts, changed, function))
            for case, due in cases
        ):
            found.append(repair)
    # Two repairs of one fault cannot be told apart, so none is told.
    if len(found) != 1:
        return None
    return Explanation(f"repair:{found[0].name}", f"{found[0].text} your answer would be right.")
