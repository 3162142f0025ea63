"""Kinds of many rows: points, colors of points, boxes, pixels and lists, told column by column."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.kinds.base import Kind, round_to_digit
from labutils.checks.kinds.matching import is_same_on_average, match_points
from labutils.checks.kinds.panels import draw_clouds

if TYPE_CHECKING:
    from collections.abc import Sequence

    from labutils.checks.table import Part
    from labutils.checks.verdict import PanelPicture


@dataclass(frozen=True, kw_only=True)
class Rows(Kind):
    """One row per thing.

    Parameters
    ----------
    columns : sequence of str
        What the columns are called.
    """

    columns: Sequence[str] = "xyz"

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell how many rows are off in which column, and by how much typically."""
        texts = []
        for axis in np.flatnonzero(wrong.any(axis=0)):
            columns = (expected[:, axis], yours[:, axis], wrong[:, axis])
            where, typical = self._describe_column(part, *columns)
            texts.append(f"{self.columns[int(axis)]} in {where} rows{typical}")
        return f"{part.name}: off are {'; '.join(texts)}."

    def _describe_column(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> tuple[str, str]:
        unit = f" {part.unit}" if part.unit else ""
        gaps = np.abs(self.get_differences(part, expected, yours))
        finite = gaps[np.isfinite(gaps) & wrong]
        many = len(finite) > 1
        typical = f", typically by {round_to_digit(np.median(finite))}{unit}" if many else ""
        return f"{np.count_nonzero(wrong)} of {len(wrong)}", typical


@dataclass(frozen=True, kw_only=True)
class Column(Rows):
    """Numbers, one per thing: a single column without a name."""

    def describe(
        self, part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
    ) -> str:
        """Tell how many are off and by how much typically."""
        where, typical = self._describe_column(part, expected, yours, wrong)
        return f"{where} values of {part.name} are off{typical}."


@dataclass(frozen=True, kw_only=True)
class Points(Rows):
    """Rows that are places, so that both answers can be drawn over each other."""

    def draw(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> PanelPicture | None:
        """Draw both along the third axis; they may differ in the number of points."""
        if yours.ndim != 2 or yours.shape[1:] != expected.shape[1:]:
            return None
        gaps = None
        if expected.shape == yours.shape:
            gaps = np.abs(self.get_differences(part, expected, yours)).max(axis=1)
        return draw_clouds(part.name, expected, yours, gaps)


@dataclass(frozen=True, kw_only=True)
class Cloud(Points):
    """Points whose order carries no meaning."""

    def find_order(self, part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray | None:
        """Match every point of yours with an expected one."""
        if self.is_close(part, expected, yours):
            return None
        if not is_same_on_average(expected, yours, part.atol):
            return None
        return match_points(expected, yours, part.atol)


KINDS = (
    Points(
        name="rows",
        ndim=2,
        shape="(N, 3), one row per point that came in",
        relations=("numbers", "axes", "entries", "lists", "selections", "regions", "rigid"),
    ),
    Cloud(
        name="cloud",
        ndim=2,
        shape="(N, 3), one row per point that is kept",
        counts_rows=True,
        moves_with_cloud=True,
        relations=("numbers", "axes", "entries", "selections", "rigid"),
    ),
    Rows(
        name="attached",
        ndim=2,
        shape="(N, 3), one row per point",
        counts_rows=True,
        moves_with_cloud=True,
        columns="RGB",
        relations=("numbers", "axes", "entries", "selections"),
    ),
    Points(
        name="pixels",
        ndim=2,
        shape="(N, 2), one row per point that came in",
        columns="uv",
        relations=("numbers", "axes", "entries", "lists", "regions"),
    ),
    Rows(
        name="boxes",
        ndim=2,
        shape="(N, 4), one row per object",
        counts_rows=True,
        empty_shape=(0, 4),
        columns=("left", "top", "width", "height"),
        relations=("numbers", "entries", "lists", "selections"),
    ),
    Column(
        name="list",
        ndim=1,
        shape="(N,), one value per object",
        counts_rows=True,
        empty_shape=(0,),
        relations=("numbers", "lists", "selections"),
    ),
)
