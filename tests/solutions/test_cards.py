"""The tests of the tests: what every card has to prove of itself."""

import itertools
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import labutils
from content.chapters import find_chapter, list_required
from labutils.checks import judge
from labutils.checks.calls import Function, collect_answers, split_answer
from labutils.checks.compare import is_same_outcome
from labutils.checks.gates import find_failure
from labutils.checks.kinds import get_kind
from labutils.checks.table import Case, CheckTable, Outcome, Part, Parts, Raised
from labutils.checks.verdict import MAX_LINES
from solutions import QUALITY_POINTS, load_exercises
from solutions._model import Exercise

ROOT = Path(__file__).resolve().parents[2]
#: With one case, a constant would pass.
MIN_VISIBLE = 2
PICTURE_AXES = 3
SEEDS = [
    pytest.param(range(3), id="3 seeds"),
    pytest.param(range(3, 20), id="17 more", marks=pytest.mark.slow),
]


#: A loop takes a second where a call takes a millisecond: of what acts, pairs are tested slowly.
PAIRS = [
    pytest.param(False, id="singles"),
    pytest.param(True, id="pairs of what acts in loops", marks=pytest.mark.slow),
]


def acts_in_loops(exercise: Exercise) -> bool:
    return not all(get_kind(part).is_repeatable for part in exercise.parts)


def choose_seeds(exercise: Exercise, seeds: range) -> range:
    """Leave all but one seed of what acts in loops to the slow tests."""
    if not acts_in_loops(exercise):
        return seeds
    return range(1) if seeds.start == 0 else range(1, seeds.stop)


def list_combinations(exercise: Exercise, *, of_loops: bool) -> list[tuple[str, ...]]:
    """List mistakes and pairs; of what acts in loops the mistakes, or the pairs."""
    every = exercise.get_combinations()
    if not acts_in_loops(exercise):
        return [] if of_loops else [*every]
    return [made for made in every if (len(made) == 2) is of_loops]


def get_parts(due: Outcome) -> "Parts | None":
    """Return what is due, or None where that is an exception."""
    if isinstance(due, Raised):
        return None
    assert isinstance(due, tuple), due
    return due


def count_right(table: CheckTable, answers: tuple[Outcome, ...]) -> int:
    """Count the cases that a function has to work for: None, no rows and a black map are free.

    So is an argument handed back, where nothing is to be done.
    """
    return sum(
        is_same_outcome(table.parts, due, answer)
        for case, due, answer in zip(table.cases, table.expected, answers, strict=True)
        if (parts := get_parts(due)) is not None
        and parts[0] is not None
        and parts[0].size
        and (parts[0].ndim < PICTURE_AXES or parts[0].any())
        and not is_handed_in(table, case, due)
    )


def is_handed_in(table: CheckTable, case: Case, due: Outcome) -> bool:
    """Tell whether one of the arguments is the right answer already."""
    given = [split_answer(table.parts, value, ()) for value in case.args]
    return any(is_same_outcome(table.parts, due, one) for one in given)


def test_reference_passes_the_shipped_table(exercise: Exercise, table: CheckTable) -> None:
    verdict = judge(table, exercise.make_wrong(()))
    assert verdict.passed, verdict.message
    assert judge(table, exercise.reference).passed


@pytest.mark.parametrize("seeds", SEEDS)
def test_reference_passes_hidden_cases_of_20_seeds(
    exercise: Exercise, hidden_table: Callable[[int], CheckTable], seeds: range
) -> None:
    for seed in choose_seeds(exercise, seeds):
        hidden = hidden_table(seed)
        assert find_failure(hidden, collect_answers(hidden, exercise.make_wrong(()))) is None


def test_hidden_cases_depend_on_the_seed_and_on_nothing_else(exercise: Exercise) -> None:
    def outcomes(seed: int) -> tuple[Outcome, ...]:
        cases = exercise.hidden(np.random.default_rng(seed))
        return exercise.collect(exercise.reference, cases)

    if acts_in_loops(exercise):
        # The same is due of every ball: that it stays in the middle.
        here, again, there = (exercise.hidden(np.random.default_rng(n)) for n in (3, 3, 4))
        assert here == again
        assert all(one.args != two.args for one, two in zip(here, there, strict=True))
        return
    for same, other in zip(outcomes(3), outcomes(3), strict=True):
        assert is_same_outcome(exercise.parts, same, other)
    assert not all(
        is_same_outcome(exercise.parts, a, b) for a, b in zip(outcomes(3), outcomes(4), strict=True)
    )


def test_untouched_starter_scores_0(
    exercise: Exercise, table: CheckTable, hidden_table: Callable[[int], CheckTable]
) -> None:
    source = (ROOT / "exercises/_generated" / f"{exercise.name}.py").read_text(encoding="utf-8")
    space: dict[str, Any] = {}
    exec(compile(source, "starter", "exec"), space)  # noqa: S102 - our own file
    starter = space[exercise.name]
    for cases in (table, hidden_table(0)):
        assert count_right(cases, collect_answers(cases, starter)) == 0
    verdict = judge(table, starter)
    assert (verdict.passed, verdict.failed_gate) == (False, "runs")
    assert "Not started yet" in verdict.message


@pytest.mark.parametrize("of_loops", PAIRS)
def test_every_mistake_and_pair_is_named_as_itself(
    exercise: Exercise, table: CheckTable, of_loops: bool
) -> None:
    for made in list_combinations(exercise, of_loops=of_loops):
        verdict = judge(table, exercise.make_wrong(made))
        assert not verdict.passed, f"{made} passes the visible cases: add a case that shows it"
        named = verdict.misconception
        assert named == " + ".join(made), f"{made} looks like {named}: part them, or list Absorbed"
        assert verdict.failed_gate is not None


@pytest.mark.parametrize("seeds", SEEDS)
def test_every_mistake_fails_hidden_cases_of_20_seeds(
    exercise: Exercise, hidden_table: Callable[[int], CheckTable], seeds: range
) -> None:
    for seed in choose_seeds(exercise, seeds):
        hidden = hidden_table(seed)
        for mistake in exercise.misconceptions:
            answers = collect_answers(hidden, exercise.make_wrong((mistake.name,)))
            failure = find_failure(hidden, answers)
            assert failure, f"{mistake.name} passes the hidden cases of seed {seed}"


@pytest.mark.parametrize("of_loops", PAIRS)
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_every_pair_fails_hidden_cases(
    exercise: Exercise, hidden_table: Callable[[int], CheckTable], seed: int, of_loops: bool
) -> None:
    hidden = hidden_table(seed)
    for made in list_combinations(exercise, of_loops=of_loops):
        assert find_failure(hidden, collect_answers(hidden, exercise.make_wrong(made))), made


def test_pairs_that_are_not_told_apart_really_coincide(
    exercise: Exercise, table: CheckTable
) -> None:
    pairs = math.comb(len(exercise.misconceptions), 2)
    tested = sum(len(made) == 2 for made in exercise.get_combinations())
    assert len(exercise.absorbed) == pairs - tested
    for one in exercise.absorbed:
        verdict = judge(table, exercise.make_wrong((one.first, one.second)))
        assert verdict.misconception in (one.first, one.second), one


def test_constants_nan_and_echoes_score_0(
    table: CheckTable, hidden_table: Callable[[int], CheckTable]
) -> None:
    def shaped_like_expected(fill: float, cases: CheckTable) -> Function:
        """Answer with the right shapes and one number everywhere."""
        answers = iter(cases.expected)

        def function(*_: object) -> object:
            due = get_parts(next(answers))
            if due is None:
                return None
            parts = tuple(
                part if part is None else np.full(part.shape, fill, float).astype(part.dtype)
                for part in due
            )
            returned = parts[: len(parts) - sum(get_kind(one).is_observed for one in cases.parts)]
            return returned if len(returned) > 1 else returned[0]

        return function

    for cases in (table, hidden_table(0)):
        functions = [
            shaped_like_expected(fill, cases)
            for fill in (0, 1, 255, *((np.nan,) if table.parts[0].dtype == "float" else ()))
        ]
        functions += [lambda *_, value=value: value for value in (0, 1.0, (), (0, 0), np.nan, "x")]
        functions += [lambda *args, n=n: args[n] for n in range(len(table.parameters))]
        functions.append(lambda *args: args)
        for function in functions:
            answers = collect_answers(cases, function)
            assert find_failure(cases, answers)
            assert count_right(cases, answers) == 0


def test_an_argument_is_the_right_answer_in_one_case_at_most(
    table: CheckTable, hidden_table: Callable[[int], CheckTable]
) -> None:
    # or such cases, which the counting leaves out, could be all there are
    for cases in (table, hidden_table(0)):
        pairs = zip(cases.cases, cases.expected, strict=True)
        assert sum(is_handed_in(cases, case, due) for case, due in pairs) <= 1


def test_answer_of_another_case_scores_0(table: CheckTable) -> None:
    assert len(table.cases) >= MIN_VISIBLE, f"expected {MIN_VISIBLE} visible cases that differ"
    shifted = (*table.expected[1:], table.expected[0])
    assert find_failure(table, shifted)
    assert count_right(table, shifted) == 0


def test_some_parts_have_a_tolerance_and_some_a_share() -> None:
    # or the two tests below would pass by finding nothing
    parts = [part for exercise in load_exercises().values() for part in exercise.parts]
    assert sum(part.atol > 0 for part in parts) > len(load_exercises()) / 2
    assert sum(part.share > 0 for part in parts) > 2


@pytest.mark.parametrize(("factor", "passes"), [(10, False), (0.1, True)])
def test_tolerance_is_load_bearing(
    exercise: Exercise, table: CheckTable, factor: float, passes: bool
) -> None:
    for number, part in enumerate(exercise.parts):
        if part.atol == 0:
            continue
        for sign in (1, -1) if part.dtype in ("float", "int") else (1,):
            answers: list[Outcome] = []
            for due in table.expected:
                parts = get_parts(due)
                if parts is None or (value := parts[number]) is None:
                    answers.append(due)
                    continue
                moved = get_kind(part).make_shifted(part, value, sign * factor * part.atol)
                answers.append((*parts[:number], moved, *parts[number + 1 :]))
            # A range may be left by a rounding error; its gate has the same tolerance.
            assert (find_failure(table, tuple(answers)) is None) is passes, part.name


@pytest.mark.parametrize(("factor", "passes"), [(10, False), (0.1, True)])
def test_share_of_pixels_is_load_bearing(
    exercise: Exercise, table: CheckTable, factor: float, passes: bool
) -> None:
    for number, part in enumerate(exercise.parts):
        if part.share == 0:
            continue
        answers: list[Outcome] = []
        for due in table.expected:
            parts = get_parts(due)
            if parts is None:
                answers.append(due)
                continue
            shown = parts[number]
            assert shown is not None
            value = shown.copy()
            count = int(np.ceil(factor * part.share * value.size)) if factor > 1 else 0
            count = count or int(factor * part.share * value.size)
            flat = value.reshape(-1)
            flat[:count] = 255 - flat[:count] if part.dtype == "uint8" else flat[:count] + 1
            answers.append((*parts[:number], value, *parts[number + 1 :]))
        assert (find_failure(table, tuple(answers)) is None) is passes, part.name


def test_messages_are_short_and_keep_the_right_numbers_to_themselves(
    exercise: Exercise, table: CheckTable
) -> None:
    made = list_combinations(exercise, of_loops=False)
    functions = [exercise.make_wrong(one) for one in made]
    functions += [
        lambda *_: 0.0,
        lambda *_: (0, 0),
        lambda *_: np.zeros((3, 3)),
        lambda *args: args,
    ]
    for function in functions:
        message = judge(table, function).message
        assert len(message.splitlines()) <= MAX_LINES < 12
        assert max(map(len, message.splitlines())) <= 110
        numbers = set(re.findall(r"-?\d+(?:\.\d+)?", message))
        # Of many numbers the typical residual is told with one digit, which may coincide.
        precisions = (2, 3, 4, 6) if "typically by" in message else (1, 2, 3, 4, 6)
        for part, value in secret_numbers(table):
            texts = {f"{value:.{digits}f}" for digits in precisions} | {repr(float(value))}
            if part.dtype == "int":
                continue  # whole pixels cannot be told from counts; residuals never print them
            assert not numbers & texts, (message, value)


def secret_numbers(table: CheckTable) -> Iterator[tuple[Part, float]]:
    """List the values due that are few enough to be copied from a message."""
    for due in map(get_parts, table.expected):
        if due is None:
            continue
        for part, value in zip(table.parts, due, strict=True):
            if value is not None and get_kind(part).is_few:
                for number in np.ravel(value):
                    if number not in (0, 1):
                        yield part, number


def test_misconceptions_of_one_card_say_different_things(exercise: Exercise) -> None:
    texts = [one.text for one in exercise.misconceptions]
    assert len(set(texts)) == len(texts), "two mistakes have the same text"
    assert len(set(exercise.hints)) == 3, "expected three different hints"


def test_points_are_the_rubric_of_the_lab() -> None:
    points = {chapter.id: 0 for chapter in list_required()}
    for exercise in load_exercises().values():
        if exercise.chapter in points:
            points[exercise.chapter] += exercise.points
        else:
            assert exercise.points == 0, "an extension has no points"
    assert list(points.values()) == [15, 15, 20, 20, 20, 0]
    assert sum(points.values()) + QUALITY_POINTS == 100


def test_lab_exercise_refers_to_the_library_and_a_challenge_does_not(
    exercise: Exercise,
) -> None:
    in_library = hasattr(labutils, exercise.name)
    assert exercise.is_challenge != in_library, "a challenge is what the library does not answer"
    if not exercise.is_challenge:
        assert exercise.reference is getattr(labutils, exercise.name)


def test_verdicts_link_to_headings_and_places_that_exist(table: CheckTable) -> None:
    for link in (table.section, *table.links.values()):
        match = re.fullmatch(r"\.\./(book/\w+)\.html#([\w-]+)", link)
        assert match, link
        page, label = match.groups()
        assert find_chapter(page)
        assert f"\n({label})=\n" in (ROOT / f"{page}.md").read_text(encoding="utf-8")


def test_mistake_with_its_own_section_leads_there(exercise: Exercise, table: CheckTable) -> None:
    for mistake in exercise.misconceptions:
        verdict = judge(table, exercise.make_wrong((mistake.name,)))
        assert verdict.link.endswith(f"#{mistake.section or exercise.section}")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"hints": ("one",)}, "expected 3 hints"),
        ({"misconceptions": ()}, "at least 4 different misconceptions"),
        ({"points": -1}, "points of 0 or more"),
        ({"points": 0}, "expected points, its reference is in the library"),
        ({"chapter": "step9"}, "expected one of start, .*step6.*, got 'step9'"),
        ({"objectives": ()}, "at least one objective"),
        ({"section": "page-step3"}, "a label such as"),
        ({"section": "step3-nowhere"}, "a label such as"),
        ({"section": "ref-serra"}, "a label such as"),
        ({"name": "other"}, "the reference is called"),
        ({"tolerance_reason": ""}, "a reason"),
        (
            {"parts": (Part("depth", "dpeth", "float"),)},
            "depth: expected a kind of number, .*'dpeth'",
        ),
    ],
)
def test_incomplete_card_is_refused(change: dict[str, Any], words: str) -> None:
    card = load_exercises()["process_depth"]
    with pytest.raises(ValueError, match=words):
        replace(card, **change)


def test_card_with_unknown_absorbed_mistake_is_refused() -> None:
    card = load_exercises()["process_depth"]
    wrong = replace(card.absorbed[0], first="nobody")
    with pytest.raises(ValueError, match="nobody"):
        replace(card, absorbed=(wrong,))


def test_card_whose_mistakes_do_not_start_from_the_reference_is_refused() -> None:
    card = load_exercises()["process_depth"]
    broken = replace(card, answer_with=lambda _, raw, *__: raw)
    with pytest.raises(ValueError, match="without mistakes differs"):
        broken.freeze()


def test_card_whose_reference_fails_is_refused() -> None:
    card = load_exercises()["process_depth"]
    case = replace(card.visible()[0], args=("no picture", 0.1, 4.0))
    with pytest.raises(ValueError, match="the reference fails"):
        card.freeze((case,))


@pytest.mark.parametrize(("name", "text"), [("Two words", "x" * 50 + "."), ("short", "No.")])
def test_misconception_without_name_or_text_is_refused(name: str, text: str) -> None:
    one = load_exercises()["process_depth"].misconceptions[0]
    with pytest.raises(ValueError, match="misconception"):
        replace(one, name=name, text=text)


def test_all_pairs_of_a_card_are_tested_or_listed(exercise: Exercise) -> None:
    names = [one.name for one in exercise.misconceptions]
    pairs = {frozenset(pair) for pair in itertools.combinations(names, 2)}
    tested = {frozenset(made) for made in exercise.get_combinations() if len(made) == 2}
    listed = {frozenset((one.first, one.second)) for one in exercise.absorbed}
    assert tested | listed == pairs
    assert not tested & listed
