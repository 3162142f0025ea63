"""A statement is a contract: a check keeps each sentence, and a sentence asks for each check."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from labutils.checks.loops.scenario import Loop
from labutils.checks.table import Scene
from solutions import load_exercises
from solutions._contract import Duty, asked, given, told
from tools.derive.contract import GapError, list_ties, make_tables
from tools.derive.sentences import list_sentences, split_docstring, split_sentences

if TYPE_CHECKING:
    from solutions import Exercise

NAMES = tuple(load_exercises())


@pytest.fixture
def card() -> Exercise:
    return load_exercises()["intrinsics_matrix"]


def test_every_sentence_is_kept_and_every_check_is_asked_for() -> None:
    assert [gap for card in load_exercises().values() for gap in list_ties(card)[1]] == []


def find_in(card: Exercise, contract: tuple[Duty, ...]) -> list[str]:
    return list_ties(replace(card, contract=contract))[1]


def test_a_contract_with_gaps_is_not_written(card: Exercise) -> None:
    with pytest.raises(GapError, match="no row says what keeps the sentence"):
        make_tables({card.name: replace(card, contract=())})


def test_a_sentence_without_a_row_is_named(card: Exercise) -> None:
    kept = tuple(duty for duty in card.contract if duty.id != "square")
    (gap,) = find_in(card, kept)
    assert "no row says what keeps the sentence" in gap
    assert "Pixels are square: fx = fy." in gap


def test_a_row_whose_sentence_is_gone_or_not_certain_is_named(card: Exercise) -> None:
    (gone,) = find_in(card, (*card.contract, told("old", "words that nobody wrote")))
    assert gone.startswith("intrinsics_matrix: old: 0 sentences hold the words")
    (twice,) = find_in(card, (*card.contract, told("old", "ield of view")))
    assert "3 sentences hold the words" in twice


def test_a_check_that_does_not_exist_is_named(card: Exercise) -> None:
    (gap,) = find_in(card, (*card.contract, asked("more", "Whole numbers are", "mistake gone")))
    assert gap.endswith("more: there is no check 'mistake gone'")


def test_a_check_that_no_sentence_asks_for_is_named(card: Exercise) -> None:
    kept = tuple(duty for duty in card.contract if duty.id not in ("layout", "projects"))
    kept += (told("layout", "[[f, 0, cx]"), told("projects", "Write the matrix K"))
    loose = {gap.partition("the check ")[2] for gap in find_in(card, kept)}
    assert "'mistake transposed'" in loose
    assert "'mistake twice-as-long'" in loose
    assert "'case the size of the lab, a narrow angle'" in loose


def test_an_id_names_one_row(card: Exercise) -> None:
    (gap,) = find_in(card, (*card.contract, given("size", "Where is the middle?")))
    assert gap.endswith("size: two rows have this id")


@pytest.mark.parametrize(
    ("row", "words"),
    [
        (lambda: told("Two Words", "a"), "expected a name-like-this"),
        (lambda: told("name", " "), "expected words of a sentence"),
        (lambda: asked("name", "a"), "expected checks where something is asked"),
    ],
)
def test_a_row_that_makes_no_sense_is_refused(row: object, words: str) -> None:
    assert callable(row)
    with pytest.raises(ValueError, match=words):
        row()


# ---- What a docstring says of its arguments is true of every case


@pytest.mark.parametrize("name", NAMES)
def test_arguments_have_the_type_that_the_starter_promises(name: str) -> None:
    exercise = load_exercises()[name]
    promised = {
        one: sentence.text.partition(" : ")[2]
        for sentence in list_sentences(exercise)
        if sentence.place == "Parameters"
        for one in sentence.text.partition(" : ")[0].split(", ")
    }
    assert set(promised) == set(exercise.parameters)
    cases = [*exercise.visible()]
    for seed in range(3):
        cases += exercise.hidden(np.random.default_rng(seed))
    for case in cases:
        names = iter(exercise.parameters)
        for value in case.args:
            if isinstance(value, Scene | Loop):
                for _ in value.gives:
                    next(names)
                continue
            one = next(names)
            wish = f"{one}: {promised[one]}, got {value!r}; the card's `asks` may say what comes in"
            assert keeps(promised[one], value), wish


def keeps(promise: str, value: object) -> bool:
    """Tell whether a value is what a docstring calls it: the dtype and the number of axes."""
    if value is None:
        return promise.endswith("optional")
    if not isinstance(value, np.ndarray):
        kinds: dict[str, Any] = {
            "float": (float, int),
            "int": int,
            "str": str,
            "tuple of (": tuple,
            "((": tuple,
        }
        return any(promise.startswith(word) and isinstance(value, kinds[word]) for word in kinds)
    dtypes = promise.removeprefix("ndarray, ").partition(", ")[0].split(" or ")
    shapes = [shape.count(",") + 1 - shape.endswith(",") for shape in find_shapes(promise)]
    return value.dtype.name.startswith(tuple(dtypes)) and value.ndim in shapes


def find_shapes(promise: str) -> list[str]:
    return [piece.partition(")")[0] for piece in promise.split("(")[1:]]


# ---- Taking texts apart


def test_a_paragraph_is_split_where_a_sentence_ends() -> None:
    text = "It takes 2.5 m. *Then* it stops: why? See section 6.1. `K` is K."
    assert split_sentences(text) == [
        "It takes 2.5 m.",
        "*Then* it stops: why?",
        "See section 6.1.",
        "`K` is K.",
    ]


def test_a_docstring_is_split_by_section_and_entry() -> None:
    docstring = (
        "Do it.\n\nParameters\n----------\na, b : int\n    One. Two\n    lines.\n\n"
        "They stay.\n\nReturns\n-------\nfloat\n    It.\n\nReferences\n----------\n.. [1] A book."
    )
    assert [str(one) for one in split_docstring(docstring)] == [
        "summary: Do it.",
        "Parameters: a, b : int",
        "Parameters, a, b: One.",
        "Parameters, a, b: Two lines.",
        "summary: They stay.",
        "Returns: float",
        "Returns, float: It.",
    ]


def test_the_table_shows_every_sentence_of_a_card(card: Exercise) -> None:
    ties, gaps = list_ties(card)
    assert gaps == []
    assert {tie.sentence for tie in ties} == set(list_sentences(card))
