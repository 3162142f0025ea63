"""Name every place that a scaffold left to be filled: what ``make unfilled`` runs.

A place says itself what to write there, after one word in capitals and a colon. The words are
written so that a file with unfilled places can still be read by every tool.

Usage: ``python -m tools.scaffold.unfilled``; ends with an error where a place is unfilled.
"""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tools import ROOT

if TYPE_CHECKING:
    from pathlib import Path

#: The mark of a place, with what to write there.
MARK = re.compile(r"\bFILL: (?P<what>[^\"|\n]*[^\"|\n\s])")
#: Where scaffolds write.
FILES = (
    "_toc.yml",
    "content/chapters.yml",
    "book/*.md",
    "exercises/*.md",
    "exercises/objectives.yml",
    "exercises/concepts/*.yml",
    "exercises/predictions/*.yml",
    "solutions/*.py",
    "solutions/notes/*.md",
    "tests/solutions/variants/*.py",
)


@dataclass(frozen=True)
class Place:
    """A place to fill: the file from the repository on, the line, and what to write."""

    file: str
    line: int
    what: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.what}"


def find_unfilled(root: Path = ROOT) -> list[Place]:
    """List the unfilled places, file by file."""
    found = []
    for pattern in FILES:
        for path in sorted(root.glob(pattern)):
            name = path.relative_to(root).as_posix()
            lines = path.read_text(encoding="utf-8").splitlines()
            for number, line in enumerate(lines, start=1):
                found += [Place(name, number, match["what"]) for match in MARK.finditer(line)]
    return found


def main() -> int:
    """Print the places; return a shell's exit code."""
    places = find_unfilled()
    for place in places:
        print(place)
    if places:
        print(f"unfilled: {len(places)} places; fill them, then run `make exercises`")
        return 1
    print("unfilled: none")
    return 0


if __name__ == "__main__":
    sys.exit(main())
