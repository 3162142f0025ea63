"""Tell of one mutant whether it differs from the reference, and which cases refuse it."""

from __future__ import annotations

import signal
import sys
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils.checks import judge
from labutils.checks.calls import call_once
from labutils.checks.compare import is_same_outcome
from labutils.checks.gates import find_failure
from labutils.checks.table import Case, load_table
from tools.mutants.build import Mutant, build, collect_pieces, find_lines, get_file, list_mutants
from tools.mutants.inputs import draw_input

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import FrameType

    from labutils.checks.table import CheckTable, Outcome
    from labutils.checks.verdict import Verdict
    from solutions import Exercise

#: Seconds of computing after which a mutant is taken for one that never answers: a hundred times
#: what a right answer takes, and more.
_LIMIT = {"level_cloud": 5.0, "render_camera": 1.0, "rank_cameras": 1.0, "control": 30.0}
_USUAL_LIMIT = 0.1

#: Likewise for a whole verdict, which calls a wrong function up to two seconds long.
_VERDICT_LIMIT = 12.0

#: Most mutants differ soon. Of the others it is asked first whether any draw reaches the fault.
_FIRST_DRAWS = 200


class _TooLongError(BaseException):
    """Not an Exception, so that nobody who catches whatever a function raises takes it for that."""


@dataclass(frozen=True)
class Judge:
    """The inputs, cases and right answers of one exercise, each computed once."""

    exercise: Exercise
    #: Of how many draws and seeds.
    draws: int
    seeds: int

    @cached_property
    def mutants(self) -> list[Mutant]:
        """All of them, those that never differ too."""
        return list_mutants(self.exercise.reference)

    @cached_property
    def visible(self) -> list[CheckTable]:
        """One table per visible case."""
        return self._make_tables(self.exercise.visible())

    @cached_property
    def hidden(self) -> list[list[CheckTable]]:
        """One table per hidden case, seed by seed."""
        return [
            self._make_tables(self.exercise.hidden(np.random.default_rng(seed)))
            for seed in range(self.seeds)
        ]

    def make(self, mutant: Mutant) -> Callable[..., Any]:
        """Compile a mutant; one whose module cannot even be loaded raises when it is called."""
        try:
            return build(self.exercise.reference, mutant)
        except Exception as error:  # noqa: BLE001 - whatever a faulty constant breaks
            broken = error

            def function(*_: Any) -> Any:
                raise broken

            return function

    def differs(self, mutant: Mutant, function: Callable[..., Any]) -> bool:
        """Tell whether a mutant, compiled, differs from the reference on one of the draws."""
        first = min(_FIRST_DRAWS, self.draws)
        return self._differs_within(range(first), function) or (
            first < self.draws
            and self._reaches(mutant)
            and self._differs_within(range(first, self.draws), function)
        )

    def _differs_within(self, draws: range, function: Callable[..., Any]) -> bool:
        for number in draws:
            case, due = self._draw(number)
            try:
                with _time_limit(self._limit):
                    answer = call_once(self.exercise.parts, case, function)
            except _TooLongError:
                return True
            if not is_same_outcome(self.exercise.parts, due, answer):
                return True
        return False

    def _reaches(self, mutant: Mutant) -> bool:
        """Tell whether any draw computes the statement with the fault: else it cannot differ."""
        lines = find_lines(mutant)
        file = get_file(mutant.piece.module)
        return lines is None or any((file, line) in self._reached for line in lines)

    @cached_property
    def _reached(self) -> set[tuple[str, int]]:
        """File and number of every line of a copy of the reference that some draw computes."""
        reached: set[tuple[str, int]] = set()
        files = {get_file(piece.module) for piece in collect_pieces(self.exercise.reference)}

        def trace(frame: FrameType, event: str, argument: object) -> Any:
            del event, argument
            if frame.f_code.co_filename not in files:
                return None
            reached.add((frame.f_code.co_filename, frame.f_lineno))
            return trace

        function = build(self.exercise.reference)
        for number in range(self.draws):
            case, _ = self._draw(number)
            before = sys.gettrace()
            sys.settrace(trace)
            try:
                call_once(self.exercise.parts, case, function)
            finally:
                sys.settrace(before)
        return reached

    def is_refused(self, function: Callable[..., Any], tables: list[CheckTable]) -> bool:
        """Tell whether one of the cases fails."""
        for table in tables:
            try:
                with _time_limit(self._limit):
                    answer = call_once(table.parts, table.cases[0], function)
            except _TooLongError:
                return True
            if find_failure(table, (answer,)):
                return True
        return False

    def find_verdict(self, function: Callable[..., Any]) -> Verdict | None:
        """Return what a learner would read of a function; None where it computes without end."""
        try:
            with _time_limit(_VERDICT_LIMIT):
                return judge(load_table(self.exercise.name), function)
        except _TooLongError:
            return None

    @property
    def _limit(self) -> float:
        return _LIMIT.get(self.exercise.name, _USUAL_LIMIT)

    @cached_property
    def _drawn(self) -> list[tuple[Case, Outcome]]:
        return []

    def _draw(self, number: int) -> tuple[Case, Outcome]:
        """Return the input of a draw and the right answer to it."""
        while len(self._drawn) <= number:
            case = Case("a draw", draw_input(self.exercise.name, len(self._drawn)))
            due = self.exercise.make_due(
                call_once(self.exercise.parts, case, self.exercise.reference)
            )
            self._drawn.append((case, due))
        return self._drawn[number]

    def _make_tables(self, cases: tuple[Case, ...]) -> list[CheckTable]:
        exercise = self.exercise
        expected = exercise.collect_due(cases)
        table = replace(load_table(exercise.name), parts=exercise.parts)
        return [
            table.with_cases((case,), (due,)) for case, due in zip(cases, expected, strict=True)
        ]


@contextmanager
def _time_limit(seconds: float) -> Iterator[None]:
    """Stop what computes for longer: a lost line may leave a loop without an end."""

    def stop(number: int, frame: FrameType | None) -> None:
        del number, frame
        raise _TooLongError

    # The time this process computes, not the time of the clock: other work must not count.
    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
