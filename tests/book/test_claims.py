"""Every sentence that claims something is tied to a cell, a test or a reference."""

from __future__ import annotations

import pytest

from tests.helpers.claims import (
    Page,
    find_fault,
    is_tied_by_itself,
    read_page,
    read_register,
    split_sentences,
)
from tools import ROOT

# How pages are made, what is quoted, and the register of errors that has a test per row.
OTHERS = {"architecture", "references", "errata"}
PAGES = sorted(path.stem for path in (ROOT / "book").glob("*.md") if path.stem not in OTHERS)


@pytest.fixture(scope="module")
def pages() -> dict[str, Page]:
    html = ROOT / "_build" / "html" / "book"
    if not html.is_dir():
        pytest.skip("the book is not built; run `make book` first")
    return {name: read_page(ROOT / "book" / f"{name}.md", html / f"{name}.html") for name in PAGES}


@pytest.mark.parametrize("name", PAGES)
def test_every_claim_is_tied_to_evidence(pages: dict[str, Page], name: str) -> None:
    page = pages[name]
    entries = read_register().get(name, [])
    loose = [
        claim
        for claim in page.claims
        if not is_tied_by_itself(claim, page)
        and not any(entry["says"] in claim for entry in entries)
    ]
    assert not loose, f"tie each to a cell, a test or a reference in tests/book/claims.yml: {loose}"


@pytest.mark.parametrize("name", sorted(read_register()))
def test_every_entry_of_the_register_holds(pages: dict[str, Page], name: str) -> None:
    assert name in pages, f"expected a page of the book, got {name!r}"
    faults = [fault for entry in read_register()[name] if (fault := find_fault(entry, pages[name]))]
    assert not faults


def test_a_claim_without_evidence_is_found() -> None:
    text = (
        "# Heading 3 mm\n\nIt is 3 mm off. OpenCV is *kind*.\n\n```{code-cell}\nx = 5  # mm\n```\n"
    )
    page = Page("page", tuple(split_sentences(text)), "x = 5", "3 mm of 4 apples")
    assert page.claims == ("It is 3 mm off.", "OpenCV is *kind*.")
    assert [is_tied_by_itself(claim, page) for claim in page.claims] == [True, False]


@pytest.mark.parametrize(
    ("claim", "is_tied"),
    [("It is 3 mm off.", True), ("It is 4 mm off.", False), ("It is 0.25 m.", True)],
)
def test_a_whole_number_is_printed_with_its_unit_or_is_another(claim: str, is_tied: bool) -> None:
    page = Page("page", (claim,), "", "3 mm of 4 apples [0.25 7]")
    assert is_tied_by_itself(claim, page) == is_tied


@pytest.mark.parametrize(
    ("entry", "fault"),
    [
        ({"says": "kind", "follows": "from its manners"}, ""),
        ({"says": "kind"}, "expected says and one of"),
        ({"says": "cruel", "follows": "from nothing"}, "expected one sentence"),
        ({"says": "kind", "cell": "y = 5"}, "expected a cell"),
        ({"says": "kind", "cell": "x = 5"}, ""),
        ({"says": "kind", "measured": "| 1.5 |"}, ""),
        ({"says": "kind", "measured": "| 2.5 |"}, "expected a table"),
        ({"says": "kind", "reference": "ref-nobody"}, "no reference"),
        ({"says": "kind", "test": "tests/book/test_claims.py::test_of_nothing"}, "no test"),
    ],
)
def test_entries_are_compared_with_what_they_name(entry: dict[str, str], fault: str) -> None:
    page = Page("page", ("OpenCV is *kind*.",), "x = 5", "", "| 1.5 |")
    found = find_fault(entry, page)
    assert found.startswith(fault) if fault else not found
