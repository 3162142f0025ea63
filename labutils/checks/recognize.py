"""Name a mistake: only where every answer equals what that mistake gives.

No guessing: an answer that merely resembles a known mistake gets no name.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from labutils.checks.compare import is_same_outcome, to_canonical

if TYPE_CHECKING:
    from labutils.checks.table import CheckTable, Outcome


def recognize_mistakes(table: CheckTable, answers: tuple[Outcome, ...]) -> tuple[str, ...]:
    """Return the names of the mistakes (one or two) that explain every answer, or ().

    Single mistakes are tried before pairs: the simplest explanation wins.
    """
    answers = tuple(to_canonical(table.parts, answer) for answer in answers)
    for made in sorted(table.wrong, key=len):
        pairs = zip(table.wrong[made], answers, strict=True)
        if all(is_same_outcome(table.parts, known, yours) for known, yours in pairs):
            return made
    return ()


def get_hint(table: CheckTable, made: tuple[str, ...]) -> tuple[str, ...]:
    """Return what to say to someone who made these mistakes, one text per mistake."""
    return tuple(table.misconceptions[name] for name in made)
