"""On a phone a picture opens at a readable size, and code whose lines wrap is copied whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest


@pytest.fixture(scope="module")
def used(chromium: Callable[..., Any], file_site: str, once: Callable[..., Any]) -> dict[str, Any]:
    """What happened when a reader enlarged pictures."""
    found: dict[str, Any] = once("zoom", lambda: chromium("zoom.mjs", file_site))
    return found


def test_a_tap_shows_all_of_a_picture_at_the_size_of_a_desktop(used: dict[str, Any]) -> None:
    phone = used["phone"]
    assert phone["small"] <= 390
    assert phone["large"] == {"width": 960, "scrolls": True, "fromLeft": 0, "sameAlt": True}
    assert phone["barriers"] == []


def test_another_tap_closes_it_and_the_page_is_still_there(used: dict[str, Any]) -> None:
    assert used["phone"]["afterTap"] == 0
    assert used["phone"]["stayed"]
    assert used["phone"]["complaints"] == []


def test_the_keyboard_opens_it_and_escape_leads_back(used: dict[str, Any]) -> None:
    phone = used["phone"]
    assert phone["focusInside"] == "zoom-close"
    assert phone["afterEscape"] == 0
    assert phone["focusAfter"] == "zoom-button"


def test_a_picture_that_a_cell_draws_later_can_be_enlarged_if_it_is_large(
    used: dict[str, Any],
) -> None:
    assert used["late"] == {"large": 1, "small": 0}


def test_a_desktop_shows_pictures_large_and_no_button(used: dict[str, Any]) -> None:
    assert used["desktop"]["seen"] == 0


def test_code_whose_lines_wrap_is_copied_as_it_was_written(used: dict[str, Any]) -> None:
    assert used["phone"]["copied"]["wrapped"] > 10
    assert used["phone"]["copied"]["differing"] == []
