"""Where the axes of a plot are: as large as the texts around them allow."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from labutils._drawing.axis_shapes import (
    ABOVE_TICK,
    BESIDE_AXIS,
    FONT,
    LABEL_GAP,
    LINE,
    PAD,
    TITLE_FONT,
    TITLE_HEIGHT,
    count_labels_below,
    count_labels_beside,
    measure_label,
    measure_labels,
    measure_note,
)
from labutils._drawing.end_labels import find_ends, find_shifts
from labutils._drawing.shapes import Box
from labutils._drawing.style import END_LABEL_SHIFT, PIXELS_PER_POINT
from labutils._drawing.text_widths import measure, wrap
from labutils._drawing.ticks import Ticks, make_ticks

if TYPE_CHECKING:
    from labutils._drawing.parts import Plot

TITLE_LINE = 1.2 * TITLE_FONT
#: Share of a figure that axes have before there is any text: there, ticks are first tried.
_FIRST_SHARE = 0.775
#: The ticks depend on the size of the axes, and that on the labels; twice is enough for most.
_TRIES = 3
_SHORTEST = 10.0  # page pixels


class Frame(NamedTuple):
    """The axes of a plot, their ticks, and the lines of its title."""

    box: Box
    x_ticks: Ticks
    y_ticks: Ticks
    title: list[str]


def find_frame(plot: Plot, width: float, height: float) -> Frame:
    """Make room in a figure of a size for all texts around the axes."""
    box = Box(0, 0, _FIRST_SHARE * width, _FIRST_SHARE * height)
    title: list[str] = []
    for _ in range(_TRIES):
        x_ticks = make_ticks(plot.x, count_labels_below(box.width))
        y_ticks = make_ticks(plot.y, count_labels_beside(box.height))
        x, wide = _fit_width(plot, width, x_ticks, y_ticks)
        middle = x + wide / 2
        title = wrap(plot.title, TITLE_FONT, 2 * min(middle, width - middle))
        y, tall = _fit_height(plot, height, y_ticks, len(title))
        box = Box(x, y, wide, tall)
    return Frame(box, x_ticks, y_ticks, title)


def _fit_width(plot: Plot, width: float, x_ticks: Ticks, y_ticks: Ticks) -> tuple[float, float]:
    """Return the left edge of the axes and their width."""
    label = LINE + LABEL_GAP if plot.y.label else 0.0
    left = PAD + label + measure_labels(y_ticks) + BESIDE_AXIS
    # What stands at a share of the width and reaches so far to its right.
    reaching = [(1.0, 0.0)]
    shares = plot.x.to_share(x_ticks.values)
    for text, share in zip(x_ticks.labels, shares, strict=True):
        reaching.append((float(share), measure_label(text) / 2))
    if plot.naming == "ends":
        ends = plot.x.to_share(find_ends(plot)[:, 0])
        for curve, share in zip(plot.curves, ends, strict=True):
            shift = END_LABEL_SHIFT * PIXELS_PER_POINT
            reaching.append((float(share), shift + measure(curve.name, FONT)))
    return left, _find_largest(width - PAD - left, reaching)


def _fit_height(plot: Plot, height: float, y_ticks: Ticks, title: int) -> tuple[float, float]:
    """Return the upper edge of the axes and their height, below so many lines of title."""
    label = LINE + LABEL_GAP if plot.x.label else 0.0
    bottom = height - PAD - label - LINE - BESIDE_AXIS
    above = TITLE_HEIGHT + (title - 1) * TITLE_LINE if title else 0.0
    reaching = [(1.0, max(above, measure_note(y_ticks)))]
    reaching += [(float(share), ABOVE_TICK) for share in plot.y.to_share(y_ticks.values)]
    if plot.naming == "ends":
        ends = plot.y.to_share(find_ends(plot)[:, 1])
        for share, shift in zip(ends, find_shifts(plot), strict=True):
            reaching.append((float(share), shift * PIXELS_PER_POINT + LINE / 2))
    tall = _find_largest(bottom - PAD, reaching)
    return bottom - tall, tall


def _find_largest(room: float, reaching: list[tuple[float, float]]) -> float:
    """Return the largest length of an axis such that share x length + reach fits everywhere."""
    fitting = min((room - reach) / share for share, reach in reaching if share > 0)
    return max(fitting, _SHORTEST)  # names may be longer than a figure is wide
