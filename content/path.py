"""The path through the book: which pages and exercises, in which order, and how long they take."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from content import ROOT
from content.chapters import EXTENSION, READING, Chapter, load_chapters
from content.difficulty import Difficulty, get_difficulty
from content.page_minutes import Minutes, measure_page

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from pathlib import Path

#: The one page for reading that nobody should skip.
FIRST = "start"


@dataclass(frozen=True)
class Task:
    """An exercise as the path sees it."""

    name: str
    title: str
    points: int
    difficulty: Difficulty

    @property
    def anchor(self) -> str:
        """Where it stands on its page."""
        return f"exercise-{self.name.replace('_', '-')}"


@dataclass(frozen=True)
class Leg:
    """One chapter of the path: its own minutes, and its exercises in order."""

    chapter: Chapter
    minutes: Minutes
    required: tuple[Task, ...] = ()
    optional: tuple[Task, ...] = ()

    @property
    def is_required(self) -> bool:
        """Whether the minimal path leads here."""
        return self.chapter.kind not in (READING, EXTENSION) or self.chapter.id == FIRST


def read_path(words: Mapping[str, Any], root: Path = ROOT) -> tuple[Leg, ...]:
    """Read the path.

    Parameters
    ----------
    words : mapping of str to mapping
        What is known of each exercise by its name, in the order of the book: its ``title``, the
        ``chapter`` in short, its ``points`` and its ``difficulty``.
    root : Path
        Folder of the repository.
    """
    tasks: dict[str, list[Task]] = {}
    for name, one in words.items():
        level = get_difficulty(one["difficulty"])
        tasks.setdefault(one["chapter"], []).append(Task(name, one["title"], one["points"], level))
    return tuple(
        Leg(
            chapter,
            measure_page(chapter.page, root),
            *_split(tasks.get(chapter.short, []) if chapter.kind != READING else []),
        )
        for chapter in load_chapters(root)
    )


def _split(tasks: list[Task]) -> tuple[tuple[Task, ...], tuple[Task, ...]]:
    """Part the tasks with points from those without."""
    return tuple(one for one in tasks if one.points), tuple(one for one in tasks if not one.points)


def add_minutes(tasks: Iterable[Task]) -> int:
    """Return how long exercises take together."""
    return sum(one.difficulty.minutes for one in tasks)


def get_minimal_minutes(path: Iterable[Leg]) -> int:
    """Return how long the minimal path takes: required pages and required exercises."""
    return sum(leg.minutes.total + add_minutes(leg.required) for leg in path if leg.is_required)


def get_strong_minutes(path: Iterable[Leg]) -> int:
    """Return how long the strong path takes: all pages and exercises but those of extensions."""
    return sum(
        leg.minutes.total + add_minutes((*leg.required, *leg.optional))
        for leg in path
        if not leg.chapter.is_extension
    )


def say_hours(minutes: int) -> str:
    """Say how many hours that is, to the nearest whole one."""
    hours = max(1, round(minutes / 60))
    return f"about {hours} hour{'s' if hours > 1 else ''}"
