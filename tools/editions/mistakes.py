"""Measure what an instructor wants to know of a mistake: who sees it, how large, what it costs.

Nothing here is typed by hand: every number comes from running the wrong functions of a
card on its visible cases, and on hidden cases of a few seeds.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.compare import align_rows, is_same_outcome
from labutils.checks.gates import find_failure
from labutils.checks.kinds import get_kind
from labutils.checks.kinds.base import get_largest_gap
from labutils.checks.table import CheckTable, Misfit, Outcome, Part, Raised

if TYPE_CHECKING:
    from solutions import Exercise

#: Enough to see how much of an exercise survives a mistake; the tests take 20.
SEEDS = range(5)


@dataclass(frozen=True)
class Measured:
    """What is known of one mistake.

    Parameters
    ----------
    name, text : str
        Of the card.
    gate : str
        The first gate it fails on the visible cases.
    cases : tuple of int
        Numbers (from 1) of the visible cases on which it is wrong.
    residual : str
        How far it is off on the worst of these cases, in words.
    rival : str
        The other mistake that agrees with it on the most cases.
    rival_cases : tuple of int
        The visible cases that tell the two apart.
    kept : float
        Share of the hidden cases that are right in spite of it.
    """

    name: str
    text: str
    gate: str
    cases: tuple[int, ...]
    residual: str
    rival: str
    rival_cases: tuple[int, ...]
    kept: float


def measure(exercise: Exercise) -> list[Measured]:
    """Measure every mistake of a card."""
    table = exercise.freeze()
    # as returned, not as in the table: that keeps color-mapped pictures as levels
    every = {
        one.name: exercise.collect(exercise.make_wrong((one.name,)), table.cases)
        for one in exercise.misconceptions
    }
    return [
        _measure_one(exercise, table, every, one.name, one.text) for one in exercise.misconceptions
    ]


def _measure_one(
    exercise: Exercise,
    table: CheckTable,
    every: dict[str, tuple[Outcome, ...]],
    name: str,
    text: str,
) -> Measured:
    wrong = every[name]
    failure = find_failure(table, wrong)
    if failure is None:
        raise ValueError(f"{exercise.name}: {name} passes the visible cases")
    others = {
        other: _find_different(table.parts, answers, wrong)
        for other, answers in every.items()
        if other != name
    }
    rival = min(others, key=lambda other: len(others[other]))
    residuals = [
        describe_residual(table.parts, due, answer)
        for due, answer in zip(table.expected, wrong, strict=True)
        if not is_same_outcome(table.parts, due, answer)
    ]
    return Measured(
        name=name,
        text=text,
        gate=failure.gate,
        cases=_find_different(table.parts, table.expected, wrong),
        residual=max(residuals)[1],
        rival=rival,
        rival_cases=others[rival],
        kept=measure_kept(exercise, (name,)),
    )


def _find_different(
    parts: tuple[Part, ...], some: tuple[Outcome, ...], others: tuple[Outcome, ...]
) -> tuple[int, ...]:
    """Return the numbers of the cases on which two functions answer differently."""
    pairs = enumerate(zip(some, others, strict=True), 1)
    return tuple(number for number, pair in pairs if not is_same_outcome(parts, *pair))


def measure_kept(exercise: Exercise, made: tuple[str, ...]) -> float:
    """Return which share of the hidden cases is right in spite of these mistakes."""
    right = total = 0
    acts = not all(get_kind(part).is_repeatable for part in exercise.parts)
    for seed in SEEDS[:1] if acts else SEEDS:  # a loop takes a second
        cases = exercise.hidden(np.random.default_rng(seed))
        due = exercise.collect_due(cases)
        answers = exercise.collect(exercise.make_wrong(made), cases)
        right += len(cases) - len(_find_different(exercise.parts, due, answers))
        total += len(cases)
    return right / total


def describe_residual(parts: tuple[Part, ...], due: Outcome, answer: Outcome) -> tuple[float, str]:
    """Say how far an answer is off; the number before the words sorts them by size."""
    if isinstance(answer, Raised):
        return np.inf, f"stops with {answer.kind}"
    if isinstance(due, Raised):
        return np.inf, f"answers where a {due.kind} is due"
    if isinstance(answer, Misfit) or isinstance(due, Misfit):
        return np.inf, "returns something else"
    answer = align_rows(parts, due, answer)
    found = [_describe_part(*each) for each in zip(parts, due, answer, strict=True)]
    return max(found)


def _describe_part(
    part: Part, due: np.ndarray | None, answer: np.ndarray | None
) -> tuple[float, str]:
    if due is None or answer is None:
        size = 0.0 if due is answer else np.inf
        return size, f"{part.name} is None where it should not be, or the other way round"
    kind = get_kind(part)
    if kind.is_observed or not kind.is_repeatable:
        return _describe_whole(part, due, answer)
    if due.shape != answer.shape:
        shapes = [" x ".join(map(str, value.shape)) or "one" for value in (answer, due)]
        return np.inf, f"{part.name}: {shapes[0]} values for {shapes[1]}"
    wrong = kind.find_wrong(part, due, answer)
    if wrong.any():
        gaps = np.abs(kind.get_differences(part, due, answer))[wrong]
        return _describe_values(part, wrong, gaps)
    if due.dtype.kind != answer.dtype.kind:
        return np.inf, f"{part.name}: right values, wrong type ({answer.dtype})"
    return 0.0, f"{part.name}: nothing"


def _describe_whole(part: Part, due: np.ndarray, answer: np.ndarray) -> tuple[float, str]:
    """Say how something is wrong that has no values to compare one by one."""
    kind = get_kind(part)
    if kind.is_observed:
        return (0.0 if bool(due) == bool(answer) else np.inf), f"not so: {part.name}"
    found = kind.find_property(part, due, answer)
    told = kind.describe(part, due, answer, np.ones(1))
    return 1.0, f"{found}: {told[0].lower()}{told[1:-1]}"


def _describe_values(part: Part, wrong: np.ndarray, gaps: np.ndarray) -> tuple[float, str]:
    """Say how many values are wrong and by how much."""
    words = f"{part.name}: {wrong.sum()} of {wrong.size} values off"
    finite = gaps[np.isfinite(gaps)]
    if not finite.size:
        return np.inf, f"{words}, none of them comparable"
    if not get_kind(part).has_sizes:
        return float(wrong.mean()), words
    typical = float(np.median(finite))
    # two digits would make 260 of 255
    shown = np.format_float_positional(min(float(_round(typical)), get_largest_gap(part)), trim="-")
    words += f", typically by {shown}{f' {part.unit}' if part.unit else ''}"
    if not part.atol:
        return float(wrong.mean()), words
    ratio = float(_round(typical / part.atol))
    return typical / part.atol, f"{words}, {ratio:,.7g} times the tolerance"


def _round(value: float) -> str:
    """Write a number with two digits that count: 0.094, 9.4, 9400."""
    return np.format_float_positional(float(f"{value:.2g}"), trim="-")
