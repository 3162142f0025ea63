"""The following explorer in the page: recorded, live, and with a controller that fails."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest


@pytest.fixture(scope="module")
def seen(use_python: Callable[..., Any]) -> dict[str, Any]:
    return use_python("following")


def test_the_page_reports_no_problem(seen: dict[str, Any]) -> None:
    assert seen["complaints"] == []
    for cell in (seen["cell"], seen["failingCell"]):
        assert (cell["result"], cell["error"]) == ("ran", "")
        assert (cell["isYoursShown"], cell["isBuiltShown"]) == (True, False)


def test_without_python_a_recorded_run_is_played_paused_and_scrubbed(seen: dict[str, Any]) -> None:
    recorded = seen["recorded"]
    first, stepped, paused = recorded["first"], recorded["stepped"], recorded["paused"]
    assert first["mode"] == "recorded"
    assert stepped["values"]["time"] == pytest.approx(0.05)
    assert 0.4 < paused["values"]["time"] < first["values"]["time"]
    assert recorded["pictureHasChanged"]
    scrubbed = recorded["scrubbed"]
    assert scrubbed["values"] == first["values"]
    assert scrubbed["said"] == f"{first['values']['time']:.2f} s"


def test_what_a_recording_cannot_do_is_said(seen: dict[str, Any]) -> None:
    first = seen["recorded"]["first"]
    assert first["buttons"] == [
        ["Play", False],
        ["Step", False],
        ["Start again", False],
        ["Hide the ball", True],
    ]
    assert first["note"].startswith("A recording: gain 1, delay 1, noise 2, 0.35 m/s.")
    assert "Press Run on this cell" in first["note"]


def test_the_live_run_begins_at_its_beginning(seen: dict[str, Any]) -> None:
    first = seen["live"]["first"]
    assert (first["steps"], first["values"]["time"]) == (0, None)
    assert first["note"].startswith("Live")
    assert first["buttons"][0] == ["Run", False]
    # what was chosen in the recording is carried over, but nothing of it is there any more
    assert first["parameters"]["moment"] == -1


def test_steps_happen_one_by_one_and_then_by_themselves(seen: dict[str, Any]) -> None:
    live = seen["live"]
    assert live["stepped"]["steps"] == 3
    assert live["stepped"]["values"]["time"] == pytest.approx(0.1)
    assert live["hidden"]["steps"] > 30
    assert float(live["answerMs"]) > 0


def test_the_board_hides_the_ball_while_the_head_follows(seen: dict[str, Any]) -> None:
    hidden = seen["live"]["hidden"]
    assert hidden["values"]["is_hidden"]
    assert seen["live"]["delayed"]["values"]["is_hidden"] is False


def test_a_slider_acts_while_the_head_follows(seen: dict[str, Any]) -> None:
    delayed = seen["live"]["delayed"]
    assert delayed["parameters"]["delay"] == 8
    assert delayed["budget"].startswith("picture delay 400 ms")
    assert delayed["steps"] > seen["live"]["hidden"]["steps"]


def test_python_and_page_tell_the_same(seen: dict[str, Any]) -> None:
    live = seen["live"]
    count, values = json.loads(live["python"])
    assert count == live["paused"]["steps"]
    told = live["paused"]["values"]
    assert values.keys() == told.keys()
    for name, value in values.items():
        assert told[name] == (value if value is None else pytest.approx(value, rel=1e-9))


def test_start_again_empties_the_run(seen: dict[str, Any]) -> None:
    restarted = seen["live"]["restarted"]
    assert (restarted["steps"], restarted["values"]["time"]) == (0, None)
    assert restarted["parameters"]["delay"] == 8


def test_an_exception_is_shown_in_words_and_loses_nothing(seen: dict[str, Any]) -> None:
    stopped, again = seen["failing"]["stopped"], seen["failing"]["again"]
    where, what = stopped["problem"].split("\n")
    assert where == "control stopped the run at 0.25 s in line 3: return 1 / 0"
    assert what == "ZeroDivisionError: division by zero"
    assert stopped["steps"] == again["steps"] == 5
    assert stopped["buttons"][0] == ["Run", False]
    assert again["problem"] == stopped["problem"]
