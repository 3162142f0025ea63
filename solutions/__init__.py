"""The instructor's room: one card per exercise, found by listing this folder."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pathlib import Path

from content.chapters import load_chapters
from labutils.checks.report import QUALITY_POINTS
from solutions._model import Absorbed, Case, Exercise, Misconception, Part

__all__ = [
    "QUALITY_POINTS",
    "Absorbed",
    "Case",
    "Exercise",
    "Misconception",
    "Part",
    "load_exercises",
]


@cache
def load_exercises() -> dict[str, Exercise]:
    """Import every card and return the exercises by name, in the order of the chapters."""
    stems = sorted(
        path.stem for path in Path(__file__).parent.glob("*.py") if not path.stem.startswith("_")
    )
    cards = [import_module(f"solutions.{stem}").EXERCISE for stem in stems]
    wrong = [card.name for stem, card in zip(stems, cards, strict=True) if card.name != stem]
    if wrong:
        raise ValueError(f"solutions: expected cards named like their files, got {wrong}")
    order = [chapter.id for chapter in load_chapters()]
    cards.sort(key=lambda card: (order.index(card.chapter), card.place))
    return {card.name: card for card in cards}
