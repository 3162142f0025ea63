"""What a first visit costs, gzipped, as a server would send it; and what is left out."""

from __future__ import annotations

import base64
import gzip
import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from fontTools.ttLib import TTFont

from live_cells import LAST_SCRIPTS, SCRIPTS
from tests.helpers import browser

#: Bytes before the reader makes a gesture; a few seconds on a slow phone line.
BUDGET = 0.9e6
FIRST_BUDGET = 0.4e6  # of the welcome page
FIRST = "book/index"
CELLS_BUDGET = 15e3  # Python itself comes with the first click
FONT = re.compile(r'font-family:"([^"]+)".*?base64,([^)]+)\)')


@pytest.fixture(scope="module")
def visits(
    chromium: Callable[..., Any], http_site: str, once: Callable[..., Any]
) -> dict[str, Any]:
    """The same visits that test_pages.py looks at."""
    return once("pages-http", lambda: chromium("pages.mjs", http_site, *browser.names_of_pages()))


@pytest.mark.parametrize("page", browser.names_of_pages())
def test_a_first_visit_keeps_to_its_budget(visits: dict[str, Any], page: str) -> None:
    visit = visits[page]
    heaviest = sorted(visit["weights"].items(), key=lambda item: -item[1])[:6]
    budget = FIRST_BUDGET if page == FIRST else BUDGET
    assert 0 < sum(visit["weights"].values()) <= budget, heaviest


def test_nothing_is_loaded_for_an_explorer_before_a_gesture(visits: dict[str, Any]) -> None:
    pages = [name for name, visit in visits.items() if visit["views"]]
    assert len(pages) > 5  # or the page no longer says that it shows explorers
    for name in pages:
        loaded = [file for file in visits[name]["weights"] if "/widgets/" in file]
        assert loaded == [], name
        assert visits[name]["drawn"] == visits[name]["views"]  # and after one they are drawn


def test_no_page_loads_mathjax(visits: dict[str, Any]) -> None:
    for name, visit in visits.items():
        assert not [file for file in visit["weights"] if "mathjax" in file.lower()], name


def test_cells_that_nobody_runs_cost_a_page_little(student_pages: Path) -> None:
    static = student_pages / "_static"
    files = [static / "python" / script for script in (*SCRIPTS, *LAST_SCRIPTS)]
    files.append(static / "cells.css")
    page = (student_pages / "book" / "step1_camera.html").read_text(encoding="utf-8")
    data = re.search(r'<script[^>]*id="python-data">.*?</script>', page, re.DOTALL)
    assert data is not None
    parts = [*(path.read_bytes() for path in files), data[0].encode()]
    assert sum(len(gzip.compress(part, 9)) for part in parts) <= CELLS_BUDGET


def test_every_icon_that_a_page_draws_is_in_its_font(
    visits: dict[str, Any], student_pages: Path
) -> None:
    sheet = (student_pages / "_static" / "icon_fonts.css").read_text(encoding="utf-8")
    fonts = {
        family: TTFont(io.BytesIO(base64.b64decode(data))).getBestCmap()
        for family, data in FONT.findall(sheet)
    }
    drawn = {icon for visit in visits.values() for icon in visit["icons"]}
    assert len(drawn) > 10  # or the page no longer says how it draws them
    for icon in drawn:
        family, code = icon.replace('"', "").rsplit(" ", 1)
        assert int(code, 16) in fonts.get(family, {}), icon


def test_the_icons_name_their_license(student_pages: Path) -> None:
    sheet = (student_pages / "_static" / "icon_fonts.css").read_text(encoding="utf-8")
    assert "Font Awesome" in sheet
    assert "CC BY 4.0" in sheet
    assert "SIL OFL 1.1" in sheet


def test_the_site_carries_no_files_that_no_page_uses(student_pages: Path) -> None:
    static = student_pages / "_static"
    assert not list(static.rglob("*.map"))
    assert not (static / "locales").exists()
    assert not (static / "vendor" / "fontawesome").exists()
    for page in student_pages.rglob("*.html"):
        assert "fontawesome.js" not in page.read_text(encoding="utf-8"), page
