"""The path: which exercises are required, how hard they are, and what both paths take."""

from __future__ import annotations

import pytest

from content.difficulty import LEVELS, get_difficulty, rate
from content.path import (
    add_minutes,
    get_minimal_minutes,
    get_strong_minutes,
    read_path,
    say_hours,
)
from labutils.checks.table import read_words
from solutions import load_exercises
from tools.derive.difficulty import count_steps, rate_exercise

WORDS = {
    "find_it": {"title": "Find it", "chapter": "1", "points": 5, "difficulty": "hard"},
    "more": {"title": "More", "chapter": "1", "points": 0, "difficulty": "easy"},
}


@pytest.mark.parametrize(
    ("steps", "objectives", "name"),
    [(1, 1, "easy"), (6, 1, "easy"), (6, 2, "medium"), (9, 3, "medium"), (9, 4, "hard")],
)
def test_the_size_of_an_exercise_is_its_steps_and_objectives(
    steps: int, objectives: int, name: str
) -> None:
    assert rate(steps, objectives).name == name


def test_levels_are_told_apart_without_color() -> None:
    assert len({one.mark for one in LEVELS}) == len({one.name for one in LEVELS}) == 3
    assert [one.minutes for one in LEVELS] == sorted(one.minutes for one in LEVELS)
    with pytest.raises(ValueError, match="expected one of easy, medium, hard, got 'harsh'"):
        get_difficulty("harsh")


def test_steps_are_statements_but_not_checks_of_arguments() -> None:
    source = '''
    def find(image, limit):
        """Say what it does."""
        image = check_image("image", image)
        if limit < 0:
            raise ValueError("limit")
        found = image > limit
        if found.any():
            image = image[found]
        else:
            return None
        return image
    '''
    assert count_steps(source) == 5
    with pytest.raises(TypeError, match="expected a function, got Assign"):
        count_steps("a = 1")


def test_the_difficulty_that_pages_read_is_that_of_the_cards() -> None:
    for name, exercise in load_exercises().items():
        assert read_words()[name]["difficulty"] == rate_exercise(exercise).name, name


def test_points_part_what_is_required_from_what_is_not() -> None:
    path = {leg.chapter.id: leg for leg in read_path(WORDS)}
    step1 = path["step1"]
    assert [one.name for one in step1.required] == ["find_it"]
    assert [one.anchor for one in step1.required] == ["exercise-find-it"]
    assert [one.name for one in step1.optional] == ["more"]
    assert path["step2"].required == path["background"].required == ()
    optional = [leg for leg in path.values() if not leg.is_required]
    assert [leg.chapter.id for leg in optional if not leg.chapter.is_extension] == [
        "background",
        "projection-matrix",
        "conventions",
    ]


def test_paths_add_up_what_their_pages_and_exercises_say() -> None:
    path = [leg for leg in read_path(WORDS) if not leg.chapter.is_extension]
    pages = sum(leg.minutes.total for leg in path)
    skipped = sum(leg.minutes.total for leg in path if not leg.is_required)
    assert add_minutes(next(leg for leg in path if leg.required).required) == 35
    assert get_minimal_minutes(path) == pages - skipped + 35
    assert get_strong_minutes(path) == pages + 35 + 15


def test_the_required_path_takes_about_eight_hours() -> None:
    path = read_path(read_words())
    assert say_hours(get_minimal_minutes(path)) == "about 8 hours"
    assert get_strong_minutes(path) > get_minimal_minutes(path)


@pytest.mark.parametrize(
    ("minutes", "said"),
    [(0, "about 1 hour"), (80, "about 1 hour"), (95, "about 2 hours"), (415, "about 7 hours")],
)
def test_hours_are_told_as_whole_ones(minutes: int, said: str) -> None:
    assert say_hours(minutes) == said
