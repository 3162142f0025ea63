"""The pages work in Firefox too, as files and from a server."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.helpers import browser

# one of each kind: cover, formulas, pictures, exercises, search; and all pages with widgets
PAGES = (
    "book/index",
    "book/step2_intrinsics",
    "book/step4_color",
    "exercises/step4_color",
    "search",
)
WIDGET = re.compile(r"widget-view\+json")


def pages_to_open(folder: Path) -> list[str]:
    """Choose the pages: the fixed ones, and every page that shows a widget."""
    with_widgets = [
        page
        for page in browser.names_of_pages()
        if WIDGET.search((folder / f"{page}.html").read_text(encoding="utf-8"))
    ]
    return list(dict.fromkeys([*PAGES, *with_widgets]))


@pytest.fixture(scope="module", params=browser.PROTOCOLS)
def visits(
    request: pytest.FixtureRequest,
    firefox: Callable[..., Any],
    student_pages: Path,
    once: Callable[..., Any],
) -> dict[str, Any]:
    """What a visitor with Firefox finds: {page: findings}."""
    site = request.getfixturevalue(f"{request.param}_site")
    pages = pages_to_open(student_pages)
    seen = once(f"firefox-{request.param}", lambda: firefox("firefox.mjs", site, *pages))
    assert set(seen) == set(pages)
    # or a changed class name would make the tests below pass by finding nothing
    for thing in ("pictures", "views", "formulas"):
        assert any(visit[thing] for visit in seen.values()), thing
    return seen


def test_pages_open_in_firefox_without_errors_and_ask_no_other_host(visits: dict[str, Any]) -> None:
    assert {
        page: visit["complaints"] for page, visit in visits.items() if visit["complaints"]
    } == {}


def test_firefox_draws_pictures_widgets_formulas_and_icons(visits: dict[str, Any]) -> None:
    for page, visit in visits.items():
        assert visit["notDrawn"] == [], page
        assert visit["drawn"] == visit["views"], page
        assert visit["typeset"] == visit["formulas"], page
        assert visit["iconFonts"], page
        assert set(visit["iconFonts"]) == {"loaded"}, page


def test_nothing_is_wider_than_a_narrow_phone_in_firefox(visits: dict[str, Any]) -> None:
    assert {page: visit["tooWide"] for page, visit in visits.items() if visit["tooWide"] > 0} == {}
