"""The hooks of the path: rows of the welcome page, groups of the sidebar, marks of difficulty."""

from __future__ import annotations

import re

from bs4 import BeautifulSoup

from content.chapters import load_chapters
from content.path import read_path
from labutils.checks.table import read_words
from solutions import load_exercises
from tests.helpers.scripts import load_script

path = load_script("book/_ext/path.py")
sidebar = load_script("book/_ext/sidebar.py")
marks = load_script("book/_ext/difficulty_marks.py")

FOLDED = """<ul><li class="toctree-l1 has-children"><a class="reference" href="a.html">A</a>
<details><summary><span class="toctree-toggle"></span></summary>
<ul><li><a class="reference" href="b.html">B</a></li></ul></details></li></ul>"""


def make_rows() -> BeautifulSoup:
    html = path.make_path(read_path(read_words()), lambda page: f"{page}.html")
    return BeautifulSoup(html, "html.parser")


def test_every_chapter_has_a_row_with_its_question_and_minutes() -> None:
    rows = make_rows().select("li")
    chapters = load_chapters()
    assert [row.a.get_text() for row in rows if row.a] == [one.heading for one in chapters]
    for row, chapter in zip(rows, chapters, strict=True):
        assert re.search(r"Read \d+ min, do \d+ min", row.get_text())
        links = [link["href"] for link in row.select("a")]
        wanted = [one for one in (chapter.page, chapter.exercises) if one]
        assert links == [f"{one}.html" for one in wanted]


def test_rows_name_every_exercise_once_required_or_not() -> None:
    rows = make_rows()
    required = " ".join(str(row["data-required"]) for row in rows.select("[data-required]"))
    optional = " ".join(str(row["data-optional"]) for row in rows.select("[data-optional]"))
    cards = load_exercises()
    assert required.split() == [name for name, one in cards.items() if one.points]
    assert optional.split() == [name for name, one in cards.items() if not one.points]


def test_no_number_of_the_reader_stands_in_the_page_itself() -> None:
    for place in make_rows().select(".path-on, .path-done"):
        assert place.has_attr("hidden")
        assert not place.get_text()


def test_what_the_theme_folds_is_open_and_no_stop_of_the_keyboard() -> None:
    soup = BeautifulSoup(FOLDED, "html.parser")
    sidebar.unfold(soup)
    assert not soup.select("details, summary")
    assert [link.get_text() for link in soup.select("li.has-children > ul a")] == ["B"]


def test_exercises_get_a_place_for_their_count() -> None:
    soup = BeautifulSoup(FOLDED, "html.parser")
    sidebar.add_counts(soup, {"b.html": ["one", "two"]})
    (place,) = soup.select(".path-count")
    assert (place["data-exercises"], place.has_attr("hidden")) == ("one two", True)
    assert place.parent is not None
    assert place.parent["href"] == "b.html"


def test_exercises_are_found_by_the_page_that_holds_them() -> None:
    found = sidebar.list_exercises()
    assert [name for names in found.values() for name in names] == list(load_exercises())
    assert found["exercises/step3_depth"][0] == "process_depth"


def test_dots_are_hidden_from_screen_readers_and_the_word_is_not() -> None:
    html = marks.wrap_marks("<td>●●○ medium</td>")
    assert html == '<td><span class="difficulty" aria-hidden="true">●●○</span> medium</td>'
