"""Widgets with Python behind them: what the reader moves, Python knows, and the other way round."""

from __future__ import annotations

import json
import re
from ast import literal_eval
from collections.abc import Callable
from typing import Any

import pytest

LARGEST = 255  # saturation, whose lower limit is the first handle


@pytest.fixture(scope="module", params=["hsv", "scene", "plain"])
def used(request: pytest.FixtureRequest, seen: dict[str, Any]) -> dict[str, Any]:
    return seen[request.param]


@pytest.fixture(scope="module")
def seen(use_python: Callable[..., Any]) -> dict[str, Any]:
    return use_python("widgets")


def test_the_pages_report_no_problem(used: dict[str, Any]) -> None:
    assert used["complaints"] == []
    assert used["cell"]["result"] == "ran"
    assert used["cell"]["widgets"] >= 1


def test_what_was_moved_before_python_ran_is_moved_in_python(seen: dict[str, Any]) -> None:
    hsv = seen["hsv"]
    low, _ = literal_eval(hsv["carried"])
    assert low[1] == LARGEST - 1
    # the cell below ran after that
    assert hsv["below"]["result"] == "ran"
    assert f"limits ({low}, " in hsv["below"]["text"]


def test_the_live_explorer_takes_the_place_of_the_built_one(seen: dict[str, Any]) -> None:
    cell = seen["hsv"]["cell"]
    assert (cell["isYoursShown"], cell["isBuiltShown"]) == (True, False)


def test_python_reads_what_is_moved_and_picked(seen: dict[str, Any]) -> None:
    hsv = seen["hsv"]
    assert literal_eval(hsv["moved"])[0][1] == 1
    pixel, color = re.findall(r"\(.*?\)", hsv["picked"])
    assert f"Pixel {pixel}: RGB {color.strip('()').replace(',', '')}" in hsv["told"]


def test_of_many_moves_while_python_is_busy_it_hears_the_last(seen: dict[str, Any]) -> None:
    hsv = seen["hsv"]
    assert literal_eval(hsv["afterBusy"])[0][1] == 77 + 20
    # the first move, of a slider and of its view
    assert hsv["sentWhileBusy"] <= 2


def test_an_explorer_whose_python_was_stopped_says_so_and_still_moves(
    seen: dict[str, Any],
) -> None:
    assert seen["hsv"]["stopped"].startswith("Python was stopped")
    assert seen["hsv"]["movesStopped"] == "98"


def test_the_scene_says_whether_it_is_live(seen: dict[str, Any]) -> None:
    assert seen["scene"]["still"] == "Press Run to make this scene live."
    assert seen["scene"]["live"].startswith("Live")


def test_dragging_the_picture_turns_the_head_and_python_agrees(seen: dict[str, Any]) -> None:
    scene = seen["scene"]
    assert scene["hasChanged"]
    assert scene["frames"] >= 2
    values = scene["values"]
    # to the right and down: the head turns left and looks up
    assert values["pan_deg"] > 0
    assert values["tilt_deg"] < 29.8
    assert values["pixel_depth"] is not None
    # both read the same bytes
    assert json.loads(scene["python"]) == pytest.approx(values, abs=1e-9)


def test_the_scene_of_the_page_stays_as_it_was(seen: dict[str, Any]) -> None:
    assert seen["scene"]["data"].strip() == "[0.] [0.52]"


def test_widgets_live_on_a_page_that_was_built_without_any(seen: dict[str, Any]) -> None:
    assert seen["plain"]["built"] == 0
    assert seen["plain"]["returned"] == 1
