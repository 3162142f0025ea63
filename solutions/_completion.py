"""A completion problem: a twin of an exercise of which two lines are left to the learner.

It stands between the worked example in the chapter and the exercise itself, so that support fades.
It has no points and no card of its own: the card of its exercise names it, and its cases come from
the cases of the exercise. The whole twin is written down; a comment marks the lines to leave out.
"""

from __future__ import annotations

import ast
import inspect
import itertools
import re
import textwrap
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from content.labels import make_link
from labutils.checks.calls import call_once
from labutils.checks.compare import is_same_outcome, to_canonical
from labutils.checks.kinds import get_kind
from labutils.checks.table import Case, CheckTable, Misfit, Outcome, Part, Raised
from solutions._example import verify_example
from solutions._model import Exercise, Misconception
from solutions._outcomes import round_outcome

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["Case", "Completion", "OpenLine", "Part", "Slip", "find_open_lines"]

#: How many lines a completion leaves out.
OPEN_LINES = 2

#: A line that is left out ends in this, and in what it has to do: the learner reads the latter.
_MARK = re.compile(r"^(?P<indent> *)(?P<code>\S.*?)  # open: (?P<asks>.+)$")


@dataclass(frozen=True)
class OpenLine:
    """A line of a twin that is left to the learner.

    Parameters
    ----------
    number : int
        Its place in the source of the twin, from 0 on.
    target : str
        What it assigns, such as "u, v"; empty for a call whose result nobody keeps.
    code, asks : str
        The line itself, and the comment that stands in its place.
    """

    number: int
    target: str
    code: str
    asks: str
    indent: str

    @property
    def blank(self) -> str:
        """What the learner finds."""
        gap = f"{self.target} = ..." if self.target else "..."
        return f"{self.indent}{gap}  # {self.asks}"


@dataclass(frozen=True)
class Slip(Misconception):
    """A plausible wrong version of an open line, and what to say to somebody who wrote it.

    A line that assigns nothing is just forgotten: its slip has the line ``pass``.
    """

    line: str = ""


@dataclass(frozen=True)
class Completion:
    """The completion problem of an exercise.

    Parameters
    ----------
    title : str
        Its heading, after "Complete it first:".
    statement : str
        What the twin does, above its starter.
    section : str
        Label of the worked example that it follows.
    twin : callable
        The whole function. Two lines end in ``# open: `` and what they have to do.
    parts : tuple of Part
        What comes back, with its tolerance.
    cases : callable
        Makes its cases of the visible cases of the exercise.
    slips : tuple of Slip
        At least one for each of the two lines.
    example : str
        A few lines that call it and show the result, as on a card.
    """

    title: str
    statement: str
    section: str
    twin: Callable[..., Any]
    parts: tuple[Part, ...]
    cases: Callable[[tuple[Case, ...]], tuple[Case, ...]]
    slips: tuple[Slip, ...]
    example: str
    imports: tuple[str, ...] = ("import numpy as np",)

    def __post_init__(self) -> None:
        lines = find_open_lines(self.twin)
        if len(lines) != OPEN_LINES or not any(line.target for line in lines):
            raise ValueError(
                f"{self.name}: expected {OPEN_LINES} open lines, one of which assigns, "
                f"got {[line.code for line in lines]}"
            )
        wrong = {get_target(slip.line) for slip in self.slips}
        due = {line.target for line in lines}
        if wrong != due:
            raise ValueError(
                f"{self.name}: expected slips of the lines that assign {sorted(due)}, "
                f"got {sorted(wrong)}"
            )
        for part in self.parts:
            get_kind(part)  # raises where there is no such kind
        make_link(self.section)  # raises where there is no such section
        verify_example(self.name, self.example)

    @property
    def name(self) -> str:
        """The name of the function."""
        return self.twin.__name__

    def write_with(self, *slips: Slip) -> str:
        """Return the source of the twin with wrong versions of its lines."""
        lines = read_source(self.twin)
        open_lines = {line.target: line for line in find_open_lines(self.twin)}
        for slip in slips:
            line = open_lines[get_target(slip.line)]
            lines[line.number] = line.indent + slip.line
        return "\n".join(lines) + "\n"

    def make_wrong(self, *slips: Slip) -> Callable[..., Any]:
        """Return the function of somebody who made these slips."""
        space = dict(self.twin.__globals__)
        code = compile(self.write_with(*slips), self.name, "exec")
        exec(code, space)  # noqa: S102 - a twin of ours
        wrong: Callable[..., Any] = space[self.name]
        return wrong

    def freeze(self, exercise: Exercise) -> CheckTable:
        """Compute its table from the cases of the exercise."""
        cases = self.cases(exercise.visible())
        expected = self._collect(self.twin, cases)
        if any(isinstance(due, Raised | Misfit) for due in expected):
            raise ValueError(f"{self.name}: expected answers to all cases, got {expected}")
        return CheckTable(
            name=self.name,
            title=self.title,
            chapter=exercise.home.short,
            kind=exercise.home.kind,
            points=0,
            parameters=tuple(inspect.signature(self.twin).parameters),
            section=make_link(self.section),
            parts=self.parts,
            hints=(),
            misconceptions={slip.name: slip.text for slip in self.slips},
            cases=cases,
            expected=expected,
            wrong=self._list_wrong(cases, expected),
            open_lines=sum(bool(line.target) for line in find_open_lines(self.twin)),
            leads_to=exercise.name,
        )

    def _list_wrong(
        self, cases: tuple[Case, ...], expected: tuple[Outcome, ...]
    ) -> dict[tuple[str, ...], tuple[Outcome, ...]]:
        """Collect what the slips answer, and pairs of them in different lines."""
        pairs = [
            pair
            for pair in itertools.combinations(self.slips, 2)
            if len({get_target(slip.line) for slip in pair}) > 1
        ]
        wrong: dict[tuple[str, ...], tuple[Outcome, ...]] = {}
        for made in (*((slip,) for slip in self.slips), *pairs):
            answers = self._collect(self.make_wrong(*made), cases)
            names = tuple(slip.name for slip in made)
            if self._is_same(expected, answers):
                raise ValueError(f"{self.name}: {names} passes; add a case that shows it")
            # of a pair that looks like a single slip, the single one is named
            if not any(self._is_same(known, answers) for known in wrong.values()):
                wrong[names] = tuple(to_canonical(self.parts, answer) for answer in answers)
        return wrong

    def _is_same(self, a: tuple[Outcome, ...], b: tuple[Outcome, ...]) -> bool:
        return all(is_same_outcome(self.parts, x, y) for x, y in zip(a, b, strict=True))

    def _collect(
        self, function: Callable[..., Any], cases: tuple[Case, ...]
    ) -> tuple[Outcome, ...]:
        return tuple(round_outcome(call_once(self.parts, case, function)) for case in cases)


def read_source(function: Callable[..., Any]) -> list[str]:
    """Return the lines of a function, from the first column on."""
    return textwrap.dedent(inspect.getsource(function)).splitlines()


def get_target(line: str) -> str:
    """Return what a line assigns, as it is written; "" where it assigns nothing."""
    statement = ast.parse(line.strip()).body[0]
    if not isinstance(statement, ast.Assign):
        return ""
    return ast.unparse(statement.targets[0]).strip("()")  # tuples are written without


def find_open_lines(function: Callable[..., Any]) -> tuple[OpenLine, ...]:
    """Find the lines of a twin that are left to the learner."""
    found = []
    for number, line in enumerate(read_source(function)):
        if match := _MARK.match(line):
            code = match["code"]
            found.append(OpenLine(number, get_target(code), code, match["asks"], match["indent"]))
    return tuple(found)
