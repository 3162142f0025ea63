"""The video of a page plays from a file, by keyboard, and stays a picture on paper."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tools.draw import following_video


@pytest.fixture(scope="module")
def seen(chromium: Callable[..., Any], file_site: str, once: Callable[..., Any]) -> dict[str, Any]:
    """What happened on the page with the video."""
    found: dict[str, Any] = once("videos", lambda: chromium("videos.mjs", file_site))
    return found


def test_nothing_is_loaded_before_the_reader_asks(seen: dict[str, Any]) -> None:
    assert seen["played"]["before"]["loaded"] == 0


def test_it_plays_and_stops_by_keyboard_alone(seen: dict[str, Any]) -> None:
    after = seen["played"]["after"]
    assert after["problem"] is None
    assert after["focused"]
    assert after["seconds"] == pytest.approx(following_video.SECONDS, abs=0.2)
    assert after["width"] == 2 * following_video.WIDTH
    assert seen["played"]["complaints"] == []


def test_it_says_in_words_what_it_shows_and_fits_a_phone(seen: dict[str, Any]) -> None:
    assert len(seen["played"]["before"]["name"]) > 40
    assert seen["played"]["sideways"] <= 0


def test_paper_shows_the_poster(seen: dict[str, Any]) -> None:
    assert seen["paper"]["player"] == 0
    assert seen["paper"]["poster"] > 0


def test_it_needs_no_scripts(seen: dict[str, Any]) -> None:
    assert seen["withoutScripts"]
