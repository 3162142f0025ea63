"""Every code cell of the book runs on its page, as a file and offline, and prints what it should.

What it should print is what the same cells print in this Python, with the ray caster, as there.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.helpers import page_text
from tests.helpers.chapters import get_toc_pages

ROOT = Path(__file__).resolve().parents[2]
PAGES = [
    page.as_posix()
    for page in get_toc_pages()
    if "{code-cell}" in (ROOT / page).with_suffix(".md").read_text(encoding="utf-8")
]

#: (page, number of the cell) that prints something else on the page, and why it may.
OTHER_TEXT = {
    ("book/conventions", 5): "Open3D",
    ("book/conventions", 6): "Open3D",
    ("book/conventions", 7): "Open3D",
    ("book/conventions", 10): "Open3D",
    ("book/step6_view", 4): "Open3D",
    ("book/step6_view", 16): "Open3D",
    # it stands between 0.0000 and 0.0001 mm, where the last bits of single precision decide
    ("book/step5_cloud", 10): "the fourth decimal of a median",
}


@pytest.fixture(scope="module")
def visits(use_python: Callable[..., Any]) -> dict[str, Any]:
    """What a reader sees after "Run all", on every page with cells."""
    return use_python("cells", *PAGES)


@pytest.fixture(scope="module")
def printed(once: Callable[..., Any]) -> dict[str, list[str]]:
    return once("page-text", lambda: page_text.run_pages(PAGES))


@pytest.mark.parametrize("page", PAGES)
def test_all_cells_of_a_page_run(visits: dict[str, Any], page: str) -> None:
    visit = visits[page]
    assert visit["complaints"] == []
    wrong = [
        (number, cell["result"], cell["error"])
        for number, cell in enumerate(visit["cells"], 1)
        if cell["result"] != "ran" and "run the notebook" not in cell["status"]
    ]
    assert wrong == []
    assert visit["said"] == "All cells ran."
    assert {ran for _, ran in visit["exercises"]} <= {"ran"}


@pytest.mark.parametrize("page", PAGES)
def test_the_cells_of_a_page_print_what_they_print_in_a_notebook(
    visits: dict[str, Any], printed: dict[str, list[str]], page: str
) -> None:
    cells = visits[page]["cells"]
    assert len(cells) == len(printed[page])
    other = {
        number: (cell["text"], text)
        for number, (cell, text) in enumerate(zip(cells, printed[page], strict=True), 1)
        if cell["text"] != text and cell["result"] == "ran"
    }
    accepted = {number for where, number in OTHER_TEXT if where == page}
    assert {number: two for number, two in other.items() if number not in accepted} == {}
    assert accepted <= set(other), "a cell that is listed prints the same: take it off the list"


@pytest.mark.parametrize("page", PAGES)
def test_the_cells_of_a_page_show_as_many_pictures_as_in_the_book(
    visits: dict[str, Any], page: str
) -> None:
    for number, cell in enumerate(visits[page]["cells"], 1):
        if cell["result"] == "ran" and not cell["widgets"]:
            assert cell["pictures"] == cell["builtPictures"], number


def test_cells_that_a_page_cannot_run_are_few_and_say_why(visits: dict[str, Any]) -> None:
    skipped = [
        cell["status"] for visit in visits.values() for cell in visit["cells"] if not cell["result"]
    ]
    assert len(skipped) <= 5
    assert all(status.endswith("run the notebook.") for status in skipped)


#: A cell that needs the simulator, rendering and pictures from the cells above it.
FIREFOX_PAGE, FIREFOX_CELL = "book/step1_camera", 8


def test_cells_run_in_firefox_too(
    firefox: Callable[..., Any],
    page_python: dict[str, Any],  # noqa: ARG001 - needed to run
    file_site: str,
    printed: dict[str, list[str]],
) -> None:
    seen = firefox("cells_firefox.mjs", file_site, FIREFOX_PAGE, FIREFOX_CELL)
    assert seen["complaints"] == []
    assert [cell["error"] for cell in seen["cells"]] == [""] * FIREFOX_CELL
    assert {cell["result"] for cell in seen["cells"]} == {"ran"}
    assert sum(cell["pictures"] for cell in seen["cells"]) >= 3
    assert seen["cells"][-1]["text"] == [printed[FIREFOX_PAGE][FIREFOX_CELL - 1]]
