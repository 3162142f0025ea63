"""Color bars: the scale of one picture or of several."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing.axis_shapes import (
    ABOVE_TICK,
    ASCENT,
    BELOW_TICK,
    BESIDE_AXIS,
    FONT,
    LABEL_GAP,
    LINE,
    LINE_WIDTH,
    PAD,
    count_labels_below,
    count_labels_beside,
    draw_note_above,
    draw_note_below,
    draw_ticks,
    measure_label,
    measure_labels,
    measure_note,
)
from labutils._drawing.color_maps import get_table
from labutils._drawing.scales import Axis
from labutils._drawing.shapes import Bitmap, Box, Shape, Stroke, Text
from labutils._drawing.ticks import make_ticks

if TYPE_CHECKING:
    from labutils._drawing.parts import ColorBar, Panel

_GAP_ABOVE = 0.05  # share of the width of a picture
#: From the lower edge of a bar to that of the figure: ticks, their labels, the label.
_LABELS_BELOW = BESIDE_AXIS + LINE + LABEL_GAP + LINE + PAD


def place_beside(bar: ColorBar, panel: Panel, width: float, height: float) -> Box:
    """Place a bar at the right edge of a figure; it is as tall as the figure."""
    axis = _get_axis(bar, panel)
    length, above, outside = height - 2 * PAD, 0.0, 0.0
    for _ in range(2):  # its ticks depend on its length, and that on the labels of the ticks
        ticks = make_ticks(axis, count_labels_beside(length))
        first, last = axis.to_share(ticks.values[[0, -1]])
        above = max(ABOVE_TICK - (1 - last) * length, measure_note(ticks))
        below = max(BELOW_TICK - first * length, 0.0)
        length = height - 2 * PAD - above - below
        outside = BESIDE_AXIS + measure_labels(ticks) + LABEL_GAP + LINE + PAD
    thick = length / bar.aspect
    return Box(width - outside - thick, PAD + above, thick, length)


def draw_beside(bar: ColorBar, panel: Panel, box: Box) -> list[Shape]:
    """Draw a bar with its labels on the right; low values are at its lower end."""
    axis = _get_axis(bar, panel)
    ticks = make_ticks(axis, count_labels_beside(box.height))
    places = box.bottom - box.height * axis.to_share(ticks.values)
    labels = draw_ticks(ticks, places, np.empty(0), box.right, "right")
    x = box.right + BESIDE_AXIS + measure_labels(ticks) + LABEL_GAP + ASCENT * FONT
    label = Text("label", bar.label, x, box.y + box.height / 2, is_turned=True)
    note = draw_note_above(ticks, box.x, box.y)
    colors = get_table(panel.color_map)[::-1, None]
    return [*_draw_strip(colors, box), *labels, label, *note]


def measure_below(bar: ColorBar, cell: float) -> float:
    """Return how much room a bar needs below pictures that are `cell` wide."""
    return _GAP_ABOVE * cell + _measure_length(bar, cell) / bar.aspect + _LABELS_BELOW


def measure_beyond(bar: ColorBar, panel: Panel, cell: float) -> tuple[float, float]:
    """Return how far the labels of a bar below pictures reach beyond its left and right end."""
    axis = _get_axis(bar, panel)
    length = _measure_length(bar, cell)
    ticks = make_ticks(axis, count_labels_below(length))
    shares = axis.to_share(ticks.values)
    halves = [measure_label(label) / 2 for label in ticks.labels]
    left = [half - share * length for half, share in zip(halves, shares, strict=True)]
    right = [half - (1 - share) * length for half, share in zip(halves, shares, strict=True)]
    return max(left, default=0.0), max(right, default=0.0)


def _measure_length(bar: ColorBar, cell: float) -> float:
    count = len(bar.panels)
    return cell * count + 2 * PAD * (count - 1)


def draw_below(bar: ColorBar, panel: Panel, above: list[Box], height: float) -> list[Shape]:
    """Draw a bar below pictures, at the lower edge of a figure."""
    x, right = above[0].x, above[-1].right
    thick = (right - x) / bar.aspect
    box = Box(x, height - _LABELS_BELOW - thick, right - x, thick)
    axis = _get_axis(bar, panel)
    ticks = make_ticks(axis, count_labels_below(box.width))
    places = x + box.width * axis.to_share(ticks.values)
    labels = draw_ticks(ticks, places, np.empty(0), box.bottom, "below")
    base = height - PAD - LINE + ASCENT * FONT
    label = Text("label", bar.label, x + box.width / 2, base)
    note = draw_note_below(ticks, right, base)
    colors = get_table(panel.color_map)[None]
    return [*_draw_strip(colors, box), *labels, label, *note]


def _get_axis(bar: ColorBar, panel: Panel) -> Axis:
    if panel.limits is None:
        raise ValueError(f"panel {panel.title!r}: expected limits for its color bar, got none")
    return Axis(bar.label, panel.limits)


def _draw_strip(colors: np.ndarray, box: Box) -> list[Shape]:
    x, y, right, bottom = box.x, box.y, box.right, box.bottom
    corners = np.array([(x, y), (right, y), (right, bottom), (x, bottom), (x, y)])
    return [Bitmap("bar", box, colors), Stroke("axis", corners, LINE_WIDTH)]
