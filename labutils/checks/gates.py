"""The properties an answer has to have, in order; the first that fails is the verdict.

defined, runs, type, shape, dtype, range, value, and last input: the arguments came back as they
were. Of what acts in a loop, "value" is several gates: limits, settles, follows, recovers. A gate
says what was found and which *property* was due, never the value that was due.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from labutils.checks.compare import align_rows, is_close
from labutils.checks.kinds import get_kind
from labutils.checks.table import Case, CheckTable, Misfit, Outcome, Part, Raised, Scene

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

#: A part, what is due and what came.
_Pair: TypeAlias = "tuple[Part, np.ndarray | None, np.ndarray | None]"

GATES = (
    *("defined", "runs", "type", "shape", "dtype", "range"),
    *("value", "limits", "settles", "follows", "recovers", "input"),
)

_DTYPES = {
    "float": ("f", "floating-point numbers (float32 or float64)"),
    "uint8": ("u", "uint8, whole numbers from 0 to 255"),
    "int": ("iu", "whole numbers"),
    "bool": ("b", "True or False"),
    "str": ("U", "texts"),
}


#: Looks at one case for one property.
_Gate: TypeAlias = "Callable[[CheckTable, int, Case, Outcome, Outcome], Failure | None]"


@dataclass(frozen=True)
class Failure:
    """The first property that does not hold: which, where, and what to say about it."""

    gate: str
    text: str
    case: int
    part: int = 0
    #: Whether the function looks as if nobody has begun it.
    untouched: bool = False
    #: The line of the learner's code where it stopped; None where it did not.
    line: int | None = None


def find_failure(
    table: CheckTable, answers: tuple[Outcome, ...], *, begun: bool = False
) -> Failure | None:
    """Run the gates over all cases, one gate after the other; stop at the first failure.

    `begun` says that the function has a body: one that answers like the starter is none.
    """
    if failure := _find_nothing(table, answers, begun=begun):
        return failure
    if failure := _find_crash(table, answers):
        return failure
    properties = dict.fromkeys(name for part in table.parts for name in get_kind(part).properties)
    gates: list[_Gate] = [_check_type, _check_shape, _check_dtype, _check_range]
    gates += [partial(_check_value, name) for name in properties]
    for gate in gates:
        for index, (case, answer) in enumerate(zip(table.cases, answers, strict=True)):
            due = table.expected[index]
            if isinstance(due, Raised) or isinstance(answer, Raised):
                continue  # both are settled by _find_crash and _check_raises
            if failure := gate(table, index, case, due, answer):
                return failure
    return _check_raises(table, answers)


def _find_nothing(
    table: CheckTable, answers: tuple[Outcome, ...], *, begun: bool
) -> Failure | None:
    """Find a function that answers nothing at all: who returns (None, None) has answered."""
    raised = [
        answer
        for answer in answers
        if isinstance(answer, Raised) and answer.kind == "NotImplementedError"
    ]
    if len(raised) == len(answers):
        text = "The body is still `raise NotImplementedError`. "
        text += "Replace the line with your own code, then check again."
        if begun:
            where = f" in your {raised[0].line}" if raised[0].line else ""
            text = f"It still ends with NotImplementedError{where}. Let it return your result."
        line = _read_number(raised[0].line) if begun else None
        return Failure("runs", text, 0, untouched=not begun, line=line)
    returns_one = sum(not get_kind(part).is_observed for part in table.parts) == 1
    nothing = [
        (returns_one and isinstance(answer, tuple) and answer[0] is None)
        or (isinstance(answer, Misfit) and answer.is_empty)
        for answer in answers
    ]
    if all(nothing):
        text = "It returns nothing: the body is still empty, or `return` is missing at its end."
        if begun:
            text = "It returns nothing: `return` is missing, or no case comes to that line."
        return Failure("runs", text, 0, untouched=not begun)
    return None


def _read_number(line: str) -> int | None:
    """Read the number of a "line n: source"."""
    number = line.removeprefix("line ").partition(":")[0]
    return int(number) if number.isdecimal() else None


def _find_crash(table: CheckTable, answers: tuple[Outcome, ...]) -> Failure | None:
    for index, answer in enumerate(answers):
        if not isinstance(answer, Raised):
            continue
        due = table.cases[index].raises
        if due and due in (answer.kind, *answer.base_kinds):
            continue
        what = f"{answer.kind}: {answer.text}" if answer.text else answer.kind
        where = f" in your {answer.line}" if answer.line else ""
        wish = f" Here a {due} is due." if due else ""
        advice = f" {answer.advice}" if answer.advice else ""
        text = f"It stops with {what}{where}.{wish}{advice}"
        return Failure("runs", text, index, line=_read_number(answer.line))
    return None


def _check_raises(table: CheckTable, answers: tuple[Outcome, ...]) -> Failure | None:
    for index, (case, answer) in enumerate(zip(table.cases, answers, strict=True)):
        if case.raises and not isinstance(answer, Raised):
            text = f"It returns something where it has to raise {case.raises}."
            return Failure("value", text, index)
    return None


def _check_type(
    table: CheckTable, index: int, case: Case, due: Outcome, answer: Outcome
) -> Failure | None:
    del case
    if isinstance(answer, Misfit):
        return Failure("type", f"{answer.text[0].upper()}{answer.text[1:]}.", index)
    for number, (part, x, y) in enumerate(_walk(table.parts, due, answer)):
        if x is None and y is not None:
            text = f"{part.name} has to be None here{_note(part)}; yours is not."
            return Failure("type", text, index, number)
        if x is not None and y is None:
            text = f"{part.name} must not be None here{_note(part)}."
            return Failure("type", text, index, number)
    return None


def _note(part: Part) -> str:
    return f" ({part.note})" if part.note else ""


def _check_shape(
    table: CheckTable, index: int, case: Case, due: Outcome, answer: Outcome
) -> Failure | None:
    del case
    for number, (part, x, y) in enumerate(_walk(table.parts, due, answer)):
        if x is None or y is None:
            continue
        if text := get_kind(part).describe_shape(part, x, y):
            return Failure("shape", text, index, number)
    return None


def _check_dtype(
    table: CheckTable, index: int, case: Case, due: Outcome, answer: Outcome
) -> Failure | None:
    del case
    for number, (part, x, y) in enumerate(_walk(table.parts, due, answer)):
        kinds, words = _DTYPES[part.dtype]
        if x is None or y is None or (y.dtype.kind in kinds and (kinds != "u" or y.itemsize == 1)):
            continue
        return Failure("dtype", f"{part.name} is {y.dtype}; due are {words}.", index, number)
    return None


def _check_range(
    table: CheckTable, index: int, case: Case, due: Outcome, answer: Outcome
) -> Failure | None:
    for number, (part, x, y) in enumerate(_walk(table.parts, due, answer)):
        if x is None or y is None or not y.size or part.dtype == "str":
            continue
        if part.values and not np.isin(y, part.values).all():
            found = sorted({int(value) for value in np.unique(y)} - set(part.values))[:3]
            allowed = " and ".join(map(str, part.values))
            text = f"{part.name} holds {', '.join(map(str, found))}; only {allowed} are allowed."
            return Failure("range", text, index, number)
        limits = (_get_limit(table, case, part.low), _get_limit(table, case, part.high))
        if text := _describe_range(part, y, *limits):
            return Failure("range", text, index, number)
    return None


def _get_limit(table: CheckTable, case: Case, limit: float | str | None) -> float | None:
    """Look up a limit; a name means the argument of that name."""
    if not isinstance(limit, str):
        return limit
    # A scene fills several parameters, so only exercises without one may name limits.
    assert not any(isinstance(value, Scene) for value in case.args)  # noqa: S101 - cards are ours
    return float(case.args[table.parameters.index(limit)])


def _describe_range(part: Part, yours: np.ndarray, low: float | None, high: float | None) -> str:
    finite = yours[np.isfinite(yours)].astype(np.float64)
    slack = part.atol
    unit = f" {part.unit}" if part.unit else ""
    for limit, name, word, outside in (
        (low, part.low, "below", finite < (low or 0.0) - slack),
        (high, part.high, "above", finite > (high or 0.0) + slack),
    ):
        if limit is not None and outside.any():
            shown = f"{name} ({limit:g}{unit})" if isinstance(name, str) else f"{limit:g}{unit}"
            extreme = finite.min() if word == "below" else finite.max()
            return (
                f"{np.count_nonzero(outside)} of {yours.size} values of {part.name} lie {word} "
                f"{shown}; the furthest is {extreme:.3g}{unit}."
            )
    return ""


def _check_value(
    name: str, table: CheckTable, index: int, case: Case, due: Outcome, answer: Outcome
) -> Failure | None:
    del case
    if isinstance(due, tuple) and isinstance(answer, tuple):
        answer = align_rows(table.parts, due, answer)
    for number, (part, x, y) in enumerate(_walk(table.parts, due, answer)):
        if is_close(part, x, y) or x is None or y is None:
            continue
        kind = get_kind(part)
        if kind.find_property(part, x, y) != name:
            continue
        text = kind.describe(part, x, y, kind.find_wrong(part, x, y))
        return Failure(name, text, index, number)
    return None


def _walk(parts: tuple[Part, ...], due: Outcome, answer: Outcome) -> Iterator[_Pair]:
    """Pair every part with what is due and what came; nothing where an answer has no parts."""
    if isinstance(due, tuple) and isinstance(answer, tuple):
        yield from zip(parts, due, answer, strict=True)
