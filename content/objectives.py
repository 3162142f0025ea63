"""The learning objectives: where each is taught and asked, and which exercises practice it.

The objectives themselves stand in the chapters, as lines such as ``- **3a.** convert ...``;
``exercises/objectives.yml`` adds the sections, ``exercises/concepts`` the questions. Who reads the
book says which exercises practice what. Whether each is worked and practiced, too:
`content.coverage`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

import yaml

from content import ROOT
from content.chapters import OBJECTIVES, READING, REQUIRED, Chapter, load_chapters
from content.labels import read_labels
from content.quiz_items import Item, load_all

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

OBJECTIVE = re.compile(r"^- \*\*(\d+[a-z])\.\*\* (.+)$", re.MULTILINE)


@dataclass(frozen=True)
class Book:
    """What the map is made from.

    Parameters
    ----------
    objectives : mapping of str to (str, str)
        Id to page and text, in reading order.
    labels : mapping of str to str
        Label of a section to its page.
    sections : mapping of str to str
        Objective to label.
    exercises : mapping of str to sequence of str
        Exercise to objectives.
    items : sequence of Item
        The concept questions.
    chapters : sequence of Chapter
        The registry.
    """

    objectives: Mapping[str, tuple[str, str]]
    labels: Mapping[str, str]
    sections: Mapping[str, str]
    exercises: Mapping[str, Sequence[str]]
    items: Sequence[Item]
    chapters: Sequence[Chapter]

    @property
    def mapped(self) -> list[str]:
        """The objectives of chapters with exercises; those for reading (0a ...) have none."""
        reading = {one.stem for one in self.chapters if one.kind == READING}
        return [name for name, (page, _) in self.objectives.items() if page not in reading]

    @property
    def required(self) -> list[str]:
        """The objectives of the chapters of the lab."""
        lab = {one.stem for one in self.chapters if one.kind == REQUIRED}
        return [name for name, (page, _) in self.objectives.items() if page in lab]

    def get_exercises(self, objective: str) -> list[str]:
        """Name the exercises that practice an objective."""
        return [name for name, trained in self.exercises.items() if objective in trained]

    def get_questions(self, objective: str) -> list[str]:
        """Name the questions that ask for an objective."""
        return [item.id for item in self.items if item.objective == objective]


def read_book(exercises: Mapping[str, Sequence[str]], root: Path = ROOT) -> Book:
    """Read chapters, questions and ``exercises/objectives.yml``.

    Parameters
    ----------
    exercises : mapping of str to sequence of str
        Exercise to objectives, as the cards say: this room cannot read cards.
    root : Path, optional
        The repository.
    """
    chapters = load_chapters(root)
    found: dict[str, tuple[str, str]] = {}
    for path in sorted((root / "book").glob("*.md")):
        stated, _, _ = path.read_text(encoding="utf-8").partition("## Recap")
        for name, wording in OBJECTIVE.findall(stated):
            found[name] = (path.stem, wording.rstrip(";,. "))
    order = {chapter.prefix: place for place, chapter in enumerate(chapters) if chapter.prefix}
    linked = yaml.safe_load((root / "exercises" / "objectives.yml").read_text(encoding="utf-8"))
    return Book(
        objectives=dict(
            sorted(found.items(), key=lambda one: (order.get(one[0][:-1], len(order)), one[0]))
        ),
        labels={
            name: label.page.removeprefix("book/")
            for name, label in read_labels(root).items()
            if label.level
        },
        sections=linked["sections"],
        exercises=exercises,
        items=[
            item for items in load_all(root / "exercises" / "concepts").values() for item in items
        ],
        chapters=chapters,
    )


def find_problems(book: Book) -> list[str]:
    """Say what hangs in the air, in either direction."""
    problems = _find_problems_of_chapters(book)
    for name in book.mapped:
        has = {"section": name in book.sections, "question": book.get_questions(name)}
        if name not in book.required:  # of the lab, `content.coverage` asks for more
            has["exercise"] = book.get_exercises(name)
        problems += [f"objective {name} has no {part}" for part, there in has.items() if not there]
    for name, label in book.sections.items():
        problems += _find_problems_of_section(book, name, label)
    for exercise, trained in book.exercises.items():
        if not trained:
            problems.append(f"exercise {exercise} practices no objective")
        problems += [
            f"exercise {exercise} practices {name}, which is no objective"
            for name in trained
            if name not in book.mapped
        ]
    for item in book.items:
        problems += _find_problems_of_item(book, item)
    return problems


def _find_problems_of_chapters(book: Book) -> list[str]:
    problems = []
    owners = {chapter.prefix: chapter for chapter in book.chapters if chapter.prefix}
    for name, (page, _) in book.objectives.items():
        owner = owners.get(name[:-1])
        if owner is None:
            problems.append(f"objective {name}: no chapter has the prefix {name[:-1]}")
        elif owner.stem != page:
            problems.append(f"objective {name}: {owner.id} has its prefix, but it is on {page}")
    for chapter in book.chapters:
        count = sum(page == chapter.stem for page, _ in book.objectives.values())
        if (due := OBJECTIVES.get(chapter.kind)) and count not in due:
            problems.append(
                f"chapter {chapter.id}: expected {due[0]} to {due[-1]} objectives, got {count}"
            )
    known = {chapter.stem for chapter in book.chapters}
    problems += [
        f"questions of {page}: no chapter has this page; add a row to content/chapters.yml"
        for page in dict.fromkeys(item.page for item in book.items)
        if page not in known
    ]
    return problems


def _find_problems_of_section(book: Book, name: str, label: str) -> list[str]:
    if name not in book.mapped:
        return [f"section {label} is given for {name}, which is no objective"]
    if label not in book.labels:
        return [f"objective {name}: no heading has the label {label}"]
    if book.labels[label] != book.objectives[name][0]:
        return [f"objective {name}: its section {label} is on another page"]
    return []


def _find_problems_of_item(book: Book, item: Item) -> list[str]:
    problems = []
    if item.section not in book.labels:
        problems.append(f"question {item.id}: no heading has the label {item.section}")
    elif book.labels[item.section] != item.page:
        problems.append(f"question {item.id}: its section {item.section} is on another page")
    has_objectives = any(page == item.page for page, _ in book.objectives.values())
    if item.objective is None:
        if has_objectives:
            problems.append(f"question {item.id} asks for no objective, but its page has some")
    elif item.objective not in book.objectives:
        problems.append(f"question {item.id} asks for {item.objective}, which is no objective")
    elif book.objectives[item.objective][0] != item.page:
        problems.append(f"question {item.id} asks for {item.objective}, which is on another page")
    return problems
