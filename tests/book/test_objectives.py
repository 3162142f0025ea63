"""The map of the learning objectives: nothing hangs in the air, in either direction."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from content.chapters import REGISTRY, list_required
from content.coverage import (
    Card,
    CoverageError,
    Row,
    Sources,
    find_gaps,
    find_unknown,
    make_rows,
    read_sources,
)
from content.objectives import Book, find_problems
from content.quiz_items import Choice, Item
from tools.derive import objectives as make_objectives
from tools.derive.objectives import make_table, read_book, read_cards


@pytest.fixture
def book() -> Book:
    return read_book()


@pytest.fixture
def sources(book: Book) -> Sources:
    return read_sources(read_cards(), book)


def make_item(**changes: Any) -> Item:
    """A question about 2a that is in order."""
    choices = tuple(Choice(text, "Because.", text == "a") for text in "abc")
    fields: dict[str, Any] = {
        "page": "step2_intrinsics",
        "id": "zz",
        "section": "step2-focal",
        "question": "?",
        "choices": choices,
        "objective": "2a",
        "check": None,
    }
    return Item(**fields | changes)


def test_every_objective_has_section_and_question(book: Book) -> None:
    assert find_problems(book) == []


def test_the_six_steps_have_their_objectives(book: Book) -> None:
    required = list_required()
    first = [name for name in book.mapped if name.endswith("a")]
    assert first[: len(required)] == [f"{n}a" for n in range(1, 7)]
    assert [chapter.prefix for chapter in required] == [f"{n}" for n in range(1, 7)]
    for chapter in required:
        assert 3 <= sum(name[:-1] == chapter.prefix for name in book.mapped) <= 5


def test_the_table_is_up_to_date(capsys: pytest.CaptureFixture[str]) -> None:
    assert make_objectives.main(["--check"]) == 0, capsys.readouterr().err


def test_a_stale_or_missing_table_is_noticed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], book: Book
) -> None:
    monkeypatch.setattr(make_objectives, "read_book", lambda: book)
    monkeypatch.setattr(make_objectives, "ROOT", tmp_path)
    assert make_objectives.main(["--check"]) == 1
    assert "stale: run python -m tools.derive.objectives" in capsys.readouterr().err
    (tmp_path / "book").mkdir()
    assert make_objectives.main([]) == 0
    assert make_objectives.main(["--check"]) == 0
    (tmp_path / make_objectives.TABLE).write_text("old", encoding="utf-8")
    assert make_objectives.main(["--check"]) == 1


def test_an_orphan_stops_the_tool(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], book: Book
) -> None:
    monkeypatch.setattr(make_objectives, "read_book", lambda: replace(book, items=[]))
    assert make_objectives.main([]) == 1
    assert "objective 1a has no question" in capsys.readouterr().err


def without(mapping: Mapping[str, Any], name: str) -> dict[str, Any]:
    return {key: value for key, value in mapping.items() if key != name}


CROWDED = {"6f": ("step6_view", "one too many")}


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (
            lambda b: {"objectives": b.objectives | {"6e": ("step6_view", "new")}},
            [f"objective 6e has no {part}" for part in ("section", "question")],
        ),
        (
            lambda b: {"objectives": without(b.objectives, "3b")},
            [
                "section step3-reversed-z is given for 3b, which is no objective",
                "question 3b asks for 3b, which is no objective",
            ],
        ),
        (
            lambda b: {"objectives": b.objectives | {"99a": ("step6_view", "new")}},
            [
                "objective 99a: no chapter has the prefix 99",
                *(f"objective 99a has no {part}" for part in ("section", "question")),
            ],
        ),
        (
            lambda b: {"objectives": b.objectives | {"3b": ("step6_view", b.objectives["3b"][1])}},
            [
                "objective 3b: step3 has its prefix, but it is on step6_view",
                "objective 3b: its section step3-reversed-z is on another page",
                "question 3b asks for 3b, which is on another page",
            ],
        ),
        (
            lambda b: {"objectives": b.objectives | {"6e": b.objectives["6d"]} | CROWDED},
            [
                "chapter step6: expected 3 to 5 objectives, got 6",
                *(
                    f"objective {name} has no {part}"
                    for name in ("6e", "6f")
                    for part in ("section", "question")
                ),
            ],
        ),
        (
            lambda b: {"chapters": [one for one in b.chapters if one.id != "conventions"]},
            [
                (
                    "questions of conventions: no chapter has this page; add a row to "
                    f"{REGISTRY.as_posix()}"
                )
            ],
        ),
        (
            lambda b: {"sections": b.sections | {"4d": "nowhere"}},
            ["objective 4d: no heading has the label nowhere"],
        ),
        (
            lambda b: {"sections": b.sections | {"4d": "step3-range"}},
            ["objective 4d: its section step3-range is on another page"],
        ),
        (
            lambda b: {"exercises": b.exercises | {"lost": [], "odd": ["9z"]}},
            [
                "exercise lost practices no objective",
                "exercise odd practices 9z, which is no objective",
            ],
        ),
        (
            lambda b: {"items": [item for item in b.items if item.id != "5e"]},
            ["objective 5e has no question"],
        ),
        (
            lambda b: {"items": [*b.items, make_item(objective="3a")]},
            ["question zz asks for 3a, which is on another page"],
        ),
        (
            lambda b: {"items": [*b.items, make_item(objective=None)]},
            ["question zz asks for no objective, but its page has some"],
        ),
        (
            lambda b: {"items": [*b.items, make_item(objective="2z", section="nowhere")]},
            [
                "question zz: no heading has the label nowhere",
                "question zz asks for 2z, which is no objective",
            ],
        ),
        (
            lambda b: {"items": [*b.items, make_item(section="step3-range")]},
            ["question zz: its section step3-range is on another page"],
        ),
    ],
)
def test_every_kind_of_orphan_is_named(
    changes: Callable[[Book], dict[str, Any]], expected: list[str], book: Book
) -> None:
    assert find_problems(replace(book, **changes(book))) == expected


def test_every_objective_is_taught_worked_practiced_and_checked(
    book: Book, sources: Sources
) -> None:
    assert find_unknown(book, sources) == []
    assert find_gaps(make_rows(book, sources)) == []


@pytest.mark.parametrize(
    ("row", "gaps"),
    [
        (Row(), ["is not taught in a section", "worked", "practiced", "is checked nowhere"]),
        (Row("a", cells=["a"], tried=["try-a"], questions=["1a"]), []),
        (Row("a", twins=["b"], completions=["c"]), []),
        (Row("a", cells=["a"], required=["one"]), []),
        # what is optional fills no cell
        (
            Row("a", cells=["a"], challenges=["two"], open_tasks=["s"], questions=["q"]),
            ["practiced"],
        ),
        (Row("a", cells=["a"], predictions=["predict-a"]), ["is checked nowhere"]),
        (Row(is_required=False), []),
    ],
)
def test_an_empty_cell_is_named(row: Row, gaps: list[str]) -> None:
    found = find_gaps({"9a": row})
    assert len(found) == len(gaps)
    for line, words in zip(found, gaps, strict=True):
        assert line.startswith("objective 9a ")
        assert words in line


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (lambda _: {"predictions": {"predict-a": ["9z"]}}, "prediction predict-a practices 9z"),
        (lambda _: {"open_tasks": {"step1": ["9z"]}}, "open task of step1 practices 9z"),
        (lambda _: {"worked": {"9z": "step1-pan"}}, "worked: 9z is no objective"),
        (lambda _: {"tried": {"9z": []}}, "tried: 9z is no objective"),
        (lambda _: {"worked": {"1d": "step3-raw"}}, "worked: 1d: no section step3-raw is on step1"),
        (
            lambda _: {
                "worked": {"1d": "step1-pan"},
                "tried": {},
                "pages": {"step1_camera": "(step1-pan)=\n## Words only\n(step1-cameras)=\n"},
            },
            "worked: 1d: expected a cell in the section step1-pan",
        ),
        (lambda _: {"tried": {"1d": ["try-a"]}}, "nothing on step1_camera has the name try-a"),
        # the beginning of a name is no name
        (lambda _: {"tried": {"1d": ["fig-step1"]}}, "nothing on step1_camera has the name fig-"),
        (
            lambda s: {"completions": without(s.completions, "color_heights")},
            "completion color_heights: what it practices is missing in objectives.yml",
        ),
        (lambda s: {"completions": {**s.completions, "gone": []}}, "gone belongs to no card"),
        (
            lambda s: {"completions": {**s.completions, "color_heights": ["1a"]}},
            "completion color_heights practices 1a, but visualize_depth does not",
        ),
    ],
)
def test_a_name_that_leads_nowhere_is_told(
    changes: Callable[[Sources], dict[str, Any]], expected: str, book: Book, sources: Sources
) -> None:
    (problem,) = find_unknown(book, replace(sources, **changes(sources)))
    assert expected in problem


def test_a_file_of_another_form_is_refused(tmp_path: Path, book: Book) -> None:
    (tmp_path / "exercises").mkdir()
    (tmp_path / "exercises" / "objectives.yml").write_text("sections: {}\n", encoding="utf-8")
    with pytest.raises(CoverageError, match=r"objectives.yml: the field completions is missing"):
        read_sources({"one": Card(is_required=True)}, book, tmp_path)


def test_the_table_has_no_empty_cell_and_names_everything_once(
    book: Book, sources: Sources
) -> None:
    rows = make_table(book, sources).splitlines()[4:]
    assert len(rows) == len(book.mapped)
    required = {chapter.prefix for chapter in list_required()}
    for name, row in zip(book.mapped, rows, strict=True):
        assert row.startswith(f"| **{name}** ")
        cells = row.strip("| ").split(" | ")
        assert len(cells) == 5
        if name[:-1] in required:
            assert all(cell and cell != "none" for cell in cells), f"{name}: empty cell in {cells}"
        assert f"{{ref}}`{book.sections[name]}`" in row
    for exercise in book.exercises:
        assert f"{{ref}}`{exercise} <exercise-{exercise.replace('_', '-')}>`" in "".join(rows)
