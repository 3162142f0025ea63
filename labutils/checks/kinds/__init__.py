"""The kinds of answers, one entry each: how it looks, when it is right, what to say and to draw.

A new kind is one more entry in `KINDS` of the family it belongs to; a new family is one more module
in the list below. Nothing else has to know of it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from labutils.checks.kinds import (
    choices,
    closed_loop,
    disparity,
    few_numbers,
    pictures,
    rows,
)
from labutils.checks.kinds.base import Kind

if TYPE_CHECKING:
    from labutils.checks.table import Part

__all__ = ["KINDS", "Kind", "get_kind"]

_FAMILIES = (few_numbers, pictures, rows, choices, disparity, closed_loop)

#: Every kind by its name.
KINDS: dict[str, Kind] = {kind.name: kind for family in _FAMILIES for kind in family.KINDS}


def get_kind(part: Part) -> Kind:
    """Return the kind of a part, or raise ValueError with the names of all kinds."""
    kind = KINDS.get(part.kind)
    if kind is None:
        raise ValueError(f"{part.name}: expected a kind of {', '.join(KINDS)}, got {part.kind!r}")
    return kind
