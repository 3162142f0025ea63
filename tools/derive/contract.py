"""Tie every sentence of an exercise to what checks it, and every check to a sentence.

Four kinds of sentences are the same everywhere and need no row on a card: the example call, a
parameter with its type, what comes back with its type, and that the arguments stay as they are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from labutils.checks.gates import GATES
from labutils.checks.kinds import KINDS, get_kind
from tools.derive.sentences import CODE, Sentence, list_sentences
from tools.derive.starters import INPUTS_STAY, STATE_MAY_FOLLOW

if TYPE_CHECKING:
    from collections.abc import Iterator

    from labutils.checks.table import Part
    from solutions import Exercise

EVERY_CASE = "every case"

#: What any function has to do; no sentence says it.
_UNSAID = ("defined", "runs")

_BY_TYPE = ("type", "shape", "dtype")


class GapError(ValueError):
    """A contract has gaps; the message names all of them."""


@dataclass(frozen=True)
class Tie:
    """A row of the table: a sentence, and what keeps it."""

    id: str
    sentence: Sentence
    kind: str
    kept_by: tuple[str, ...]


def list_ties(exercise: Exercise) -> tuple[list[Tie], list[str]]:
    """Return the rows of the table, and what does not fit together.

    Returns
    -------
    ties : list of Tie
        In the order of the sentences.
    gaps : list of str
        Sentences without a row, rows without a sentence, unknown checks, and checks that no
        sentence asks for. Empty where all is well.
    """
    sentences = list_sentences(exercise)
    ties = []
    gaps = []
    for sentence in sentences:
        by_form = _tie_by_form(exercise, sentence)
        found = [by_form] if by_form else []
        found += [
            Tie(duty.id, sentence, duty.kind, duty.kept_by)
            for duty in exercise.contract
            if duty.words in str(sentence)
        ]
        if not found:
            gaps.append(f"no row says what keeps the sentence {str(sentence)!r}")
        ties += found
    for duty in exercise.contract:
        count = sum(duty.words in str(sentence) for sentence in sentences)
        if count != 1:
            gaps.append(f"{duty.id}: {count} sentences hold the words {duty.words!r}, expected one")
    ids = [duty.id for duty in exercise.contract]
    gaps += [
        f"{name}: two rows have this id" for name in sorted({n for n in ids if ids.count(n) > 1})
    ]
    gaps += _find_loose_checks(exercise, ties)
    return ties, [f"{exercise.name}: {gap}" for gap in gaps]


def _tie_by_form(exercise: Exercise, sentence: Sentence) -> Tie | None:
    if sentence.place == CODE:
        return Tie("example-call", sentence, "told", ())
    if sentence.text == INPUTS_STAY:
        return Tie("inputs-stay", sentence, "asked", ("input",))
    if sentence.text == STATE_MAY_FOLLOW:
        return Tie("state-may-follow", sentence, "told", ())
    name = sentence.text.partition(" :")[0].replace(", ", "-")
    if sentence.place == "Parameters":
        return Tie(f"given-{name}", sentence, "given", ())
    if sentence.place == "Returns":
        known = [part.name for part in exercise.parts]
        names = [one for one in sentence.text.partition(" :")[0].split(", ") if one in known]
        kept_by = (
            tuple(f"{gate} of {one}" for one in names for gate in _BY_TYPE) if names else _BY_TYPE
        )
        return Tie(f"returns-{name}" if names else "returns", sentence, "asked", kept_by)
    return None


def _find_loose_checks(exercise: Exercise, ties: list[Tie]) -> Iterator[str]:
    """Find checks that are named and do not exist, and those that exist and are not named."""
    checks = set(list_checks(exercise))
    named: set[str] = set()
    for tie in ties:
        for words in tie.kept_by:
            meant = _resolve(words, checks)
            if not meant:
                yield f"{tie.id}: there is no check {words!r}"
            named |= meant
    for check in sorted(checks - named):
        yield f"no sentence asks for the check {check!r}"


def list_checks(exercise: Exercise) -> Iterator[str]:
    """Name what an answer can fail: gates by part, cases and listed mistakes."""
    yield "input"
    for part in exercise.parts:
        for gate in GATES:
            if gate not in (*_UNSAID, "input") and _is_in_force(gate, part):
                yield f"{gate} of {part.name}"
    yield from (f"case {case.label}" for case in exercise.visible())
    yield from (f"mistake {one.name}" for one in exercise.misconceptions)


def _is_in_force(gate: str, part: Part) -> bool:
    if gate == "range":
        return bool(part.values) or part.low is not None or part.high is not None
    kind = get_kind(part)
    if gate in {name for one in KINDS.values() for name in one.properties}:
        return gate in kind.properties
    # What is seen after the call has no type, shape or dtype that could be wrong.
    return not kind.is_observed


def _resolve(words: str, checks: set[str]) -> set[str]:
    if words == EVERY_CASE:
        return {check for check in checks if check.startswith("case ")}
    if words.startswith("case "):
        return {check for check in checks if check.startswith(words)}
    return {check for check in checks if words in (check, check.partition(" of ")[0])}


def make_contract(exercises: dict[str, Exercise], note: str) -> str:
    """Return the file with the tables of all exercises."""
    return f"# Which check keeps which sentence\n\n<!-- {note} -->\n\n{make_tables(exercises)}"


def make_tables(exercises: dict[str, Exercise]) -> str:
    """Return one table per exercise, each under its heading.

    Raises
    ------
    GapError
        If a sentence is kept by nothing, or a check is asked for by no sentence.
    """
    lines = []
    gaps = []
    for name, exercise in exercises.items():
        ties, found = list_ties(exercise)
        gaps += found
        lines += [f"## `{name}`", "", "| Id | Sentence | Kept by |", "|---|---|---|"]
        for tie in ties:
            kept = ", ".join(tie.kept_by) or f"({tie.kind})"
            lines.append(f"| {tie.id} | {_escape(tie.sentence.text)} | {kept} |")
        lines.append("")
    if gaps:
        raise GapError("\n  ".join(["the contract has gaps", *gaps]))
    return "\n".join(lines).rstrip() + "\n"


def _escape(text: str) -> str:
    """Show a sentence as it was written: as code, for it holds marks of its own."""
    ticks = "``" if "`" in text else "`"
    text = text.replace("``", "`").replace("|", "\\|")
    return f"{ticks} {text} {ticks}" if "`" in text else f"{ticks}{text}{ticks}"
