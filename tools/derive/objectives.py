"""Write the map of the learning objectives: where each is taught, practiced and asked.

The objectives themselves stand in the chapters, as lines such as ``- **3a.** convert ...``;
``exercises/objectives.yml`` adds the sections, the cards in ``solutions`` the exercises,
``exercises/concepts`` the questions. Nothing may hang in the air: an objective without
section, exercise or question is an error, and so is every name that leads nowhere.

Usage: ``python -m tools.derive.objectives [--check]``. With ``--check`` nothing is written;
a table that is not up to date is an error.
"""

import argparse
import re
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import yaml

from content.quiz_items import Item, load_all
from solutions import load_exercises
from tools import ROOT

TABLE = Path("book", "_generated", "objectives.md")
OBJECTIVE = re.compile(r"^- \*\*(\d[a-z])\.\*\* (.+)$", re.MULTILINE)
LABEL = re.compile(r"^\(([\w-]+)\)=\n+#+ ", re.MULTILINE)  # only above a heading
MADE_BY = "<!-- Made by tools/derive/objectives.py from chapters, cards and questions. -->"


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
    """

    objectives: Mapping[str, tuple[str, str]]
    labels: Mapping[str, str]
    sections: Mapping[str, str]
    exercises: Mapping[str, Sequence[str]]
    items: Sequence[Item]

    @property
    def mapped(self) -> list[str]:
        """The objectives of the six steps; those of the background (0a ...) have no exercises."""
        return [name for name in self.objectives if not name.startswith("0")]

    def get_exercises(self, objective: str) -> list[str]:
        """Name the exercises that practice an objective."""
        return [name for name, trained in self.exercises.items() if objective in trained]

    def get_questions(self, objective: str) -> list[str]:
        """Name the questions that ask for an objective."""
        return [item.id for item in self.items if item.objective == objective]


def read_book(root: Path = ROOT) -> Book:
    """Read chapters, cards, questions and ``exercises/objectives.yml``."""
    objectives: dict[str, tuple[str, str]] = {}
    labels: dict[str, str] = {}
    for path in sorted((root / "book").glob("*.md")):
        text = path.read_text(encoding="utf-8")
        labels |= dict.fromkeys(LABEL.findall(text), path.stem)
        stated, _, _ = text.partition("## Recap")
        for name, wording in OBJECTIVE.findall(stated):
            objectives[name] = (path.stem, wording.rstrip(";,. "))
    linked = yaml.safe_load((root / "exercises" / "objectives.yml").read_text(encoding="utf-8"))
    return Book(
        objectives=dict(sorted(objectives.items())),
        labels=labels,
        sections=linked["sections"],
        exercises={name: card.objectives for name, card in load_exercises().items()},
        items=[
            item for items in load_all(root / "exercises" / "concepts").values() for item in items
        ],
    )


def find_problems(book: Book) -> list[str]:
    """Say what hangs in the air, in either direction."""
    problems = []
    for name in book.mapped:
        has = {
            "section": name in book.sections,
            "exercise": book.get_exercises(name),
            "question": book.get_questions(name),
        }
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


def make_table(book: Book) -> str:
    """Write the map as a MyST table, to be included in a page."""
    lines = [
        MADE_BY,
        "",
        "| Objective | Section | Exercises | Questions |",
        "|---|---|---|---|",
    ]
    for name in book.mapped:
        _, wording = book.objectives[name]
        cells = (
            f"**{name}** {wording}".replace("|", r"\|"),
            f"{{ref}}`{book.sections[name]}`",
            ", ".join(
                f"{{ref}}`{one} <exercise-{one.replace('_', '-')}>`"
                for one in book.get_exercises(name)
            ),
            ", ".join(f"{{ref}}`{item} <quiz-{item}>`" for item in book.get_questions(name)),
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def main(arguments: Sequence[str] | None = None) -> int:
    """Check the map and write it; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing, fail when stale")
    options = parser.parse_args(arguments)
    book = read_book()
    if problems := find_problems(book):
        print("objectives: nothing may hang in the air", *problems, sep="\n  ", file=sys.stderr)
        return 1
    path, table = ROOT / TABLE, make_table(book)
    if options.check:
        if not path.is_file() or path.read_text(encoding="utf-8") != table:
            print(f"{TABLE} is stale: run python -m tools.derive.objectives", file=sys.stderr)
            return 1
        print(f"objectives: {len(book.mapped)}, all mapped; {TABLE} is up to date")
        return 0
    path.parent.mkdir(exist_ok=True)
    path.write_text(table, encoding="utf-8")
    print(f"objectives: {len(book.mapped)}, all mapped; wrote {TABLE}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
