"""Every page in windows of many sizes: text to be read, the rest as wide as there is room."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tests.helpers import browser

DESKTOPS = ("small", "laptop", "large")
SCREENS = ("phone", "landscape", *DESKTOPS)
MEASURE = (45, 80)  # characters per line; a narrow phone has fewer
WIDEST = 960  # px
LEAST = {"phone": 358, "landscape": 812, "small": 760, "laptop": 840, "large": WIDEST}


@pytest.fixture(scope="module")
def layouts(
    chromium: Callable[..., Any], file_site: str, once: Callable[..., Any]
) -> dict[str, Any]:
    """What was found: {page: {view: findings}}."""
    return once("layout", lambda: chromium("layout.mjs", file_site, *browser.names_of_pages()))


@pytest.fixture(params=browser.names_of_pages())
def layout(request: pytest.FixtureRequest, layouts: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = layouts[request.param]
    return found


@pytest.mark.parametrize("view", SCREENS)
def test_nothing_is_wider_than_the_window(layout: dict[str, Any], view: str) -> None:
    assert layout[view]["tooWide"] <= 0


@pytest.mark.parametrize("view", [*SCREENS, "paper"])
def test_code_and_tables_are_never_cut_off(layout: dict[str, Any], view: str) -> None:
    assert layout[view]["cut"] == []
    assert layout[view]["tables"] == []


@pytest.mark.parametrize("view", DESKTOPS)
def test_each_line_of_code_has_one_line_on_a_desktop(layout: dict[str, Any], view: str) -> None:
    assert layout[view]["wrapped"] == [], "shorten the line: at 1280 px a page has room for 89"


@pytest.mark.parametrize("view", [*SCREENS, "paper"])
def test_a_line_of_code_that_wraps_says_so(layout: dict[str, Any], view: str) -> None:
    assert layout[view]["unmarked"] == []


@pytest.mark.parametrize("view", SCREENS)
def test_text_keeps_to_a_readable_measure(layout: dict[str, Any], view: str) -> None:
    measure = layout[view]["measure"]
    if measure is None:
        return  # a page of few and short paragraphs
    assert measure <= MEASURE[1]
    assert view == "phone" or measure >= MEASURE[0]


@pytest.mark.parametrize("view", SCREENS)
def test_figures_and_cells_take_the_room_there_is(layout: dict[str, Any], view: str) -> None:
    room = min(layout[view]["column"], WIDEST)
    assert not layout[view]["cells"] or room >= LEAST[view]
    assert all(width >= room - 1 for width in layout[view]["cells"])
    assert all(width >= 0.95 * room for width in layout[view]["broad"])


@pytest.mark.parametrize("view", ["phone", "landscape"])
def test_text_stands_in_the_middle_of_a_phone(layout: dict[str, Any], view: str) -> None:
    assert all(offset <= 2 for offset in layout[view]["lopsided"])


def test_a_page_has_no_serious_barrier_on_a_phone(layout: dict[str, Any]) -> None:
    assert layout["phone"]["barriers"] == []


def test_some_page_shows_each_thing_that_is_looked_for(layouts: dict[str, Any]) -> None:
    # or a changed class name would make the tests above pass by finding nothing
    phones = [layout["phone"] for layout in layouts.values()]
    for thing in ("blocks", "wrapped", "measure", "cells", "broad", "lopsided"):
        assert any(phone[thing] for phone in phones), thing
