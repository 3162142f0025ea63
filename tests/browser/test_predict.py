"""Predict, commit, compare: what a box covers, when it opens, what is said and kept."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from content.predictions import load_all
from labutils.checks.progress import load_progress
from labutils.checks.progress_rules import FILE_NAME

PAGES = load_all()
STALE, PAN = PAGES["step1_camera"]["stale"], PAGES["step1_camera"]["pan"]
MIDDLE = PAGES["step2_intrinsics"]["middle"]


@pytest.fixture(scope="module")
def seen(chromium: Callable[..., Any], file_site: str, once: Callable[..., Any]) -> dict[str, Any]:
    return once("predict", lambda: chromium("predict.mjs", file_site))


def is_covered(state: dict[str, Any]) -> bool:
    """Nothing of the answer is seen, and a note says so."""
    return not state["seen"] and state["notes"] > 0 and state["parts"] > 0


def is_open(state: dict[str, Any]) -> bool:
    """All of the answer is seen, and no note is left."""
    return state["seen"] == state["parts"] and not state["notes"]


def test_the_pages_report_no_problem(seen: dict[str, Any]) -> None:
    assert seen["complaints"] == []


def test_the_answer_is_covered_and_the_code_is_not(seen: dict[str, Any]) -> None:
    assert is_covered(seen["before"])
    assert seen["before"]["parts"] == 3
    assert seen["before"]["codes"] == 2
    assert seen["before"]["buttons"] == ["Commit", "Show anyway"]


def test_without_an_answer_nothing_opens(seen: dict[str, Any]) -> None:
    assert seen["empty"]["result"] == "Choose an answer first."
    assert is_covered(seen["empty"])
    assert seen["noNumber"]["result"] == "Type a number first."
    assert is_covered(seen["noNumber"])


def test_a_right_answer_opens_the_page_by_keyboard(seen: dict[str, Any]) -> None:
    assert seen["right"]["result"] == f"You said The old view, and so it is. {STALE.said['2']}"
    assert is_open(seen["right"])
    assert is_covered(seen["other"])


def test_a_wrong_answer_is_told_what_is_true(seen: dict[str, Any]) -> None:
    said = f"You said To the left. It is To the right. {PAN.said['2']}"
    assert seen["wrong"]["result"] == said
    assert is_open(seen["wrong"])


def test_the_answer_is_read_once(seen: dict[str, Any]) -> None:
    # by the focus, and by nothing that speaks of itself
    for state in (seen["right"], seen["wrong"], seen["shown"], seen["high"]):
        assert state["focus"] == "predict-result"
        assert state["live"] == 0


def test_one_may_see_the_answer_without_a_prediction(seen: dict[str, Any]) -> None:
    assert seen["shown"]["result"] == "Shown without a prediction."
    assert is_open(seen["shown"])


def test_what_was_said_is_kept_in_the_progress_file(seen: dict[str, Any], tmp_path: Path) -> None:
    (tmp_path / FILE_NAME).write_text(json.dumps(seen["kept"]))
    progress = load_progress(tmp_path)
    assert progress.notice == ""
    assert {name: vars(one) for name, one in progress.predictions.items()} == {
        "stale": {"said": "2", "right": True},
        "pan": {"said": "2", "right": False},
        "one-step": {"said": None, "right": False},
    }
    assert [is_open(state) for state in seen["reloaded"]] == [True, True]
    assert seen["reloaded"][0]["result"] == seen["right"]["result"]


def test_a_prediction_can_be_covered_again(seen: dict[str, Any]) -> None:
    assert is_covered(seen["again"])
    assert set(seen["keptAgain"]["predictions"]) == {"pan", "one-step"}


def test_an_address_or_a_search_opens_without_counting(seen: dict[str, Any]) -> None:
    assert seen["address"]["seen"] == seen["address"]["parts"]
    assert seen["addressKept"] is None
    found, kept = seen["found"]
    assert is_open(found)
    assert kept == "nothing"


def test_a_number_may_be_near_enough_and_has_two_sides(seen: dict[str, Any]) -> None:
    assert seen["high"]["result"] == f"You said 3.0. It is 2.5. {MIDDLE.said['high']}"
    assert seen["exact"]["result"] == f"You said 2.5, and so it is. {MIDDLE.said['right']}"
    assert is_open(seen["exact"])


def test_a_phone_shows_it_without_barriers(seen: dict[str, Any]) -> None:
    assert seen["covered"] == []
    assert seen["answered"] == []
    assert seen["sideways"] <= 0
    assert seen["targets"] >= 44


def test_an_explorer_that_was_covered_gets_its_size(seen: dict[str, Any]) -> None:
    assert seen["explorer"] > 100


def test_on_paper_and_without_scripts_all_is_open(seen: dict[str, Any]) -> None:
    assert is_open(seen["paper"])
    assert seen["plain"] == {
        "choices": ["The new view.", "The old view.", "The new view without shadows."],
        "isAnswerSeen": True,
        "isSaidSeen": False,
    }


@pytest.mark.parametrize("page", PAGES)
def test_every_box_of_a_page_covers_all_of_its_answer_until_it_is_opened(
    seen: dict[str, Any], page: str
) -> None:
    counts = seen["book"][page]
    assert set(counts) == set(PAGES[page])
    for name, (parts, before, notes, after) in counts.items():
        assert parts > 0, name
        assert notes > 0, name
        assert (before, after) == (0, parts), name


@pytest.fixture(scope="module")
def ran(use_python: Callable[..., Any]) -> dict[str, Any]:
    return use_python("predict_run")


def test_a_cell_that_runs_for_another_stays_covered(ran: dict[str, Any]) -> None:
    assert ran["below"] == {"isCovered": True, "seen": False, "result": "ran"}


def test_whoever_runs_the_covered_cell_sees_what_it_gives(ran: dict[str, Any]) -> None:
    assert ran["itself"] == {"isCovered": False, "seen": True}
    assert ran["said"] == "Shown without a prediction."
    assert ran["complaints"] == []
