"""Write a figure as SVG, in place of Matplotlib: text, lines, and PNGs of its pictures."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from labutils._drawing.parts import Plot, Sheet
from labutils._drawing.plot_layout import lay_out_plot
from labutils._drawing.shapes import Bitmap, Stroke, Text
from labutils._drawing.sheet_layout import lay_out_sheet
from labutils._drawing.text_widths import EXPONENT_RISE, EXPONENT_SIZE, FONT_FAMILY
from labutils._picture import SvgPicture, encode_png

if TYPE_CHECKING:
    from labutils._drawing.shapes import Box, Drawing, Shape

_DEVICE_PIXELS = 2  # per page pixel: more pixels of a picture than these are never seen
_ENLARGED = 1.5  # page pixels per pixel of a picture


def draw(figure: Plot | Sheet) -> SvgPicture:
    """Draw a figure; the same figure gives the same text."""
    drawing = lay_out_sheet(figure) if isinstance(figure, Sheet) else lay_out_plot(figure)
    size = (drawing.width, drawing.height)
    return SvgPicture(write_svg(drawing, figure.summary), size, figure.summary)


def write_svg(drawing: Drawing, summary: str) -> str:
    """Write shapes as SVG that grows no wider than its page, and that a screen reader names.

    It has no ids: two figures on one page cannot mix theirs up.
    """
    width, height = _write_number(drawing.width), _write_number(drawing.height)
    name = quoteattr(summary)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label={name} '
        f'width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        f'style="max-width:100%;height:auto" font-family="{FONT_FAMILY}">'
    )
    return "\n".join([head, *(_write(shape) for shape in drawing.shapes), "</svg>"])


def _write(shape: Shape) -> str:
    if isinstance(shape, Text):
        return _write_text(shape)
    if isinstance(shape, Stroke):
        return _write_stroke(shape)
    if isinstance(shape, Bitmap):
        return _write_bitmap(shape)
    return (
        f'<circle data-part="{shape.part}" fill="{shape.color}" '
        f"{_write_numbers(cx=shape.x, cy=shape.y, r=shape.radius)}/>"
    )


def _write_text(text: Text) -> str:
    place = _write_numbers(x=text.x, y=text.y)
    if text.is_turned:
        turn = " ".join(_write_number(value) for value in (-90, text.x, text.y))
        place += f' transform="rotate({turn})"'
    exponent = ""
    if text.exponent:
        rise = _write_number(-EXPONENT_RISE * text.size)
        size = _write_number(EXPONENT_SIZE * text.size)
        exponent = f'<tspan dy="{rise}" font-size="{size}">{escape(text.exponent)}</tspan>'
    return (
        f'<text data-part="{text.part}" {place} text-anchor="{text.anchor}" fill="{text.color}" '
        f'font-size="{_write_number(text.size)}">{escape(text.text)}{exponent}</text>'
    )


def _write_stroke(stroke: Stroke) -> str:
    path = (
        f'<path data-part="{stroke.part}" fill="none" stroke="{stroke.color}" '
        f'stroke-width="{_write_number(stroke.width)}" stroke-linejoin="round" '
        f'd="{_write_path(stroke.points)}"/>'
    )
    if stroke.inside is None:
        return path
    # A drawing in the drawing cuts off what is outside; a clip path would need an id.
    view = " ".join(map(_write_number, stroke.inside))
    return f'<svg {_write_box(stroke.inside)} viewBox="{view}">{path}</svg>'


def _write_path(points: np.ndarray) -> str:
    """Write straight lines through points; each gap starts a line of its own."""
    steps = []
    command = "M"
    for x, y in points.tolist():
        if not (np.isfinite(x) and np.isfinite(y)):
            command = "M"
            continue
        steps.append(f"{command}{_write_number(x)} {_write_number(y)}")
        command = "L"
    return "".join(steps)


def _write_bitmap(bitmap: Bitmap) -> str:
    box = bitmap.box
    pixels = shrink(bitmap.pixels, _DEVICE_PIXELS * box.width, _DEVICE_PIXELS * box.height)
    content = base64.b64encode(encode_png(pixels)).decode("ascii")
    # Enlarged pixels stay squares. Near the size of the page, squares would differ in size.
    is_enlarged = box.width * box.height > _ENLARGED**2 * pixels[..., 0].size
    rendering = ' style="image-rendering:pixelated"' if is_enlarged else ""
    return (
        f'<image data-part="{bitmap.part}" {_write_box(box)} '
        f'preserveAspectRatio="none"{rendering} href="data:image/png;base64,{content}"/>'
    )


def shrink(pixels: np.ndarray, width: float, height: float) -> np.ndarray:
    """Leave out rows and columns of a picture that is larger than a size."""
    rows, columns = (
        _choose_places(have, round(want))
        for have, want in zip(pixels.shape, (height, width), strict=False)
    )
    return np.ascontiguousarray(pixels[rows][:, columns])


def _choose_places(have: int, want: int) -> np.ndarray:
    """Choose at most so many evenly spaced places."""
    count = max(1, min(have, want))
    return ((np.arange(count) + 0.5) * have / count).astype(int)


def _write_number(value: float) -> str:
    """Write a length with two decimals at most: a hundredth of a pixel."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _write_box(box: Box) -> str:
    return _write_numbers(**box._asdict())


def _write_numbers(**values: float) -> str:
    return " ".join(f'{name}="{_write_number(value)}"' for name, value in values.items())
