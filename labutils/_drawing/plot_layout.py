"""Place the axes, curves and names of a plot, as Matplotlib's constrained layout does."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing.axis_shapes import (
    ASCENT,
    BESIDE_AXIS,
    FONT,
    LABEL_GAP,
    LINE,
    LINE_WIDTH,
    TITLE_FONT,
    TITLE_GAP,
    draw_note_above,
    draw_note_below,
    draw_ticks,
    measure_labels,
)
from labutils._drawing.end_labels import find_ends, find_shifts
from labutils._drawing.legend import draw_legend
from labutils._drawing.plot_frame import TITLE_LINE, Frame, find_frame
from labutils._drawing.shapes import Box, Dot, Drawing, Shape, Stroke, Text
from labutils._drawing.style import (
    CATEGORY_COLORS,
    END_LABEL_SHIFT,
    PIXELS_PER_INCH,
    PIXELS_PER_POINT,
)

if TYPE_CHECKING:
    from labutils._drawing.parts import Curve, Plot

_POINT_RADIUS = 3.5 * PIXELS_PER_POINT
# From the middle of a line of text down to its baseline.
_HALF_LINE = (ASCENT - 0.5) * FONT


def lay_out_plot(plot: Plot) -> Drawing:
    """Place everything that a plot shows."""
    drawing = Drawing(plot.width * PIXELS_PER_INCH, plot.height * PIXELS_PER_INCH)
    frame = find_frame(plot, drawing.width, drawing.height)
    paths = [_make_path(plot, curve, frame.box) for curve in plot.curves]
    *colors, next_color = (_get_color(number) for number in range(len(paths) + 1))
    width = plot.line_width * PIXELS_PER_POINT
    for path, color in zip(paths, colors, strict=True):
        drawing.shapes.append(Stroke("curve", path, width, color, frame.box))
    if plot.point:
        ((x, y),) = _place(plot, np.array([plot.point]), frame.box)
        drawing.shapes.append(Dot("point", x, y, _POINT_RADIUS, next_color))
    drawing.shapes.extend(_draw_axes(plot, frame))
    if plot.naming == "legend":
        drawing.shapes.extend(draw_legend(plot, frame.box, paths, colors, width))
    elif plot.naming == "ends":
        drawing.shapes.extend(_draw_end_labels(plot, frame.box, colors))
    return drawing


def _get_color(number: int) -> str:
    return CATEGORY_COLORS[number % len(CATEGORY_COLORS)]


def _place(plot: Plot, points: np.ndarray, box: Box) -> np.ndarray:
    """Return where points (N, 2) of the data stand in page pixels."""
    x = box.x + box.width * plot.x.to_share(points[:, 0])
    y = box.bottom - box.height * plot.y.to_share(points[:, 1])
    return np.stack([x, y], axis=1)


def _hide_zeros(plot: Plot, points: np.ndarray, box: Box) -> np.ndarray:
    """Place points; what a logarithmic axis cannot show is far below it."""
    places = _place(plot, points, box)
    if plot.y.log:
        places[points[:, 1] <= 0, 1] = box.bottom + box.height
    return places


def _make_path(plot: Plot, curve: Curve, box: Box) -> np.ndarray:
    if not curve.steps:
        return _hide_zeros(plot, np.stack([curve.x, curve.y], axis=1), box)
    heights = np.concatenate([[0], np.repeat(curve.y, 2), [0]])
    return _hide_zeros(plot, np.stack([np.repeat(curve.x, 2), heights], axis=1), box)


def _draw_axes(plot: Plot, frame: Frame) -> list[Shape]:
    """Draw the two axes with ticks and labels, and the title."""
    box, x_ticks, y_ticks, title = frame
    corner = np.array([(box.x, box.y), (box.x, box.bottom), (box.right, box.bottom)])
    x_places, x_minor = (
        box.x + box.width * plot.x.to_share(values) for values in (x_ticks.values, x_ticks.minor)
    )
    y_places, y_minor = (
        box.bottom - box.height * plot.y.to_share(values)
        for values in (y_ticks.values, y_ticks.minor)
    )
    below = box.bottom + BESIDE_AXIS + LINE + LABEL_GAP + ASCENT * FONT
    beside = box.x - BESIDE_AXIS - measure_labels(y_ticks) - LABEL_GAP - (LINE - ASCENT * FONT)
    middle = (box.x + box.width / 2, box.y + box.height / 2)
    texts = [
        Text("label", plot.x.label, middle[0], below),
        Text("label", plot.y.label, beside, middle[1], is_turned=True),
    ]
    for row, line in enumerate(reversed(title)):
        y = box.y - TITLE_GAP - row * TITLE_LINE
        texts.append(Text("title", line, middle[0], y, size=TITLE_FONT))
    return [
        Stroke("axis", corner, LINE_WIDTH),
        *draw_ticks(x_ticks, x_places, x_minor, box.bottom, "below"),
        *draw_ticks(y_ticks, y_places, y_minor, box.x, "left"),
        *draw_note_below(x_ticks, box.right, below),
        *draw_note_above(y_ticks, box.x, box.y),
        *(text for text in texts if text.text),
    ]


def _draw_end_labels(plot: Plot, box: Box, colors: list[str]) -> list[Shape]:
    """Write the name of each curve beside its last point, in its color."""
    places = _place(plot, find_ends(plot), box)
    places += np.array([(END_LABEL_SHIFT, 0)]) * PIXELS_PER_POINT
    places[:, 1] += _HALF_LINE - PIXELS_PER_POINT * find_shifts(plot)
    rows = zip(plot.curves, places, colors, strict=True)
    return [Text("name", curve.name, x, y, "start", color) for curve, (x, y), color in rows]
