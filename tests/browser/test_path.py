"""The path through the book in a browser: groups, counts, the way on, by keyboard, on a phone."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from content.chapters import list_taught, load_chapters
from solutions import load_exercises

PAGE = "exercises/step3_depth"  # of its exercises, none needs the simulator
MOST_KEYS = 8  # from the top of an exercise page to its editor; without the skip link 50 and more
FIRST = ["the exercise render_camera", "step1_camera.html", "#exercise-render-camera"]
ANSWER = """
import numpy as np


def process_depth(depth_raw, near, far):
    kind = np.float64 if depth_raw.dtype == np.float64 else np.float32
    share = np.clip(depth_raw.astype(float), 0, 1)
    return (near * far / (far - share * (far - near))).astype(kind)
"""
COUNTS = [
    f"0/{sum(one.chapter == chapter.id for one in load_exercises().values())}"
    for chapter in list_taught()
]


@pytest.fixture(scope="module")
def followed(
    use_python: Callable[..., Any], tmp_path_factory: pytest.TempPathFactory
) -> dict[str, Any]:
    """What a reader saw who followed the path; opened from files."""
    answer = tmp_path_factory.mktemp("path") / "answer.py"
    answer.write_text(ANSWER, encoding="utf-8")
    seen: dict[str, Any] = use_python("path", PAGE, answer)
    return seen


def test_each_step_of_the_sidebar_has_its_exercises_below_it(followed: dict[str, Any]) -> None:
    assert followed["fresh"]["groups"] == [
        [chapter.heading, f"Exercises of {chapter.lower}"] for chapter in list_taught()
    ]


def test_nothing_done_shows_counts_of_zero_and_no_way_on(followed: dict[str, Any]) -> None:
    fresh = followed["fresh"]
    assert fresh["counts"] == COUNTS
    assert fresh["labels"][0] == "0 of 4 solved"
    assert (fresh["done"], fresh["goOn"]) == ([], None)
    assert fresh["rows"] == len(load_chapters())


@pytest.mark.parametrize(
    ("reader", "way_on"),
    [
        ("begun", ["the exercise render_camera", "step1_camera.html", "#exercise-render-camera"]),
        (
            "predicted",
            ["the exercise render_camera", "step1_camera.html", "#exercise-render-camera"],
        ),
        ("solved", ["Step 2: Which direction does a pixel look?", "step2_intrinsics.html", ""]),
    ],
)
def test_the_way_on_is_the_first_thing_that_is_not_done(
    followed: dict[str, Any], reader: str, way_on: list[str]
) -> None:
    text, page, place = way_on
    assert followed[reader]["goOn"] == [f"Go on with {text}", page, place]
    assert followed[reader]["complaints"] == []


def test_a_solved_exercise_counts_in_the_sidebar_and_in_its_row(followed: dict[str, Any]) -> None:
    solved = followed["solved"]
    assert solved["counts"] == ["1/4", *COUNTS[1:]]
    assert solved["labels"][0] == "1 of 4 solved"
    (done,) = solved["done"]
    assert done == "required 1 of 1, challenges 0 of 3, questions 0 of 5, predictions 0 of 5"
    assert solved["bars"] == [[1, 11]]  # challenges are nobody's duty


def test_what_is_not_ours_in_the_store_counts_as_nothing(followed: dict[str, Any]) -> None:
    assert followed["damaged"]["counts"] == COUNTS
    assert followed["damaged"]["complaints"] == []


def test_without_scripts_there_are_groups_and_rows_but_no_numbers(followed: dict[str, Any]) -> None:
    assert followed["plain"] == {
        "counts": 0,
        "goOn": 0,
        "rows": len(load_chapters()),
        "groups": len(list_taught()),
    }


def test_the_drawer_of_a_phone_leads_to_the_exercises(followed: dict[str, Any]) -> None:
    phone = followed["phone"]
    assert phone["sideways"] <= 0
    assert phone["fits"]
    assert phone["reached"].endswith("exercises/step3_depth.html")
    assert phone["barriers"] == []


def test_the_keyboard_reaches_the_editor_in_few_stops(followed: dict[str, Any]) -> None:
    stops = followed["keyboard"]["stops"]
    assert stops[:3] == ["Skip to main content", "Skip to the exercises", "Enter"]
    assert len(stops) <= MOST_KEYS, stops
    assert followed["keyboard"]["hash"] == "#exercise-process-depth"


def test_a_pass_counts_at_once_here_and_in_another_tab(followed: dict[str, Any]) -> None:
    done = followed["pass"]
    assert done["complaints"] == []
    assert done["before"] == "0/3"
    assert done["said"]["result"] == "passed", done["said"]
    assert done["after"] == "1/3"
    assert done["elsewhere"]["counts"][2] == "1/3"
    assert done["skip"] == "#exercise-visualize-depth"


def test_a_starter_that_nobody_has_touched_looks_like_no_mistake(followed: dict[str, Any]) -> None:
    done = followed["pass"]
    assert "Not started yet." in done["starter"]["text"]
    colors = done["colors"]
    assert colors["border"] == colors["control"] != colors["failed"]
