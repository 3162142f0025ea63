"""Read how long a page takes from the card at its top."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from content import ROOT
from content.chapters import list_taught

if TYPE_CHECKING:
    from pathlib import Path

# "| Reading | about 20 minutes |" of the card at the top of a chapter, "Time" of exercises
TIME = re.compile(
    r"^\| (Reading|Doing|Time) \| (?:about (\d+)(?: to (\d+))? minutes|as long again)", re.MULTILINE
)


@dataclass(frozen=True)
class Minutes:
    """How long a page takes."""

    reading: int = 0
    doing: int = 0

    def __add__(self, other: Minutes) -> Minutes:
        return Minutes(self.reading + other.reading, self.doing + other.doing)

    @property
    def total(self) -> int:
        """Both together."""
        return self.reading + self.doing


def read_minutes(root: Path = ROOT) -> dict[str, Minutes]:
    """Add up, by the id of a chapter, what its page and its exercise page say."""
    return {
        chapter.id: sum(
            (
                parse_minutes((root / page).with_suffix(".md").read_text(encoding="utf-8"))
                for page in (chapter.page, chapter.exercises)
            ),
            Minutes(),
        )
        for chapter in list_taught(root)
    }


def parse_minutes(text: str) -> Minutes:
    """Read the card of one page; "as long again" is as long as reading."""
    times = {
        what: (int(low) + int(high or low)) // 2 if low else None
        for what, low, high in TIME.findall(text)
    }
    reading = times.get("Reading") or 0
    doing = times.get("Doing", times.get("Time", 0))
    return Minutes(reading, reading if doing is None else doing)
