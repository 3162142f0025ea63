"""The chapters as rows: what is read from them, what is refused, and that pages agree with them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from content import chapters
from content.chapters import (
    EXTENSION,
    READING,
    REGISTRY,
    Chapter,
    ChapterError,
    find_chapter,
    get_chapter,
    list_required,
    list_taught,
    load_chapters,
)
from content.labels import LabelError, make_link, read_labels
from content.quiz_items import load_all
from content.toc import Entry, list_entries, list_pages
from tests.helpers.chapters import ROOT

ROW: dict[str, Any] = {
    "id": "first",
    "kind": "required",
    "page": "book/first_page",
    "exercises": "exercises/first_page",
    "name": "Step 1",
    "title": "What?",
    "prefix": "1",
    "strip": "one",
    "criterion": {"name": "Rendering", "asks": "A picture"},
}
READ = {"id": "intro", "kind": "reading", "page": "book/intro", "name": "Intro", "title": "why?"}


def write(folder: Path, rows: Any) -> Path:
    """Write a registry; every test has a folder of its own, so nothing is remembered."""
    (folder / "content").mkdir()
    (folder / REGISTRY).write_text(yaml.safe_dump(rows), encoding="utf-8")
    return folder


def change(**fields: Any) -> dict[str, Any]:
    """The good row with fields changed; None takes one out."""
    return {key: value for key, value in (ROW | fields).items() if value is not None}


# ---- What the registry says of the book


def test_registry_and_contents_name_the_same_pages_in_the_same_order() -> None:
    pages = list_pages()
    rows = load_chapters()
    assert [one.page for one in rows] == [p for p in pages if find_chapter(p) and "book/" in p]
    assert [one.exercises for one in list_taught()] == [p for p in pages if "exercises/" in p]


@pytest.mark.parametrize("chapter", load_chapters(), ids=lambda one: one.id)
def test_every_page_has_the_heading_and_the_label_of_its_row(chapter: Chapter) -> None:
    text = (ROOT / f"{chapter.page}.md").read_text(encoding="utf-8")
    expected = f"\n(page-{chapter.id})=\n# {chapter.heading}\n"
    assert expected in text, f"{chapter.page}: expected {expected!r}, as its row says"


@pytest.mark.parametrize("chapter", list_taught(), ids=lambda one: one.id)
def test_labels_of_a_chapter_begin_with_its_id(chapter: Chapter) -> None:
    labels = [name for name, label in read_labels().items() if label.page == chapter.page]
    assert len(labels) > 1
    strange = [name for name in labels if not name.startswith((f"{chapter.id}-", "page-"))]
    assert not strange, f"{chapter.page}: expected labels such as {chapter.id}-name, got {strange}"


def test_every_chapter_has_questions_and_every_file_of_questions_a_chapter() -> None:
    asked = set(load_all())
    assert {one.stem for one in list_taught()} <= asked <= {one.stem for one in load_chapters()}


# ---- What is read


def test_a_row_is_read_with_what_follows_from_it(tmp_path: Path) -> None:
    root = write(tmp_path, [READ, ROW, change(**EXTRA)])
    reading, first, extra = load_chapters(root)
    assert (reading.kind, reading.exercises, reading.criterion) == (READING, "", None)
    assert (first.stem, first.heading) == ("first_page", "Step 1: What?")
    assert (first.short, first.noun, first.is_extension) == ("1", "step", False)
    assert first.criterion is not None
    assert first.criterion.asks == "A picture"
    assert (extra.short, extra.noun, extra.is_extension) == ("Extra", "chapter", True)
    assert list_taught(root) == (first, extra)
    assert list_required(root) == (first,)
    assert get_chapter("extra", root) == extra
    assert find_chapter("exercises/extra", root) == find_chapter("book/extra", root) == extra
    assert find_chapter("book/other", root) is None


EXTRA = {
    "id": "extra",
    "kind": EXTENSION,
    "page": "book/extra",
    "exercises": "exercises/extra",
    "name": "Extra",
    "prefix": "7",
    "strip": None,
    "criterion": None,
}


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("text", "chapters.yml: expected a list of chapters"),
        (["text"], "row 1: expected fields with names, got 'text'"),
        (
            [ROW, change(id="second", page="book/second")],
            "second: exercises: expected exercises/s",
        ),
        ([ROW, change(**EXTRA) | {"prefix": "1"}], "two chapters have the prefix 1"),
        ([READ, READ], "two chapters have the id intro"),
        ([change(kind="optional")], "kind: expected required or extension or reading, got 'opt"),
        ([change(id="First")], "First: id: expected such as step4, got 'First'"),
        (
            [change(page="solutions/x")],
            "expected such as book/step4_color, got 'solutions/x'",
        ),
        ([change(prefix="a")], 'prefix: expected a number such as "4"'),
        ([change(prefix=1)], "prefix: expected str, got 1; write it in quotes"),
        ([change(prefix=None)], "first: the field prefix is missing, kind is required"),
        ([change(exercises=None)], "first: the field exercises is missing, kind is required"),
        ([change(exercises="exercises/other")], "exercises: expected exercises/first_page, got"),
        ([change(title=None)], "row 1: the field title is missing"),
        ([change(stripe="x")], "row 1: unknown field stripe; known are id, kind"),
        ([change(criterion={"name": "x"})], "criterion: the field asks is missing"),
        ([change(**EXTRA) | {"criterion": ROW["criterion"]}], "an extension has no points"),
        ([READ | {"exercises": "exercises/intro"}], "exercises: a page for reading has none"),
    ],
)
def test_a_wrong_row_is_refused_with_its_place(rows: Any, message: str, tmp_path: Path) -> None:
    with pytest.raises(ChapterError, match=message):
        load_chapters(write(tmp_path, rows))


def test_a_registry_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    with pytest.raises(ChapterError, match=r"chapters\.yml: cannot be read"):
        load_chapters(tmp_path)
    (tmp_path / "content").mkdir()
    (tmp_path / REGISTRY).write_text("- [", encoding="utf-8")
    with pytest.raises(ChapterError, match=r"chapters\.yml: cannot be read"):
        load_chapters(tmp_path)


def test_an_unknown_chapter_lists_the_known_ones() -> None:
    with pytest.raises(ChapterError, match=r"expected one of start, .*, step6.*, got 'step7'"):
        get_chapter("step7")


# ---- Labels and contents


def write_pages(folder: Path, **pages: str) -> Path:
    write(folder, [ROW])
    (folder / "book").mkdir()
    for name, text in pages.items():
        (folder / "book" / f"{name}.md").write_text(text, encoding="utf-8")
    return folder


def test_a_label_leads_to_its_page_whether_it_stands_above_a_heading_or_not(tmp_path: Path) -> None:
    page = "(page-first)=\n# Title\n\n(first-a)=\n## A\n\n(first-b)=\nText.\n"
    root = write_pages(tmp_path, first_page=page, other="(other-a)=\n## B\n")
    assert make_link("first-a", root) == "../book/first_page.html#first-a"
    assert make_link("first-b", root) == "../book/first_page.html#first-b"
    assert [read_labels(root)[name].level for name in ("page-first", "first-a", "first-b")] == [
        1,
        2,
        0,
    ]
    for label in ("page-first", "other-a", "nowhere"):
        with pytest.raises(LabelError, match=f"expected a label such as step4-clean.*'{label}'"):
            make_link(label, root)


def test_a_label_that_stands_twice_is_refused(tmp_path: Path) -> None:
    root = write_pages(tmp_path, first_page="(a)=\n## A\n", other="(a)=\n## A\n")
    with pytest.raises(LabelError, match="label a: stands on book/first_page and on book/other"):
        read_labels(root)


def test_contents_are_listed_with_their_captions_and_without_addresses() -> None:
    toc = {
        "root": "book/index",
        "parts": [
            {"caption": "One", "chapters": [{"file": "book/a", "sections": [{"file": "book/b"}]}]},
            {"chapters": [{"url": "https://example.org"}, {"file": "book/c"}]},
        ],
    }
    assert list_entries(toc) == [
        Entry("book/index"),
        Entry("book/a", "One"),
        Entry("book/b", "One"),
        Entry("book/c"),
    ]


def test_every_prefix_begins_objectives_of_one_length() -> None:
    # "1" and "11" may stand side by side: an objective is a prefix and one letter
    assert all(re.fullmatch(r"\d+", one.prefix) for one in list_taught())
    assert chapters.PREFIX.fullmatch("11")
