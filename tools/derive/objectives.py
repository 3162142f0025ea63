"""Write the map of the learning objectives: where each is taught, worked, practiced and checked.

What is written comes from ``content/objectives.py`` and ``content/coverage.py``, and the exercises
from the cards. Nothing may hang in the air: an objective that lacks one of the four on the required
path is an error, and so is every name that leads nowhere. The table stands in the instructor
edition.

Usage: ``python -m tools.derive.objectives [--check]``. With ``--check`` nothing is written;
a table that is not up to date is an error.
"""

import argparse
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from content.coverage import (
    Card,
    Row,
    Sources,
    find_gaps,
    find_unknown,
    make_rows,
    read_sources,
)
from content.objectives import Book, find_problems
from content.objectives import read_book as read_content
from solutions import load_exercises
from tools import ROOT

TABLE = Path("book", "_generated", "objectives.md")
MADE_BY = "<!-- Made by tools/derive/objectives.py from chapters, cards, questions and tasks. -->"


def read_book(root: Path = ROOT) -> Book:
    """Read chapters and questions, and what the cards say they practice."""
    return read_content({name: card.objectives for name, card in load_exercises().items()}, root)


def read_cards() -> dict[str, Card]:
    """Read which exercises have points, and what leads to them."""
    return {
        name: Card(
            bool(card.points),
            card.completion.name if card.completion else "",
            card.completion.section if card.completion else "",
        )
        for name, card in load_exercises().items()
    }


def make_table(book: Book, sources: Sources) -> str:
    """Write the map as a MyST table, to be included in a page."""
    lines = [
        MADE_BY,
        "",
        "| Objective | Taught | Worked | Practiced | Checked |",
        "|---|---|---|---|---|",
    ]
    for name, row in make_rows(book, sources).items():
        _, wording = book.objectives[name]
        cells = (
            f"**{name}** {wording}".replace("|", r"\|"),
            f"{{ref}}`{row.taught}`",
            make_worked(row),
            make_practiced(row),
            make_checked(row),
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def make_worked(row: Row) -> str:
    """List the twins, and the sections that show it by their cells."""
    return _join(
        [f"twin: {{ref}}`{one}`" for one in row.twins]
        + [f"cells of {{ref}}`{one}`" for one in row.cells]
    )


def make_practiced(row: Row) -> str:
    """List what a reader does; what is optional stands in italics."""
    return _join(
        [
            *_link("prediction", row.predictions, "", drop="predict-"),
            *_link("try it", (one for one in row.tried if not _is_figure(one)), "", drop="try-"),
            *_link("explorer", filter(_is_figure, row.tried), "", drop="fig-"),
            *_link("completion", row.completions, "completion-"),
            *_link("exercise", row.required, "exercise-"),
            *_link("*challenge*", row.challenges, "exercise-"),
            *(f"*open task* {{ref}}`{one} <open-task-{one}>`" for one in row.open_tasks),
        ]
    )


def make_checked(row: Row) -> str:
    """List what is told right or wrong, by the page or by hidden cases."""
    return _join(
        [
            *_link("question", row.questions, "quiz-"),
            *_link("completion", row.completions, "completion-"),
            *_link("exercise", row.required, "exercise-"),
            *_link("*challenge*", row.challenges, "exercise-"),
        ]
    )


def _is_figure(name: str) -> bool:
    return name.startswith("fig-")


def _link(kind: str, names: Iterable[str], prefix: str, drop: str = "") -> list[str]:
    return [
        f"{kind} {{ref}}`{one.removeprefix(drop)} <{prefix}{one.replace('_', '-')}>`"
        for one in names
    ]


def _join(parts: Iterable[str]) -> str:
    return ", ".join(parts) or "none"


def main(arguments: Sequence[str] | None = None) -> int:
    """Check the map and write it; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing, fail when stale")
    options = parser.parse_args(arguments)
    book = read_book()
    sources = read_sources(read_cards(), book)
    problems = [
        *find_problems(book),
        *find_unknown(book, sources),
        *find_gaps(make_rows(book, sources)),
    ]
    if problems:
        print("objectives: nothing may hang in the air", *problems, sep="\n  ", file=sys.stderr)
        return 1
    path, table = ROOT / TABLE, make_table(book, sources)
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
