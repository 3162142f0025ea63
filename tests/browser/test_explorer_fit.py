"""Every explorer fits its window: a control is never used with the picture out of view."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tools.explorer_views import find_pages

PAGES = find_pages()
VIEWS = ("phone", "landscape", "laptop", "large")
HIGHEST = 600  # px on a laptop, where 650 less the header are seen
LEAST_SEEN = 0.6  # of the height of the picture; objects stand in its middle
LEAST_WIDTH = {"phone": 300, "landscape": 240, "laptop": 300, "large": 360}  # px, of a picture


@pytest.fixture(scope="module")
def fits(chromium: Callable[..., Any], file_site: str, once: Callable[..., Any]) -> dict[str, Any]:
    """What was found: {page: {view: [explorer]}}."""
    return once("explorer-fit", lambda: chromium("explorer_fit.mjs", file_site, *PAGES))


@pytest.fixture(params=[(page, view) for page in PAGES for view in VIEWS], ids="-".join)
def fit(request: pytest.FixtureRequest, fits: dict[str, Any]) -> tuple[str, list[dict[str, Any]]]:
    page, view = request.param
    explorers = fits[page][view]
    assert explorers, "or the tests below would pass by finding nothing"
    return view, explorers


def test_picture_and_control_are_in_view_together(fit: tuple[str, list[dict[str, Any]]]) -> None:
    for explorer in fit[1]:
        assert explorer["controls"]
        for control in explorer["controls"]:
            assert control["usable"], (explorer["name"], control)
            assert control["seen"] >= LEAST_SEEN, (explorer["name"], control)


def test_the_picture_is_large_enough_to_be_read(fit: tuple[str, list[dict[str, Any]]]) -> None:
    view, explorers = fit
    for explorer in explorers:
        assert explorer["pictureWidth"] >= LEAST_WIDTH[view], explorer["name"]


def test_nothing_sticks_out_sideways(fit: tuple[str, list[dict[str, Any]]]) -> None:
    for explorer in fit[1]:
        assert explorer["tooWide"] <= 0, explorer["name"]
        assert explorer["outside"] == [], explorer["name"]


@pytest.mark.parametrize("page", PAGES)
def test_no_explorer_is_higher_than_a_laptop_shows(page: str, fits: dict[str, Any]) -> None:
    for explorer in fits[page]["laptop"]:
        assert explorer["height"] <= HIGHEST, (explorer["name"], explorer["height"])
