"""Ink and strokes of the drawings: one style, readable on light and on dark pages.

Used by ``tools/draw/figures.py``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes

INK = "#767b85"  # the ink of labutils.figures: 4:1 and more on paper and on the dark ground
ACCENT = "#c0611a"
COOL = "#2781b4"
X_RED, Y_GREEN, Z_BLUE = "#d9483b", "#2a8c4c", "#3d7dd2"
WASH = 0.16  # opacity of filled shapes: the page shows through

STYLE = {
    "font.size": 12,
    "mathtext.fontset": "dejavusans",
    "text.color": INK,
    "lines.linewidth": 1.5,
    "svg.fonttype": "path",  # an <img> cannot rely on the reader's fonts
    "svg.hashsalt": "draw_figures",
}
WIDTH = 5.4  # inches: at 12 pt the letters still read at 360 px


def make_axes(x: tuple[float, float], y: tuple[float, float]) -> Axes:
    """Return empty axes with equal units that fill a figure of the book's width."""
    height = WIDTH * abs(y[1] - y[0]) / (x[1] - x[0])
    ax = Figure(figsize=(WIDTH, height)).add_axes((0.0, 0.0, 1.0, 1.0))
    ax.set_axis_off()
    ax.set_xlim(*x)
    ax.set_ylim(*y)
    return ax


def line(
    ax: Axes, start: Any, end: Any, color: str = INK, *, style: str = "-", lw: float = 1.5
) -> None:
    """Draw a straight line."""
    ax.plot([start[0], end[0]], [start[1], end[1]], style, color=color, lw=lw)


def arrow(
    ax: Axes, start: Any, end: Any, color: str = INK, *, style: str = "-|>", lw: float = 1.6
) -> None:
    """Draw an arrow that ends exactly at `end`."""
    ax.add_patch(
        FancyArrowPatch(
            tuple(start), tuple(end), arrowstyle=style, mutation_scale=12, color=color, lw=lw,
            shrinkA=0, shrinkB=0,
        )
    )  # fmt: skip


def label(ax: Axes, at: Any, text: str, color: str = INK, ha: str = "center", **more: Any) -> None:
    """Write a label at a point."""
    ax.text(at[0], at[1], text, color=color, ha=ha, **{"va": "center", **more})


def measure(ax: Axes, start: Any, end: Any, text: str, shift: Any, *, color: str = INK) -> None:
    """Draw a dimension line with its letter `shift` away from the middle."""
    arrow(ax, start, end, color, style="<|-|>", lw=1.1)
    middle = (np.asarray(start) + np.asarray(end)) / 2 + np.asarray(shift)
    label(ax, middle, text, color)


def dot(ax: Axes, at: Any, color: str = INK, size: float = 6.0) -> None:
    """Mark a point."""
    ax.plot(at[0], at[1], "o", color=color, ms=size)


def save(ax: Axes, path: Path) -> None:
    """Write the drawing; the same drawing gives the same bytes."""
    # Neither the date nor the version of the tool goes into the file.
    metadata = {"Date": None, "Creator": None}
    figure = ax.figure
    assert isinstance(figure, Figure)  # noqa: S101 - `make_axes` gave them to a figure of their own
    figure.savefig(path, transparent=True, metadata=metadata)
