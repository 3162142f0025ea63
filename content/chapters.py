"""The chapters of the book, one row each: what every other part asks instead of a file's name.

The rows stand in ``content/chapters.yml``, in reading order:

.. code-block:: yaml

    - id: step1               # names the labels step1-..., the notes, the instructor's page
      kind: required          # or extension, or reading
      page: book/step1_camera
      exercises: exercises/step1_camera
      name: Step 1            # with the title, the heading of the page: "Step 1: What ...?"
      title: What does the robot see?
      prefix: "1"             # of its objectives 1a, 1b ...
      strip: RGB-D            # optional: its label in the strip above the pages
      criterion:              # optional: its row of the rubric
        name: Camera rendering
        asks: Color and depth of ...

A *required* chapter belongs to the lab, and its exercises to the lab's 100 points. An *extension*
has everything that a chapter has, but no points: the report shows it in a table of its own. A page
for *reading* has no exercises; it is listed for its questions, its objectives, or its place in the
strip.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any

from content import ROOT
from content.fields import check_fields, read_yaml

REGISTRY = Path("content", "chapters.yml")

REQUIRED, EXTENSION, READING = KINDS = ("required", "extension", "reading")
#: How many objectives a chapter of a kind has.
OBJECTIVES = {REQUIRED: range(3, 6), EXTENSION: range(2, 6)}

ID = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
PREFIX = re.compile(r"\d+")
PAGE = re.compile(r"book/[a-z0-9_]+")


class ChapterError(ValueError):
    """A row of the registry is wrong, or there is no such chapter; the message says which."""


@dataclass(frozen=True)
class Criterion:
    """One row of the lab's rubric: its name, and what it asks for."""

    name: str
    asks: str


@dataclass(frozen=True)
class Chapter:
    """One row of the registry; pages are named from the repository on, without an ending."""

    id: str
    kind: str
    page: str
    name: str
    title: str
    exercises: str = ""
    prefix: str = ""
    strip: str = ""
    criterion: Criterion | None = None

    @property
    def stem(self) -> str:
        """The name of its page without the folder; its questions are called like it."""
        return PurePosixPath(self.page).name

    @property
    def heading(self) -> str:
        """The heading of its page."""
        return f"{self.name}: {self.title}"

    @property
    def lower(self) -> str:
        """Its name inside a sentence."""
        return self.name[0].lower() + self.name[1:]

    @property
    def is_extension(self) -> bool:
        """Whether it lies outside of the lab and its points."""
        return self.kind == EXTENSION

    @property
    def noun(self) -> str:
        """What sentences call it: the lab has steps."""
        return "chapter" if self.is_extension else "step"

    @property
    def short(self) -> str:
        """What the report calls it: the number of a step, the name of an extension."""
        return self.name if self.is_extension else self.prefix


@cache
def load_chapters(root: Path = ROOT) -> tuple[Chapter, ...]:
    """Read the registry.

    Raises
    ------
    ChapterError
        If the file is missing or no list of rows, or a row has a field too many or too few, a
        value of a wrong form, or something that another row has already.
    """
    path = root / REGISTRY
    rows = read_yaml(path, ChapterError)
    if not isinstance(rows, list):
        raise ChapterError(f"{REGISTRY.name}: expected a list of chapters")
    chapters = tuple(_read_row(place, row) for place, row in enumerate(rows, start=1))
    for name in ("id", "page", "exercises", "name", "prefix", "strip"):
        counts = Counter(value for one in chapters if (value := getattr(one, name)))
        if twice := [value for value, count in counts.items() if count > 1]:
            raise ChapterError(f"{REGISTRY.name}: two chapters have the {name} {twice[0]}")
    return chapters


def list_taught(root: Path = ROOT) -> tuple[Chapter, ...]:
    """List the chapters that have exercises: those of the lab and the extensions."""
    return tuple(one for one in load_chapters(root) if one.kind != READING)


def list_required(root: Path = ROOT) -> tuple[Chapter, ...]:
    """List the chapters of the lab."""
    return tuple(one for one in load_chapters(root) if one.kind == REQUIRED)


def get_chapter(id_: str, root: Path = ROOT) -> Chapter:
    """Return the chapter with an id.

    Raises
    ------
    ChapterError
        If there is none; the message names those that there are.
    """
    chapters = {one.id: one for one in load_chapters(root)}
    if id_ not in chapters:
        raise ChapterError(f"chapter: expected one of {', '.join(chapters)}, got {id_!r}")
    return chapters[id_]


def find_chapter(page: str, root: Path = ROOT) -> Chapter | None:
    """Return the chapter that a page of the book or of the exercises belongs to, if any."""
    return next((one for one in load_chapters(root) if page in (one.page, one.exercises)), None)


def _read_row(place: int, row: Any) -> Chapter:
    where = f"{REGISTRY.name}, row {place}"
    fields = check_fields(
        where,
        row,
        required=dict.fromkeys(("id", "kind", "page", "name", "title"), str),
        optional={"exercises": str, "prefix": str, "strip": str, "criterion": dict},
        error=ChapterError,
    )
    where = f"{REGISTRY.name}, {fields['id']}"
    if fields["kind"] not in KINDS:
        raise ChapterError(f"{where}: kind: expected {' or '.join(KINDS)}, got {fields['kind']!r}")
    for name, form, example in (("id", ID, "step4"), ("page", PAGE, "book/step4_color")):
        if not form.fullmatch(fields[name]):
            raise ChapterError(f"{where}: {name}: expected such as {example}, got {fields[name]!r}")
    if "prefix" in fields and not PREFIX.fullmatch(fields["prefix"]):
        raise ChapterError(f'{where}: prefix: expected a number such as "4"')
    _check_kind(where, fields)
    if "criterion" in fields:
        fields = fields | {"criterion": _read_criterion(where, fields["criterion"])}
    return Chapter(**fields)


def _check_kind(where: str, fields: dict[str, Any]) -> None:
    """Refuse what a kind of chapter cannot have, and ask for what it has to have."""
    kind = fields["kind"]
    if kind == READING:
        for name in ("exercises", "criterion"):
            if name in fields:
                raise ChapterError(f"{where}: {name}: a page for reading has none")
        return
    for name in ("exercises", "prefix"):
        if name not in fields:
            raise ChapterError(f"{where}: the field {name} is missing, kind is {kind}")
    due = fields["page"].replace("book/", "exercises/", 1)
    if fields["exercises"] != due:
        raise ChapterError(f"{where}: exercises: expected {due}, got {fields['exercises']}")
    if kind == EXTENSION and "criterion" in fields:
        raise ChapterError(f"{where}: criterion: an extension has no points of the lab's rubric")


def _read_criterion(where: str, entry: Any) -> Criterion:
    where = f"{where}, criterion"
    texts = {"name": str, "asks": str}
    return Criterion(**check_fields(where, entry, texts, {}, ChapterError))
