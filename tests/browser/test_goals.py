"""Goals of depth range, stereo and cloud on their pages: how far, reached, and left again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

EXPLORERS = ("depth-range", "stereo", "cloud")


@pytest.fixture(scope="module")
def reached(file_site: str, chromium: Callable[..., Any]) -> dict[str, Any]:
    found: dict[str, Any] = chromium("goals.mjs", file_site)
    return found


@pytest.mark.parametrize("name", EXPLORERS)
def test_a_goal_is_open_then_reached_then_reached_before(
    reached: dict[str, Any], name: str
) -> None:
    seen = reached[name]["seen"]
    assert reached[name]["complaints"] == []
    assert [one["state"] for one in seen[:-2]] == ["open"] * (len(seen) - 2)
    assert (seen[-2]["state"], seen[-2]["mark"], seen[-2]["bar"]) == ("reached", "Reached", 100)
    assert (seen[-1]["state"], seen[-1]["mark"]) == ("before", "Reached before")
    assert seen[-1]["bar"] < 100


def test_every_surface_alone_is_not_the_goal_of_the_range(reached: dict[str, Any]) -> None:
    start, cut, whole, tight, _ = reached["depth-range"]["seen"]
    assert start["values"]["left_out"] == whole["values"]["left_out"] == 0
    assert start["bar"] == 0
    assert start["bar"] < whole["bar"] < tight["bar"]
    assert cut["values"]["left_out"] > 0
    assert cut["bar"] < 100
    assert tight["told"].startswith("left out 0 (at most 0)width 10")


def test_a_line_tells_the_number_that_is_asked_for(reached: dict[str, Any]) -> None:
    stereo, cloud = reached["stereo"]["seen"], reached["cloud"]["seen"]
    assert stereo[-1]["told"].startswith("seen by both at 1.7")
    assert f"off by {stereo[-1]['values']['error_mm']:.1f} mm" in stereo[-1]["told"]
    assert cloud[-2]["told"] == "angle 90.0° (89.5 to 90.5)"
