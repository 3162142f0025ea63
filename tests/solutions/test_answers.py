"""Answers of strangers, who knew no card: no right one is refused, and most wrong ones explained.

They lie in ``answers/``, as they were written: with the pages and the starters, and nothing else.
Four folders hold right answers, in lists named ``ANSWERS``. One holds wrong ones, in lists named
``WRONG``, each with what is wrong and on which input. Some of these are right by the statement as
it is today: ``answers/allowed.yml`` says why.
"""

from __future__ import annotations

import contextlib
import io
from collections import Counter
from functools import cache

import pytest
import yaml

from labutils.checks import judge
from labutils.checks.calls import Function
from labutils.checks.gates import find_failure
from labutils.checks.inputs import collect_and_watch
from labutils.checks.table import CheckTable, load_table
from labutils.checks.verdict import MAX_LINES, Verdict
from solutions import load_exercises
from tests.helpers.answers import ANSWERED, FOLDER, RIGHT, WRONG, load_answers
from tests.helpers.hidden_cases import make_hidden_table

HIDDEN_SEEDS = 3

#: Of wrong answers: how many may get through, and how many of the others are explained.
MAX_THROUGH = 0.02
MIN_EXPLAINED = 0.9


def judge_quietly(name: str, function: Function) -> Verdict:
    """Judge an answer; what it prints is its own affair."""
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        return judge(load_table(name), function)


@cache
def make_hidden_tables(name: str) -> tuple[CheckTable, ...]:
    return tuple(make_hidden_table(name, seed) for seed in range(HIDDEN_SEEDS))


def passes_hidden_cases(name: str, function: Function) -> bool:
    for table in make_hidden_tables(name):
        with contextlib.redirect_stdout(io.StringIO()):
            answers, changed = collect_and_watch(table, function)
        if changed or find_failure(table, answers):
            return False
    return True


@pytest.mark.parametrize(("folder", "name"), RIGHT)
def test_no_right_answer_of_a_stranger_is_refused(folder: str, name: str) -> None:
    refused = {
        function.__name__: verdict.message
        for function in load_answers(folder, name).ANSWERS
        if not (verdict := judge_quietly(name, function)).passed
    }
    assert refused == {}


@pytest.mark.slow
@pytest.mark.parametrize(("folder", "name"), RIGHT)
def test_no_right_answer_of_a_stranger_fails_hidden_cases(folder: str, name: str) -> None:
    functions = load_answers(folder, name).ANSWERS
    refused = [one.__name__ for one in functions if not passes_hidden_cases(name, one)]
    assert refused == []


def read_allowed() -> dict[str, dict[str, str]]:
    """Read which answers of the wrong folder the statement allows, each with the reason."""
    allowed: dict[str, dict[str, str]] = yaml.safe_load(
        (FOLDER / "allowed.yml").read_text(encoding="utf-8")
    )
    return allowed


def list_wrong(name: str) -> list[Function]:
    allowed = read_allowed().get(name, {})
    return [one for one, _ in load_answers("wrong", name).WRONG if one.__name__ not in allowed]


def test_answers_are_to_exercises_that_exist() -> None:
    assert {name for _, name in ANSWERED} <= set(load_exercises())
    assert len({folder for folder, _ in RIGHT}) == 4


def test_what_is_allowed_names_an_answer_and_a_reason() -> None:
    for name, reasons in read_allowed().items():
        known = {one.__name__ for one, _ in load_answers("wrong", name).WRONG}
        assert set(reasons) <= known
        assert all(len(reason) > 15 for reason in reasons.values())


def describe(verdict: Verdict) -> str:
    """Say what explains a failure: a mistake, a relation, a probe or an early gate."""
    if verdict.passed:
        return "passed"
    if verdict.misconception or verdict.relation or verdict.probe:
        return "explained"
    if verdict.failed_gate != "value" or "has to raise" in verdict.message:
        return "gate"
    return "not explained"


@pytest.mark.slow
def test_wrong_answers_of_strangers_are_refused_and_explained() -> None:
    counts: Counter[str] = Counter()
    through, unexplained = [], []
    for name in WRONG:
        for function in list_wrong(name):
            verdict = judge_quietly(name, function)
            kind = describe(verdict)
            counts[kind] += 1
            if kind == "not explained":
                unexplained.append(f"{name}: {function.__name__}")
            if verdict.passed and passes_hidden_cases(name, function):
                through.append(f"{name}: {function.__name__}")
            assert len(verdict.message.splitlines()) <= MAX_LINES
    assert len(through) <= MAX_THROUGH * counts.total(), through
    failed = counts.total() - counts["passed"]
    assert len(unexplained) <= (1 - MIN_EXPLAINED) * failed, unexplained
