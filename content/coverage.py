"""What the book does for each objective: taught, worked, practiced, checked.

Most of it is derived: completions, exercises and challenges say by their cards what they practice,
predictions, questions and open tasks by their files. ``exercises/objectives.yml`` adds by hand what
cannot be derived: which part of its exercise a completion practices, in which section an objective
without a twin is worked, and which boxes and explorers let a reader try it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import yaml

from content import ROOT, predictions
from content.fields import check_fields
from content.open_tasks import load_open_tasks

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from pathlib import Path

    from content.objectives import Book

BY_HAND = {"sections": dict, "completions": dict, "worked": dict, "tried": dict}

SECTION = r"^\({}\)=\n(.*?)(?=^\([\w-]+\)=$|\Z)"
CELL = re.compile(r"^```\{code-cell\}", re.MULTILINE)


class CoverageError(ValueError):
    """``exercises/objectives.yml`` is not of its form."""


@dataclass(frozen=True)
class Card:
    """What the card of an exercise says: whether it has points, and what leads to it.

    Parameters
    ----------
    is_required : bool
        It belongs to the lab's points; a challenge does not.
    completion : str
        Name of the completion problem before it; empty without one.
    twin : str
        Label of the section in which a twin of it is worked; empty without one.
    """

    is_required: bool
    completion: str = ""
    twin: str = ""


@dataclass
class Row:
    """What the book does for one objective, by labels and names."""

    taught: str = ""
    is_required: bool = True
    twins: list[str] = field(default_factory=list)
    cells: list[str] = field(default_factory=list)
    predictions: list[str] = field(default_factory=list)
    tried: list[str] = field(default_factory=list)
    completions: list[str] = field(default_factory=list)
    required: list[str] = field(default_factory=list)
    challenges: list[str] = field(default_factory=list)
    open_tasks: list[str] = field(default_factory=list)
    questions: list[str] = field(default_factory=list)

    @property
    def parts(self) -> dict[str, list[str]]:
        """What counts on the required path, by column; what is optional fills no cell."""
        return {
            "is not taught in a section": [self.taught] if self.taught else [],
            "is worked nowhere": [*self.twins, *self.cells],
            "is practiced nowhere on the required path": [
                *self.predictions,
                *self.tried,
                *self.completions,
                *self.required,
            ],
            "is checked nowhere": [*self.questions, *self.completions, *self.required],
        }


@dataclass(frozen=True)
class Sources:
    """Everything that the rows are made from, besides the book.

    Parameters
    ----------
    cards : mapping of str to Card
        By the name of the exercise.
    completions, tried : mapping of str to sequence of str
        By hand: objectives of a completion; boxes and figures of an objective.
    worked : mapping of str to str
        By hand: objective to the label of a section.
    predictions, open_tasks : mapping of str to sequence of str
        Name of a box, id of a chapter, to objectives.
    pages : mapping of str to str
        Text of each chapter.
    """

    cards: Mapping[str, Card]
    completions: Mapping[str, Sequence[str]]
    worked: Mapping[str, str]
    tried: Mapping[str, Sequence[str]]
    predictions: Mapping[str, Sequence[str]]
    open_tasks: Mapping[str, Sequence[str]]
    pages: Mapping[str, str]


def read_sources(cards: Mapping[str, Card], book: Book, root: Path = ROOT) -> Sources:
    """Read predictions, open tasks, chapters and ``exercises/objectives.yml``.

    Raises
    ------
    CoverageError
        If that file has a part too many or too few.
    """
    text = (root / "exercises" / "objectives.yml").read_text(encoding="utf-8")
    by_hand = check_fields("objectives.yml", yaml.safe_load(text), BY_HAND, {}, CoverageError)
    boxes = predictions.load_all(root / predictions.PREDICTIONS.relative_to(ROOT))
    tasks = load_open_tasks(root / "exercises" / "open_tasks")
    ids = {chapter.stem: chapter.id for chapter in book.chapters}
    return Sources(
        cards=cards,
        completions=by_hand["completions"],
        worked=by_hand["worked"],
        tried=by_hand["tried"],
        predictions={
            item.name: [item.objective]
            for items in boxes.values()
            for item in items.values()
            if item.objective
        },
        open_tasks={ids[page]: task.objectives for page, task in tasks.items()},
        pages={
            page: (root / "book" / f"{page}.md").read_text(encoding="utf-8")
            for page in dict.fromkeys(page for page, _ in book.objectives.values())
        },
    )


def make_rows(book: Book, sources: Sources) -> dict[str, Row]:
    """Return a row for each objective of a chapter with exercises."""
    twins = {card.completion: card.twin for card in sources.cards.values() if card.completion}
    rows = {}
    for name in book.mapped:
        exercises = book.get_exercises(name)
        completions = _list_keys(sources.completions, name)
        row = rows[name] = Row(
            taught=book.sections.get(name, ""),
            is_required=name in book.required,
            twins=list(dict.fromkeys(twins[one] for one in completions if one in twins)),
            predictions=_list_keys(sources.predictions, name),
            tried=list(sources.tried.get(name, [])),
            completions=completions,
            required=[one for one in exercises if sources.cards[one].is_required],
            challenges=[one for one in exercises if not sources.cards[one].is_required],
            open_tasks=_list_keys(sources.open_tasks, name),
            questions=book.get_questions(name),
        )
        if name in sources.worked:
            row.cells.append(sources.worked[name])
    return rows


def find_gaps(rows: Mapping[str, Row]) -> list[str]:
    """Say which objective of the lab has an empty cell on the required path."""
    return [
        f"objective {name} {words}"
        for name, row in rows.items()
        if row.is_required
        for words, there in row.parts.items()
        if not there
    ]


def find_unknown(book: Book, sources: Sources) -> list[str]:
    """Say which name in the sources leads nowhere, or to the wrong place."""
    return [
        *_find_unknown_objectives(book, sources),
        *_find_problems_of_completions(book, sources),
        *_find_problems_of_worked(book, sources),
        *_find_problems_of_tried(book, sources),
    ]


def _find_unknown_objectives(book: Book, sources: Sources) -> Iterator[str]:
    named = {
        "prediction": sources.predictions,
        "completion": sources.completions,
        "open task of": sources.open_tasks,
    }
    for kind, one in named.items():
        for key, names in one.items():
            for name in names:
                if name not in book.objectives:
                    yield f"{kind} {key} practices {name}, which is no objective"
    for part, keys in (("worked", sources.worked), ("tried", sources.tried)):
        yield from (f"{part}: {name} is no objective" for name in keys if name not in book.mapped)


def _find_problems_of_completions(book: Book, sources: Sources) -> Iterator[str]:
    owners = {card.completion: name for name, card in sources.cards.items() if card.completion}
    for name in owners:
        if name not in sources.completions:
            yield f"completion {name}: what it practices is missing in objectives.yml"
    for name, objectives in sources.completions.items():
        if name not in owners:
            yield f"completions: {name} belongs to no card"
            continue
        due = book.exercises[owners[name]]
        yield from (
            f"completion {name} practices {one}, but {owners[name]} does not"
            for one in objectives
            if one not in due
        )


def _find_problems_of_worked(book: Book, sources: Sources) -> Iterator[str]:
    for name, label in sources.worked.items():
        if name not in book.objectives:
            continue
        page = book.objectives[name][0]
        section = re.search(
            SECTION.format(re.escape(label)), sources.pages[page], re.DOTALL | re.MULTILINE
        )
        if section is None:
            yield f"worked: {name}: no section {label} is on {page}"
        elif not CELL.search(section[1]):
            yield f"worked: {name}: expected a cell in the section {label}"


def _find_problems_of_tried(book: Book, sources: Sources) -> Iterator[str]:
    for name, places in sources.tried.items():
        if name not in book.objectives:
            continue
        text = sources.pages[book.objectives[name][0]]
        for place in places:
            if not re.search(rf"\bname: {re.escape(place)}(?![\w-])", text):
                yield f"tried: {name}: nothing on {book.objectives[name][0]} has the name {place}"


def _list_keys(objectives: Mapping[str, Sequence[Any]], name: str) -> list[str]:
    return [key for key, names in objectives.items() if name in names]
