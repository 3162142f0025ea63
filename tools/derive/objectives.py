"""Write the map of the learning objectives: where each is taught, practiced and asked.

What is written comes from ``content/objectives.py``, and the exercises from the cards. Nothing may
hang in the air: an objective without section, exercise or question is an error, and so is every
name that leads nowhere.

Usage: ``python -m tools.derive.objectives [--check]``. With ``--check`` nothing is written;
a table that is not up to date is an error.
"""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from content.objectives import Book, find_problems
from content.objectives import read_book as read_content
from solutions import load_exercises
from tools import ROOT

TABLE = Path("book", "_generated", "objectives.md")
MADE_BY = "<!-- Made by tools/derive/objectives.py from chapters, cards and questions. -->"


def read_book(root: Path = ROOT) -> Book:
    """Read chapters and questions, and what the cards say they practice."""
    return read_content({name: card.objectives for name, card in load_exercises().items()}, root)


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
