"""Completions: a twin before each exercise with points, checked like it, and counted nowhere."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labutils.checks import check, hint, judge, report
from labutils.checks.progress_rules import FILE_NAME
from labutils.checks.table import CheckTable, load_table, read_completions
from labutils.checks.verdict import HIDDEN_CASES, MAX_LINES
from solutions import load_exercises
from solutions._completion import Completion, Slip, find_open_lines, get_target
from solutions._model import Exercise
from tests.helpers.chapters import ROOT
from tests.helpers.examples import run_set_up
from tools.derive.completions import make_starter

CARDS = [card for card in load_exercises().values() if card.completion is not None]


@pytest.fixture(params=CARDS, ids=lambda card: card.name)
def card(request: pytest.FixtureRequest) -> Exercise:
    found: Exercise = request.param
    return found


@pytest.fixture
def completion(card: Exercise) -> Completion:
    assert card.completion is not None
    return card.completion


@pytest.fixture
def table(completion: Completion) -> CheckTable:
    return load_table(completion.name)


def run(code: str, name: str) -> Callable[..., Any]:
    """Return the function that a cell defines."""
    space: dict[str, Any] = {}
    exec(compile(code, "cell", "exec", dont_inherit=True), space)  # noqa: S102 - ours
    function: Callable[..., Any] = space[name]
    return function


def test_exercises_with_points_have_a_completion_and_no_other_has() -> None:
    graded = [name for name, card in load_exercises().items() if card.points]
    assert [card.name for card in CARDS] == graded
    assert list(read_completions()) == [card.completion.name for card in CARDS if card.completion]
    assert not set(read_completions()) & set(load_exercises())


def test_the_whole_twin_passes_and_leads_to_its_exercise(
    card: Exercise, completion: Completion, table: CheckTable
) -> None:
    verdict = judge(table, completion.twin)
    assert verdict.passed, verdict.message
    assert not verdict.counted
    assert f"Now write {card.name} yourself." in verdict.message
    assert HIDDEN_CASES not in verdict.message, "a completion has no hidden cases"


def test_the_starter_is_not_started_and_misses_both_lines(
    completion: Completion, table: CheckTable
) -> None:
    starter = make_starter(completion)
    verdict = judge(table, run(starter, completion.name))
    assert (verdict.passed, verdict.failed_gate, verdict.counted) == (False, "runs", False)
    assert "Not started yet." in verdict.message
    for line in find_open_lines(completion.twin):
        assert line.code not in starter
        assert f"  # {line.asks}\n" in starter
    assert "open:" not in starter


def test_one_line_alone_is_not_enough(completion: Completion, table: CheckTable) -> None:
    for line in find_open_lines(completion.twin):
        code = make_starter(completion).replace(line.blank, line.indent + line.code)
        verdict = judge(table, run(code, completion.name))
        assert not verdict.passed
        assert len(verdict.paragraphs) >= 2, verdict.message


def test_a_wrong_version_of_each_line_fails_and_is_named(
    completion: Completion, table: CheckTable
) -> None:
    assert {get_target(slip.line) for slip in completion.slips} == {
        line.target for line in find_open_lines(completion.twin)
    }
    for slip in completion.slips:
        verdict = judge(table, completion.make_wrong(slip))
        assert not verdict.passed, slip.name
        assert verdict.misconception == slip.name
        assert f"Recognized: {slip.text}" in verdict.paragraphs
        assert len(verdict.message.splitlines()) <= MAX_LINES
        assert not verdict.counted


def test_two_wrong_lines_fail(completion: Completion, table: CheckTable) -> None:
    verdict = judge(table, completion.make_wrong(*completion.slips))
    assert not verdict.passed
    assert verdict.misconception, "neither slip is named"


def test_a_mistake_that_is_not_listed_gets_a_sentence_of_the_engine(
    completion: Completion, table: CheckTable
) -> None:
    def forgets(*_: object) -> None:
        print("and returns nothing")

    def adds(*args: object) -> object:
        answer = completion.twin(*args)
        return tuple(np.add(answer, 9)) if isinstance(answer, tuple) else np.add(answer, 9)

    for function, gate in ((forgets, "runs"), (adds, "value")):
        verdict = judge(table, function)
        assert not verdict.passed
        if completion.name != "find_either_color":  # 255 + 9 is no value of a mask
            assert verdict.failed_gate == gate, verdict.message
        assert verdict.paragraphs[0].endswith(".")


def test_nothing_of_it_is_kept_and_the_report_stays_as_it_was(
    card: Exercise,
    completion: Completion,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    before = repr(report())
    functions = (completion.twin, completion.make_wrong(completion.slips[0]))
    for function in (*functions, run(make_starter(completion), completion.name)):
        check(completion.name, function)
    assert "no hints" in hint(completion.name)
    assert not (tmp_path / FILE_NAME).exists()
    assert repr(report()) == before
    assert completion.name not in before
    assert card.name in before


def test_the_report_counts_nine_exercises_and_ninety_points(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert len(report().rows) == len(load_exercises())
    assert "0 of 9 exercises, 0 of 90 points" in repr(report())


def test_it_stands_on_the_page_right_before_its_exercise(
    card: Exercise, completion: Completion
) -> None:
    text = (ROOT / card.home.exercises).with_suffix(".md").read_text(encoding="utf-8")
    _, _, tail = text.partition(f"<!-- begin completion {card.name} -->\n")
    part, _, rest = tail.partition(f"<!-- end completion {card.name} -->\n")
    assert rest.lstrip().startswith(f"(exercise-{card.name.replace('_', '-')})=\n")
    assert f'check("{completion.name}", {completion.name})' in part
    assert make_starter(completion) in part
    assert f"{{ref}}`{completion.section}`" in part


def test_its_example_runs_with_the_names_of_the_page(
    card: Exercise, completion: Completion, capsys: pytest.CaptureFixture[str]
) -> None:
    names = dict(run_set_up(card.home.exercises))
    angles = names["data"].qpos.tolist()
    exec(completion.example, {**names, completion.name: completion.twin})  # noqa: S102 - ours
    assert capsys.readouterr().out.strip()
    assert names["data"].qpos.tolist() == angles


def leave_one(picture: np.ndarray) -> np.ndarray:
    """Halve a picture."""
    half = picture[::2, ::2]  # open: every second row and column
    return half  # noqa: RET504 - the form of a twin


def test_a_twin_with_another_number_of_open_lines_is_refused(completion: Completion) -> None:
    with pytest.raises(ValueError, match="leave_one: expected 2 open lines, one of which assigns"):
        replace(completion, twin=leave_one)


def test_a_line_without_a_slip_is_refused(completion: Completion) -> None:
    with pytest.raises(ValueError, match="expected slips of the lines that assign"):
        replace(completion, slips=completion.slips[:1])


def test_a_slip_that_is_right_is_refused(card: Exercise, completion: Completion) -> None:
    (line, *_) = (one for one in find_open_lines(completion.twin) if one.target)
    words = "this line is right, and nobody has to be told about it."
    harmless = Slip("harmless", words, line=line.code)
    others = tuple(slip for slip in completion.slips if get_target(slip.line) != line.target)
    same = replace(completion, slips=(harmless, *others))
    with pytest.raises(ValueError, match="passes; add a case that shows it"):
        same.freeze(card)


def test_lines_too_long_for_a_cell_are_refused(completion: Completion) -> None:
    imports = ("import numpy as a_name_that_is_far_too_long_for_any_cell_that_a_page_shows",)
    with pytest.raises(ValueError, match=f"{completion.name}: expected lines of at most"):
        make_starter(replace(completion, imports=imports))


def test_an_unknown_name_lists_exercises_only() -> None:
    with pytest.raises(ValueError, match="exercise: expected one of render_camera") as raised:
        check("colour_heights", None)
    assert "world_to_body" not in str(raised.value)


def test_the_words_say_what_no_exercise_says() -> None:
    words = read_completions()
    assert {one["points"] for one in words.values()} == {0}
    assert [one["leads_to"] for one in words.values()] == [card.name for card in CARDS]
    assert "twin" not in json.dumps(list(words["world_to_body"]))
