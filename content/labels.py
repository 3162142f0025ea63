"""Find the page of a label: written above a heading, or above the paragraph it means."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

from content import ROOT
from content.chapters import load_chapters

if TYPE_CHECKING:
    from pathlib import Path

LABEL = re.compile(r"^\(([\w-]+)\)=\n+(#*)", re.MULTILINE)


class LabelError(ValueError):
    """A label is there twice, or is not the label of a section; the message says where."""


@dataclass(frozen=True)
class Label:
    """Where a label stands: its page, and the level of the heading below it, or 0."""

    page: str
    level: int


@cache
def read_labels(root: Path = ROOT) -> dict[str, Label]:
    """Read the labels of all pages in ``book/``, and refuse one that is there twice."""
    labels: dict[str, Label] = {}
    for path in sorted((root / "book").glob("*.md")):
        page = f"book/{path.stem}"
        for name, marks in LABEL.findall(path.read_text(encoding="utf-8")):
            if name in labels:
                raise LabelError(f"label {name}: stands on {labels[name].page} and on {page}")
            labels[name] = Label(page, len(marks))
    return labels


def make_link(label: str, root: Path = ROOT) -> str:
    """Return the address of a section of a chapter, relative to any page of the book.

    Raises
    ------
    LabelError
        If the label is unknown, names a whole page, or stands on a page that is no chapter.
    """
    found = read_labels(root).get(label)
    pages = {chapter.page for chapter in load_chapters(root)}
    if found is None or found.level == 1 or found.page not in pages:
        raise LabelError(
            f"section: expected a label such as step4-clean, of a section of a chapter, "
            f"got {label!r}"
        )
    return f"../{found.page}.html#{label}"
