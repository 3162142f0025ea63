"""Every page, opened as a file and from a server: complete, quiet, narrow, by keyboard."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tests.helpers import browser


# As files, test_accessibility.py opens every page too, and listens for errors.
@pytest.fixture(scope="module", params=[pytest.param("file", marks=pytest.mark.slow), "http"])
def visits(
    request: pytest.FixtureRequest, chromium: Callable[..., Any], once: Callable[..., Any]
) -> dict[str, Any]:
    """What a first visitor with a phone finds on every page: {page: findings}."""
    site = request.getfixturevalue(f"{request.param}_site")
    return once(
        f"pages-{request.param}",
        lambda: chromium("pages.mjs", site, *browser.names_of_pages()),
    )


@pytest.fixture(params=browser.names_of_pages())
def visit(request: pytest.FixtureRequest, visits: dict[str, Any]) -> dict[str, Any]:
    return visits[request.param]


def test_a_page_opens_without_errors_and_asks_no_other_host(visit: dict[str, Any]) -> None:
    assert visit["complaints"] == []


def test_nothing_is_wider_than_a_narrow_phone(visit: dict[str, Any]) -> None:
    assert visit["tooWide"] <= 0, visit["wideElements"]


def test_every_picture_is_drawn_and_described(visit: dict[str, Any]) -> None:
    assert visit["notDrawn"] == []
    assert visit["withoutAlt"] == []


def test_every_widget_is_drawn(visit: dict[str, Any]) -> None:
    assert visit["drawn"] == visit["views"]


def test_every_formula_is_typeset(visit: dict[str, Any]) -> None:
    assert visit["typeset"] == visit["formulas"]
    assert visit["formulaErrors"] == 0


def test_the_keyboard_reaches_the_content_and_always_shows_where_it_is(
    visit: dict[str, Any],
) -> None:
    keyboard = visit["keyboard"]
    assert keyboard["skips"], "no link to skip the sidebar"
    assert keyboard["reachesArticle"], f"not within {keyboard['stops']} stops"
    assert keyboard["hidden"] == []
    assert keyboard["ringless"] == []


def test_some_page_shows_each_thing_that_is_looked_for(visits: dict[str, Any]) -> None:
    # or a changed class name would make the tests above pass by finding nothing
    for thing in ("images", "formulas", "icons"):
        assert any(visit[thing] for visit in visits.values()), thing
