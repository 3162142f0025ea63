"""The mutants of the references: how they are made, and that the scores in the table are true."""

from __future__ import annotations

import ast
import signal
import zlib
from collections import Counter

import pytest

import labutils
from labutils.checks.calls import call_once
from labutils.checks.compare import is_same_outcome
from labutils.checks.table import Case, Misfit, Raised
from solutions import load_exercises
from tools import ROOT
from tools.mutants.build import build, collect_pieces, list_mutants
from tools.mutants.inputs import MAKERS, count_draws, draw_input
from tools.mutants.judge import Judge
from tools.mutants.operators import apply, find_mutations
from tools.mutants.reasons import REASONS, get_reason
from tools.mutants.score import (
    HIDDEN_LIMIT,
    TABLE,
    VISIBLE_LIMIT,
    Score,
    make_table,
    read_scores,
    score_exercise,
)

NAMES = tuple(load_exercises())
SCORES = read_scores()
NEEDS_TIMER = pytest.mark.skipif(
    not hasattr(signal, "setitimer"), reason="a loop without an end is stopped by a Unix timer"
)

SOURCE = '''
def pick(values, limit):
    """Not a number: 3."""
    if not values or limit < 0:
        raise ValueError(f"limit: expected 1 or more, got {limit + 1}")
    total = -values[1] * 2.5
    total = max(total, limit)
    return total, values[1:]
'''


def parse(source: str) -> ast.FunctionDef:
    (function,) = ast.parse(source).body
    assert isinstance(function, ast.FunctionDef)
    return function


@pytest.mark.parametrize(
    "changed",
    [
        "if values or limit < 0:",  # not lost
        "if not values and limit < 0:",
        "if not values or limit <= 0:",
        "if not values or limit > 0:",
        "if not values or limit < 1:",
        "total = values[1] * 2.5",  # unary minus lost
        "total = -values[2] * 2.5",
        "total = -values[0] * 2.5",
        "total = -values[1] / 2.5",
        "total = -values[1] * 3.5",
        "total = -values[1] * 5.0",
        "total = -values[1] * -2.5",
        "total = min(total, limit)",
        "return (total, values[:])",
        "return (total, values[0:])",
    ],
)
def test_every_operator_makes_its_fault(changed: str) -> None:
    tree = parse(SOURCE)
    texts = [ast.unparse(apply(tree, one)) for one in find_mutations(tree)]
    lines = [{line.strip() for line in text.splitlines()} for text in texts]
    assert sum(changed in one for one in lines) == 1


def test_lines_are_lost_only_where_every_name_keeps_a_value() -> None:
    tree = parse(SOURCE)
    lost = {one.change for one in find_mutations(tree) if one.operator == "line-lost"}
    assert lost == {
        "`if not values or limit < 0:` lost",
        "`total = max(total, limit)` lost",
    }


def test_no_fault_is_in_the_words_of_an_error_or_of_a_docstring() -> None:
    tree = parse(SOURCE)
    texts = [ast.unparse(apply(tree, one)) for one in find_mutations(tree)]
    assert texts
    assert all("Not a number: 3." in text for text in texts)
    assert all("{limit + 1}" in text for text in texts if "raise" in text)


def test_names_of_mutants_do_not_depend_on_lines_and_layout() -> None:
    moved = "# a comment\n\n\n" + SOURCE.replace("limit < 0", "(limit\n        < 0)")
    one, other = (find_mutations(parse(source)) for source in (SOURCE, moved))
    assert [(a.place, a.operator) for a in one] == [(b.place, b.operator) for b in other]
    assert len({(a.place, a.operator) for a in one}) == len(one)


@pytest.mark.parametrize("name", NAMES)
def test_copy_without_a_fault_answers_as_the_reference_on_valid_inputs(name: str) -> None:
    exercise = load_exercises()[name]
    copy = build(exercise.reference)
    assert copy is not exercise.reference
    for number in range(min(20, count_draws(name))):
        case = Case("a draw", draw_input(name, number))
        due = exercise.make_due(call_once(exercise.parts, case, exercise.reference))
        assert is_same_outcome(exercise.parts, due, call_once(exercise.parts, case, copy))
        assert not isinstance(due, Misfit)
        if isinstance(due, Raised):  # an input that a statement promises an error for
            assert any(one.raises == due.kind for one in exercise.visible())


@pytest.mark.parametrize("name", NAMES)
def test_card_agrees_with_its_reference_on_valid_inputs(name: str) -> None:
    exercise = load_exercises()[name]
    for number in range(min(20, count_draws(name))):
        case = Case("a draw", draw_input(name, number))
        due = exercise.make_due(call_once(exercise.parts, case, exercise.reference))
        again = call_once(exercise.parts, case, exercise.make_wrong(()))
        assert is_same_outcome(exercise.parts, due, again), number


def test_mutant_of_the_library_leaves_the_library_alone() -> None:
    before = labutils.intrinsics_matrix(0.9, 64, 48)
    mutants = list_mutants(labutils.intrinsics_matrix)
    (half,) = [one for one in mutants if one.change.startswith("`0.5 * height` to")]
    assert build(labutils.intrinsics_matrix, half)(0.9, 64, 48)[0, 0] != before[0, 0]
    assert (labutils.intrinsics_matrix(0.9, 64, 48) == before).all()


def test_pieces_are_our_own_code_below_the_reference_and_its_constants() -> None:
    names = {one.name for one in collect_pieces(labutils.depth_to_pointcloud)}
    assert {"depth_to_pointcloud", "back_project", "find_valid_depth", "MAX_DEPTH"} <= names
    rooms = {one.module.partition(".")[0] for one in collect_pieces(labutils.render_camera)}
    assert rooms == {"labutils"}


@NEEDS_TIMER
def test_loop_without_an_end_is_refused() -> None:
    judge = Judge(load_exercises()["fill_invalid_depth"], 3, 1)

    def never(_: object) -> object:
        while True:
            pass

    assert judge.is_refused(never, judge.visible)
    assert not judge.is_refused(judge.exercise.reference, judge.visible)


def test_every_exercise_has_inputs_and_a_row() -> None:
    assert set(MAKERS) == set(NAMES)
    assert tuple(SCORES) == NAMES
    assert (ROOT / TABLE).read_text(encoding="utf-8") == make_table(SCORES)


@pytest.mark.parametrize("name", NAMES)
def test_scores_are_of_the_mutants_there_are_and_reach_the_limits(name: str) -> None:
    score = SCORES[name]
    names = [one.id for one in list_mutants(load_exercises()[name].reference)]
    assert len(set(names)) == len(names) == score.mutants, "run `make mutants`"
    assert score.draws == count_draws(name)
    assert score.visible_share >= VISIBLE_LIMIT
    assert score.hidden_share >= HIDDEN_LIMIT
    for survivor in (*score.visible, *score.hidden):
        assert survivor in names
        assert get_reason(survivor), f"{survivor} passes: add a case, or a reason"


def test_every_reason_is_of_a_mutant_that_passes() -> None:
    survivors = [one for score in SCORES.values() for one in (*score.visible, *score.hidden)]
    for start in REASONS:
        assert any(one.startswith(start) for one in survivors), start


@NEEDS_TIMER
@pytest.mark.parametrize("name", NAMES)
def test_three_mutants_end_as_the_table_says(name: str) -> None:
    draws = min(25, count_draws(name))
    judge, score = Judge(load_exercises()[name], draws, 1), SCORES[name]
    chosen = 0
    for mutant in sorted(judge.mutants, key=lambda one: zlib.crc32(one.id.encode())):
        function = judge.make(mutant)
        if not judge.differs(mutant, function):
            continue
        passes_visible = not judge.is_refused(function, judge.visible)
        passes_hidden = not judge.is_refused(function, judge.hidden[0])
        assert passes_visible == (mutant.id in score.visible), mutant.change
        assert not passes_hidden or mutant.id in score.hidden, mutant.change
        chosen += 1
        if chosen == 3:
            return
    pytest.fail("expected three mutants that differ on 25 draws")


@pytest.mark.slow
@NEEDS_TIMER
@pytest.mark.parametrize("name", NAMES)
def test_all_mutants_end_as_the_table_says(name: str) -> None:
    stored = SCORES[name]
    score = score_exercise(load_exercises()[name], draws=min(60, stored.draws), seeds=2)
    assert score.mutants == stored.mutants
    assert 0.9 * stored.differing <= score.differing <= stored.differing
    assert set(score.visible) <= set(stored.visible)
    for mutant, seeds in score.hidden.items():
        assert seeds <= stored.hidden.get(mutant, 0), mutant


@pytest.mark.slow
@NEEDS_TIMER
def test_nine_of_ten_mutants_that_fail_are_explained() -> None:
    counts: Counter[bool] = Counter()
    for name, exercise in load_exercises().items():
        mutants = Judge(exercise, 1, 1)
        for mutant in mutants.mutants:
            if (verdict := mutants.find_verdict(mutants.make(mutant))) is None or verdict.passed:
                continue
            told = (verdict.misconception, verdict.relation, verdict.probe)
            assert verdict.result == "failed", f"{name}: {mutant.change}: {verdict.message}"
            counts[any(told) or verdict.failed_gate != "value"] += 1
    assert counts.total() > 1000
    assert counts[True] >= 0.9 * counts.total()


def test_share_is_of_the_mutants_that_differ() -> None:
    score = Score(50, 10, 40, visible=["a"], hidden={"a": 2, "b": 1}, worst=2)
    assert (score.visible_share, score.hidden_share) == (0.975, 0.95)
