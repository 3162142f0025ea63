"""What an exercise consists of, checked when it is loaded.

A misconception is executable: every card has one function, `answer_with`, that gives the answer of
somebody who made a set of mistakes. Without mistakes it has to agree with the reference; with one
or two it is what the check recognizes. So texts, tests, tables and grades come from one source.
"""

from __future__ import annotations

import inspect
import itertools
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from content.chapters import get_chapter
from content.labels import make_link
from labutils.checks.calls import call_once
from labutils.checks.compare import is_same_outcome
from labutils.checks.explain.arguments import with_argument
from labutils.checks.explain.probes import MIN_CASES, list_changes
from labutils.checks.kinds import get_kind
from labutils.checks.progress_rules import MAX_HINTS
from labutils.checks.table import Case, CheckTable, Misfit, Outcome, Part, Raised
from solutions._contract import Duty, asked, given, told
from solutions._example import verify_example
from solutions._outcomes import change, round_outcome, shorten
from solutions._simpler import Simplification, simplify

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy as np

    from content.chapters import Chapter
    from solutions._completion import Completion

__all__ = ["Absorbed", "Case", "Exercise", "Misconception", "Part", "asked", "given", "told"]

#: With "Recognized: " before it, a text of this length fills two lines of a verdict. Two mistakes
#: at once then still fit below twelve lines.
MAX_TEXT = 176

#: How many mistakes a card recognizes at least, and how many characters their texts have.
MIN_MISCONCEPTIONS = 4
MIN_TEXT = 40

Mistakes = frozenset[str]


@dataclass(frozen=True)
class Misconception:
    """A mistake: its name, what to say to somebody who made it, and the section to read again.

    Without a section of its own, a mistake leads to the section of its card.
    """

    name: str
    text: str
    section: str = ""

    def __post_init__(self) -> None:
        if not self.name or self.name != self.name.lower() or " " in self.name:
            raise ValueError(f"misconception: expected a name-like-this, got {self.name!r}")
        if not MIN_TEXT <= len(self.text) <= MAX_TEXT or not self.text.endswith("."):
            raise ValueError(
                f"misconception {self.name}: expected sentences of {MIN_TEXT} to {MAX_TEXT} "
                f"characters that end with a full stop, got {len(self.text)}"
            )


@dataclass(frozen=True)
class Absorbed:
    """Two mistakes that cannot be told apart from one of them, and why that has to be so."""

    first: str
    second: str
    reason: str


@dataclass(frozen=True)
class Exercise:
    """One card of the instructor's room.

    Exercises of the lab have points, challenges and extensions have none. What a challenge asks for
    is not in labutils, so its reference stands on its card.

    Parameters
    ----------
    chapter : str
        Id of its chapter in ``content/chapters.yml``, such as "step4".
    section : str
        Label of the section to read again, such as "step4-clean".
    objectives : tuple of str
        The learning objectives it practices, such as "4c".
    reference : callable
        The right answer; for the lab's own functions it *is* the function of labutils.
    answer_with : callable
        ``answer_with(mistakes, *arguments)``: the answer of somebody who made these mistakes.
    visible, hidden : callable
        ``visible()`` gives the cases everybody sees, ``hidden(rng)`` those that decide the grade.
    parts : tuple of Part
        What comes back, with its tolerance.
    tolerance_reason : str
        Why the tolerance is neither tighter nor wider.
    example : str
        A few lines that call the learner's function and show the result: with the names that the
        cells at the top of its page make, and with any right answer.
    contract : tuple of Duty
        What keeps each sentence of its statement and docstring.
    place : int
        Position among the exercises of its chapter.
    simpler : tuple of Simplification
        The complications of its cases, each with what takes it away: the most telling first.
    asks : mapping of str to str
        Where the exercise asks for less than the function of the library does: a parameter, and
        its entry in the starter's docstring (the type, a line break, what it is); or a section,
        such as "Raises", and its text, empty where the starter has none. Parameters that go by
        keyword only are no part of the exercise anyway.
    completion : Completion, optional
        A twin to complete before it; exercises with points have one.
    """

    name: str
    title: str
    chapter: str
    points: int
    section: str
    objectives: tuple[str, ...]
    reference: Callable[..., Any]
    answer_with: Callable[..., Any]
    parts: tuple[Part, ...]
    tolerance_reason: str
    misconceptions: tuple[Misconception, ...]
    hints: tuple[str, ...]
    example: str
    contract: tuple[Duty, ...]
    visible: Callable[[], tuple[Case, ...]]
    hidden: Callable[[np.random.Generator], tuple[Case, ...]]
    place: int = 1
    simpler: tuple[Simplification, ...] = ()
    imports: tuple[str, ...] = ("import numpy as np",)
    asks: Mapping[str, str] = field(default_factory=dict)
    absorbed: tuple[Absorbed, ...] = field(default=())
    completion: Completion | None = None

    def __post_init__(self) -> None:
        names = [one.name for one in self.misconceptions]
        if len(set(names)) != len(names) or len(names) < MIN_MISCONCEPTIONS:
            raise ValueError(
                f"{self.name}: expected at least {MIN_MISCONCEPTIONS} different misconceptions, "
                f"got {names}"
            )
        for part in self.parts:
            get_kind(part)  # raises where there is no such kind
        if len(self.hints) != MAX_HINTS or not all(self.hints):
            raise ValueError(f"{self.name}: expected {MAX_HINTS} hints, got {len(self.hints)}")
        unknown = {name for one in self.absorbed for name in (one.first, one.second)} - set(names)
        if unknown:
            raise ValueError(f"{self.name}: absorbed names unknown mistakes {sorted(unknown)}")
        if not all(one.reason for one in self.absorbed) or not self.tolerance_reason:
            raise ValueError(f"{self.name}: expected a reason with every exception and tolerance")
        if self.reference.__name__ != self.name:
            raise ValueError(f"{self.name}: the reference is called {self.reference.__name__}")
        if not self.objectives:
            raise ValueError(f"{self.name}: expected at least one objective")
        verify_example(self.name, self.example)
        self._verify_place()

    def _verify_place(self) -> None:
        """Refuse points that the chapter does not have, and sections that no chapter has."""
        if self.points < 0 or (self.home.is_extension and self.points):
            raise ValueError(
                f"{self.name}: expected points of 0 or more, and 0 in an extension, "
                f"got {self.points} in {self.chapter}"
            )
        if not (self.points or self.is_challenge or self.home.is_extension):
            raise ValueError(f"{self.name}: expected points, its reference is in the library")
        for label in (self.section, *(one.section for one in self.misconceptions if one.section)):
            make_link(label)  # raises where there is no such section

    @property
    def is_challenge(self) -> bool:
        """Whether it goes beyond the lab: no points, and not in the library."""
        return not self.points and self.reference.__module__.partition(".")[0] != "labutils"

    @property
    def home(self) -> Chapter:
        """The row of its chapter."""
        return get_chapter(self.chapter)

    @property
    def parameters(self) -> tuple[str, ...]:
        """The names of the arguments; what goes by keyword only is no part of the exercise."""
        given = inspect.signature(self.reference).parameters.values()
        return tuple(one.name for one in given if one.kind is not one.KEYWORD_ONLY)

    def get_combinations(self) -> tuple[tuple[str, ...], ...]:
        """Return every mistake and every pair that can be told apart."""
        absorbed = {frozenset((one.first, one.second)) for one in self.absorbed}
        names = [one.name for one in self.misconceptions]
        pairs = itertools.combinations(names, 2)
        return (
            *((name,) for name in names),
            *(pair for pair in pairs if frozenset(pair) not in absorbed),
        )

    def make_wrong(self, made: tuple[str, ...]) -> Callable[..., Any]:
        """Return the function somebody would write who made these mistakes."""
        mistakes = frozenset(made)

        def wrong(*args: Any) -> Any:
            return self.answer_with(mistakes, *args)

        return wrong

    def freeze(self, cases: tuple[Case, ...] | None = None) -> CheckTable:
        """Compute the table for the visible (or other) cases, and verify the card on the way."""
        cases = cases or self.visible()
        expected = self.collect_due(cases)
        for case, due in zip(cases, expected, strict=True):
            self._verify_reference(case, due)
        wrong = {
            made: tuple(
                change(self.parts, outcome, "make_known")
                for outcome in self.collect(self.make_wrong(made), tuple(map(shorten, cases)))
            )
            for made in self.get_combinations()
        }
        table = CheckTable(
            name=self.name,
            title=self.title,
            chapter=self.home.short,
            kind=self.home.kind,
            points=self.points,
            parameters=self.parameters,
            section=make_link(self.section),
            parts=self.parts,
            hints=self.hints,
            misconceptions={one.name: one.text for one in self.misconceptions},
            links={one.name: make_link(one.section) for one in self.misconceptions if one.section},
            cases=cases,
            expected=expected,
            wrong=wrong,
        )
        return replace(table, matters=self._find_what_matters(table), simpler=simplify(self, table))

    def _find_what_matters(self, table: CheckTable) -> tuple[str, ...]:
        """Name the arguments, and entries of them, that change the right answer."""
        found = []
        for name, place, make in list_changes(table):
            changed = 0
            for case, due in zip(table.cases, table.expected, strict=True):
                others = [] if case.raises else make(case)
                answers = (
                    call_once(self.parts, with_argument(case, place, other), self.reference)
                    for other in others
                )
                changed += any(not is_same_outcome(self.parts, due, one) for one in answers)
            if changed >= MIN_CASES:
                found.append(name)
        return tuple(found)

    def collect_due(self, cases: tuple[Case, ...]) -> tuple[Outcome, ...]:
        """Return what is due: the reference's answers, or what they have to have in common."""
        return tuple(map(self.make_due, self.collect(self.reference, cases)))

    def make_due(self, outcome: Outcome) -> Outcome:
        """Make of one answer of the reference what is due."""
        return change(self.parts, outcome, "make_due")

    def collect(self, function: Callable[..., Any], cases: tuple[Case, ...]) -> tuple[Outcome, ...]:
        return tuple(round_outcome(call_once(self.parts, case, function)) for case in cases)

    def _verify_reference(self, case: Case, due: Outcome) -> None:
        if isinstance(due, Raised) != bool(case.raises) or isinstance(due, Misfit):
            raise ValueError(f"{self.name}: the reference fails on {case.label!r}: {due}")
        if isinstance(due, Raised) and case.raises != due.kind:
            raise ValueError(f"{self.name}: expected {case.raises} on {case.label!r}, got {due}")
        again = round_outcome(call_once(self.parts, case, self.make_wrong(())))
        if not is_same_outcome(self.parts, due, again):
            raise ValueError(
                f"{self.name}: answer_with without mistakes differs from the reference on "
                f"{case.label!r}"
            )
