"""Place the pictures, titles and color bars of a sheet, as Matplotlib's constrained layout does."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing import color_bar
from labutils._drawing.axis_shapes import PAD, TITLE_FONT, TITLE_GAP, TITLE_HEIGHT
from labutils._drawing.color_maps import paint, to_bytes
from labutils._drawing.shapes import Bitmap, Box, Drawing, Shape, Text
from labutils._drawing.style import BAR_GAP, PIXELS_PER_INCH

if TYPE_CHECKING:
    from labutils._drawing.parts import ColorBar, Panel, Sheet


def lay_out_sheet(sheet: Sheet) -> Drawing:
    """Place everything that a sheet shows."""
    width, height = sheet.width * PIXELS_PER_INCH, sheet.height * PIXELS_PER_INCH
    drawing = Drawing(width, height)
    if sheet.bars and sheet.bars[0].side == "right":
        drawing.shapes.extend(_draw_beside_bar(sheet.panels[0], sheet.bars[0], width, height))
        return drawing
    boxes = _place_in_rows(sheet, width, height)
    for panel, box in zip(sheet.panels, boxes, strict=True):
        drawing.shapes.extend(_draw_panel(panel, box))
    for bar in sheet.bars:
        above = [boxes[place] for place in bar.panels]
        panel = sheet.panels[bar.panels[0]]
        drawing.shapes.extend(color_bar.draw_below(bar, panel, above, height))
    return drawing


def _place_in_rows(sheet: Sheet, width: float, height: float) -> list[Box]:
    """Give every picture its cell; it keeps its proportions and stands in the middle."""
    starts, cell = _place_columns(sheet, width)
    row_height = height / sheet.rows
    title = TITLE_HEIGHT if any(panel.title for panel in sheet.panels) else 0.0
    below = max((color_bar.measure_below(bar, cell) for bar in sheet.bars), default=PAD)
    sizes = [_fit(panel, cell, row_height - PAD - title - below) for panel in sheet.panels]
    tallest = max(tall for _, tall in sizes)
    # Color bars are at the lower edge, and the pictures stand on them.
    start = row_height - below - tallest if sheet.bars else PAD + title
    boxes = []
    for number, (wide, tall) in enumerate(sizes):
        row, column = divmod(number, sheet.columns)
        x = starts[column] + (cell - wide) / 2
        boxes.append(Box(x, row * row_height + start + (tallest - tall) / 2, wide, tall))
    return boxes


def _place_columns(sheet: Sheet, width: float) -> tuple[np.ndarray, float]:
    """Return the left edges of all columns and their width; labels of color bars need room too."""
    cell = width / sheet.columns - 2 * PAD
    before, after = np.zeros(sheet.columns), np.zeros(sheet.columns)
    for bar in sheet.bars:
        left, right = color_bar.measure_beyond(bar, sheet.panels[bar.panels[0]], cell)
        before[bar.panels[0]] = max(left, 0)
        after[bar.panels[-1]] = max(right, 0)
    cell -= (before + after).sum() / sheet.columns
    ends = np.cumsum(PAD + before + cell + after + PAD)
    return ends - PAD - after - cell, cell


def _draw_beside_bar(panel: Panel, bar: ColorBar, width: float, height: float) -> list[Shape]:
    """Draw one picture, and its color bar on the right."""
    title = TITLE_HEIGHT if panel.title else 0.0
    strip = color_bar.place_beside(bar, panel, width, height)
    free = (strip.x - PAD) / (1 + BAR_GAP)
    wide, tall = _fit(panel, free, height - 2 * PAD - title)
    y = max(strip.y + (strip.height - tall) / 2, PAD + title)
    picture = Box(PAD + (free - wide) / 2, y, wide, tall)
    return [*_draw_panel(panel, picture), *color_bar.draw_beside(bar, panel, strip)]


def _fit(panel: Panel, width: float, height: float) -> tuple[float, float]:
    """Return the largest size that has the proportions of a picture."""
    rows, columns = panel.pixels.shape[:2]
    scale = min(width / columns, height / rows)
    return columns * scale, rows * scale


def _draw_panel(panel: Panel, box: Box) -> list[Shape]:
    if panel.pixels.ndim == 2:
        pixels = paint(panel.pixels, panel.color_map, panel.limits)
    else:
        pixels = to_bytes(panel.pixels)
    middle = box.x + box.width / 2
    title = Text("title", panel.title, middle, box.y - TITLE_GAP, size=TITLE_FONT)
    return [Bitmap("picture", box, pixels), *([title] if panel.title else [])]
