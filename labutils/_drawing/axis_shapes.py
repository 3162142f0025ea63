"""Ticks, their labels and the frame of axes and color bars."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing.shapes import Shape, Stroke, Text
from labutils._drawing.style import FONT_SIZE, PIXELS_PER_POINT, TITLE_SIZE
from labutils._drawing.text_widths import EXPONENT_SIZE, measure

if TYPE_CHECKING:
    from typing import Literal

    from labutils._drawing.ticks import Label, Ticks

    Side = Literal["below", "left", "right"]

#: Everything below is in page pixels; the numbers of points are Matplotlib's.
FONT = FONT_SIZE * PIXELS_PER_POINT
PAD = 3 * PIXELS_PER_POINT  # around a figure
TICK = 3.5 * PIXELS_PER_POINT
TICK_GAP = 3.5 * PIXELS_PER_POINT
LABEL_GAP = 4 * PIXELS_PER_POINT
LINE_WIDTH = 0.8 * PIXELS_PER_POINT
_MINOR_TICK = 2 * PIXELS_PER_POINT
_MINOR_LINE_WIDTH = 0.6 * PIXELS_PER_POINT

# Shares of the font size: from the baseline to the top, and to the bottom, of a line of text.
ASCENT = 0.76
DESCENT = 0.24
#: A line of text from top to bottom.
LINE = (ASCENT + DESCENT) * FONT
#: From the middle of a number down to its baseline.
_HALF_DIGIT = 0.365 * FONT
TITLE_FONT = TITLE_SIZE * PIXELS_PER_POINT
TITLE_GAP = 6 * PIXELS_PER_POINT  # from the baseline of a title to what is below it
TITLE_HEIGHT = ASCENT * TITLE_FONT + TITLE_GAP
#: How far the label of a tick reaches above and below it.
ABOVE_TICK = ASCENT * FONT - _HALF_DIGIT
BELOW_TICK = DESCENT * FONT + _HALF_DIGIT
_NOTE_GAP = 3 * PIXELS_PER_POINT
_NOTE_HEIGHT = _NOTE_GAP + ASCENT * FONT
#: From an axis to the labels of its ticks.
BESIDE_AXIS = TICK + TICK_GAP

_CHARACTERS_PER_LABEL = 3  # room that a label below an axis is taken to need, in font sizes
_LINES_PER_LABEL = 2  # likewise beside an axis


def count_labels_below(width: float) -> int:
    """Return how many labels have room below an axis."""
    return int(width // (_CHARACTERS_PER_LABEL * FONT))


def count_labels_beside(height: float) -> int:
    """Return how many labels have room beside an axis."""
    return int(height // (_LINES_PER_LABEL * FONT))


def measure_label(label: Label) -> float:
    """Return the width of a tick's label."""
    return measure(label.text, FONT) + measure(label.exponent, EXPONENT_SIZE * FONT)


def measure_labels(ticks: Ticks) -> float:
    """Return the width of the widest label."""
    return max((measure_label(label) for label in ticks.labels), default=0.0)


def draw_ticks(
    ticks: Ticks, places: np.ndarray, minor: np.ndarray, axis: float, side: Side
) -> list[Shape]:
    """Draw ticks and their labels.

    Parameters
    ----------
    ticks : Ticks
        Their labels.
    places, minor : ndarray
        Where the ticks with and without labels stand along the axis.
    axis : float
        The other coordinate of the axis: its y if the labels are below, else its x.
    side : "below", "left" or "right"
        Of the axis, where the labels are.
    """
    marks = [_make_mark(place, axis, TICK, LINE_WIDTH, side) for place in places]
    marks += [_make_mark(place, axis, _MINOR_TICK, _MINOR_LINE_WIDTH, side) for place in minor]
    labels = zip(ticks.labels, places, strict=True)
    return [*marks, *(_make_label(label, place, axis, side) for label, place in labels)]


def _make_mark(place: float, axis: float, length: float, width: float, side: Side) -> Stroke:
    if side == "below":
        return Stroke("axis", np.array([(place, axis), (place, axis + length)]), width)
    end = axis + length if side == "right" else axis - length
    return Stroke("axis", np.array([(axis, place), (end, place)]), width)


def _make_label(label: Label, place: float, axis: float, side: Side) -> Text:
    text, exponent = label
    if side == "below":
        return Text("tick", text, place, axis + BESIDE_AXIS + ASCENT * FONT, exponent=exponent)
    base = place + _HALF_DIGIT
    if side == "right":
        return Text("tick", text, axis + BESIDE_AXIS, base, "start", exponent=exponent)
    return Text("tick", text, axis - BESIDE_AXIS, base, "end", exponent=exponent)


def measure_note(ticks: Ticks) -> float:
    """Return how much room what all labels share needs above an axis."""
    return _NOTE_HEIGHT if ticks.note else 0.0


def draw_note_above(ticks: Ticks, x: float, y: float) -> list[Shape]:
    """Write what all labels share above an axis that begins at (x, y)."""
    return [Text("note", ticks.note, x, y - _NOTE_GAP, "start")] if ticks.note else []


def draw_note_below(ticks: Ticks, x: float, y: float) -> list[Shape]:
    """Write what all labels share below an axis that ends at x; `y` is the label's baseline."""
    return [Text("note", ticks.note, x, y, "end")] if ticks.note else []
