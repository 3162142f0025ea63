"""A legend, where it hides least of the curves: by Matplotlib's rule for the best place."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing.axis_shapes import ASCENT, FONT, LINE
from labutils._drawing.shapes import Box, Shape, Stroke, Text
from labutils._drawing.text_widths import measure

if TYPE_CHECKING:
    from labutils._drawing.parts import Plot

# In font sizes, as Matplotlib's.
_BORDER = 0.4 * FONT
_OUTSIDE = 0.5 * FONT  # from the legend to the axes around it
_HANDLE = 2.0 * FONT
_HANDLE_HEIGHT = 0.7 * FONT
_HANDLE_GAP = 0.8 * FONT
_ROW_GAP = 0.5 * FONT

#: Shares of the free room left of, and above, the legend; the first is tried first.
_PLACES = (
    (1, 0),
    (0, 0),
    (0, 1),
    (1, 1),
    (1, 0.5),
    (0, 0.5),
    (1, 0.5),
    (0.5, 1),
    (0.5, 0),
    (0.5, 0.5),
)


def draw_legend(
    plot: Plot, axes: Box, paths: list[np.ndarray], colors: list[str], width: float
) -> list[Shape]:
    """Draw the names of all curves beside samples of their lines.

    Parameters
    ----------
    plot : Plot
        Its curves have the names.
    axes : Box
        The legend is inside.
    paths : list of ndarray, shape (N, 2)
        What it should not hide.
    colors : list of str
        Of the curves.
    width : float
        Of the lines.
    """
    names = [curve.name for curve in plot.curves]
    box = _choose_place(_measure_legend(names), axes, paths)
    shapes: list[Shape] = []
    for row, (curve, color) in enumerate(zip(plot.curves, colors, strict=True)):
        base = box.y + _BORDER + row * (LINE + _ROW_GAP) + ASCENT * FONT
        x = box.x + _BORDER
        sample = _make_sample(x, base, is_outline=curve.steps)
        shapes.append(Stroke("name", sample, width, color))
        shapes.append(Text("name", curve.name, x + _HANDLE + _HANDLE_GAP, base, "start"))
    return shapes


def _measure_legend(names: list[str]) -> tuple[float, float]:
    widest = max(measure(name, FONT) for name in names)
    width = 2 * _BORDER + _HANDLE + _HANDLE_GAP + widest
    return width, 2 * _BORDER + len(names) * LINE + (len(names) - 1) * _ROW_GAP


def _make_sample(x: float, base: float, *, is_outline: bool) -> np.ndarray:
    """Make a piece of a line, or the outline of a bar, on the baseline of a name."""
    top = base - _HANDLE_HEIGHT
    if is_outline:
        right = x + _HANDLE
        return np.array([(x, base), (x, top), (right, top), (right, base), (x, base)])
    middle = (base + top) / 2
    return np.array([(x, middle), (x + _HANDLE, middle)])


def _choose_place(size: tuple[float, float], axes: Box, paths: list[np.ndarray]) -> Box:
    """Return the first of the places that hide least."""
    width, height = size
    free_x, free_y = axes.width - 2 * _OUTSIDE - width, axes.height - 2 * _OUTSIDE - height
    x, y = axes.x + _OUTSIDE, axes.y + _OUTSIDE
    boxes = [Box(x + free_x * right, y + free_y * down, width, height) for right, down in _PLACES]
    return min(boxes, key=lambda box: sum(_count_hidden(path, box) for path in paths))


def _count_hidden(path: np.ndarray, box: Box) -> int:
    """Count the points of a path inside a box, and one more if the path enters it."""
    low, high = np.array([box.x, box.y]), np.array([box.right, box.bottom])
    inside = int(((path > low) & (path < high)).all(axis=1).sum())
    return inside + int(_enters(path, low, high))


def _enters(path: np.ndarray, low: np.ndarray, high: np.ndarray) -> bool:
    """Tell whether any piece of a path has a point in the box: by the slabs of its two axes."""
    start, way = path[:-1], np.diff(path, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        near, far = (low - start) / way, (high - start) / way
    still = way == 0  # along an axis: in its slab from start to end, or never
    in_slab = (start > low) & (start < high)
    first = np.where(still, np.where(in_slab, 0, np.inf), np.minimum(near, far))
    last = np.where(still, np.where(in_slab, 1, -np.inf), np.maximum(near, far))
    enter = np.maximum(first.max(axis=1), 0)
    return bool((enter <= np.minimum(last.min(axis=1), 1)).any())
