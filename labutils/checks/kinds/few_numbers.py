"""Kinds of few numbers: told one by one, to which side and by which share, never by how much."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from labutils.checks.kinds.base import Kind

if TYPE_CHECKING:
    from labutils.checks.table import Part


@dataclass(frozen=True, kw_only=True)
class FewNumbers(Kind):
    """Numbers few enough to be told apart by their place.

    Parameters
    ----------
    places : str
        What the places are called, one letter each; without them by their index.
    """

    places: str = ""
    is_few: ClassVar[bool] = True

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell of the first three that are off; count the rest."""
        texts = []
        for place in zip(*np.nonzero(np.atleast_1d(wrong)), strict=True):
            x = float(np.atleast_1d(expected)[place])
            y = float(np.atleast_1d(yours)[place])
            texts.append(f"{self._name_place(part, place)} is {_describe_side(x, y)}")
        shown = "; ".join(texts[:3])
        more = f"; and {len(texts) - 3} more" if len(texts) > 3 else ""
        return f"{shown}{more}."

    def _name_place(self, part: Part, place: tuple[int, ...]) -> str:
        if self.places:
            return self.places[place[0]]
        return f"{part.name}[{', '.join(map(str, place))}]" if self.ndim else part.name


def _describe_side(expected: float, yours: float) -> str:
    if not np.isfinite(yours):
        return "no finite number"
    if expected == 0:
        return "not zero, as it has to be"
    if yours == 0:
        return "zero"
    if (expected < 0) != (yours < 0):
        return "of the wrong sign"
    side = "large" if abs(yours) > abs(expected) else "small"
    share = abs(yours - expected) / abs(expected)
    for limit, words in ((0.001, "less than 0.1 %"), (0.01, "less than 1 %"), (0.1, "1 to 10 %")):
        if share < limit:
            return f"too {side} by {words}"
    return f"too {side} by more than 10 %"


KINDS = (
    FewNumbers(name="number", ndim=0, shape="a single number"),
    FewNumbers(
        name="matrix",
        ndim=2,
        shape="3 rows and 3 columns",
        relations=("numbers", "matrices", "entries"),
    ),
    FewNumbers(
        name="pixel",
        ndim=1,
        shape="two numbers",
        places="xyz",
        relations=("numbers", "axes", "entries"),
    ),
    FewNumbers(
        name="vector",
        ndim=1,
        shape="as many numbers as the statement says",
        relations=("numbers", "axes", "entries"),
    ),
)
