"""Draw a plot into an image with OpenCV, where Matplotlib is not: for posters of explorers.

OpenCV has one thin font with the letters of ASCII; SVG has better ones, but nothing here could
turn it into pixels.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils._drawing.plot_layout import lay_out_plot
from labutils._drawing.shapes import Dot, Stroke, Text
from labutils._drawing.style import MINUS, TIMES
from labutils._drawing.text_widths import EXPONENT_RISE, EXPONENT_SIZE

if TYPE_CHECKING:
    from labutils._drawing.parts import Plot
    from labutils._drawing.shapes import Shape

_FINER = 2  # drawn at so many pixels per page pixel, and averaged
_SHIFT = 4  # OpenCV's coordinates have so many bits after the point
_FONT = cv2.FONT_HERSHEY_SIMPLEX
_CAPITAL = 21  # height of a capital letter of this font at scale 1, in pixels
_CAPITAL_SHARE = 0.73  # of a font size, in the fonts of SVG
_ASCII = str.maketrans({MINUS: "-", TIMES: "x", "°": " deg", "µ": "u"})
_THICK = 2  # of letters, in pixels of the finer drawing
#: Share of a text that stands before its place.
_BEFORE = {"start": 0.0, "middle": 0.5, "end": 1.0}


def draw_on_white(plot: Plot) -> np.ndarray:
    """Draw a plot: uint8 RGB, one pixel per page pixel."""
    drawing = lay_out_plot(plot)
    width, height = round(drawing.width), round(drawing.height)
    canvas = np.full((_FINER * height, _FINER * width, 3), 255, np.uint8)
    for shape in drawing.shapes:
        _draw(canvas, shape)
    return cv2.resize(canvas, (width, height), interpolation=cv2.INTER_AREA)


def _draw(canvas: np.ndarray, shape: Shape) -> None:
    if isinstance(shape, Text):
        _draw_text(canvas, shape)
    elif isinstance(shape, Stroke):
        _draw_stroke(canvas, shape)
    elif isinstance(shape, Dot):  # a plot has no pictures
        center = _to_fixed(np.array([shape.x, shape.y]))
        radius = int(_to_fixed(np.array(shape.radius)))
        color = _read_color(shape.color)
        cv2.circle(canvas, tuple(center.tolist()), radius, color, -1, cv2.LINE_AA, _SHIFT)


def _to_fixed(page: np.ndarray) -> np.ndarray:
    return np.round(page * _FINER * 2**_SHIFT).astype(np.int32)


def _read_color(color: str) -> tuple[int, int, int]:
    red, green, blue = bytes.fromhex(color.removeprefix("#"))
    return red, green, blue


def _draw_stroke(canvas: np.ndarray, stroke: Stroke) -> None:
    thick = max(1, round(stroke.width * _FINER))
    color = _read_color(stroke.color)
    drawn = canvas if stroke.inside is None else canvas.copy()
    gaps = np.flatnonzero(~np.isfinite(stroke.points).all(axis=1))
    for piece in np.split(stroke.points, gaps):
        points = _to_fixed(piece[np.isfinite(piece).all(axis=1)])
        cv2.polylines(drawn, [points], False, color, thick, cv2.LINE_AA, _SHIFT)  # noqa: FBT003
    if stroke.inside is not None:
        left, top, width, height = (round(_FINER * length) for length in stroke.inside)
        inside = np.s_[top : top + height, left : left + width]
        canvas[inside] = drawn[inside]


def _draw_text(canvas: np.ndarray, text: Text) -> None:
    place = np.array([text.x, text.y]) * _FINER
    if not text.is_turned:
        _put_text(canvas, text, place)
        return
    turned = cv2.rotate(canvas, cv2.ROTATE_90_CLOCKWISE)
    _put_text(turned, text, np.array([canvas.shape[0] - place[1], place[0]]))
    canvas[:] = cv2.rotate(turned, cv2.ROTATE_90_COUNTERCLOCKWISE)


def _put_text(canvas: np.ndarray, text: Text, place: np.ndarray) -> None:
    """Write a text and its exponent from left to right."""
    scale = text.size * _FINER * _CAPITAL_SHARE / _CAPITAL
    rise = np.array([0.0, -EXPONENT_RISE * text.size * _FINER])
    parts = [
        (text.text.translate(_ASCII), scale, np.zeros(2)),
        (text.exponent.translate(_ASCII), scale * EXPONENT_SIZE, rise),
    ]
    widths = [cv2.getTextSize(part, _FONT, size, _THICK)[0][0] for part, size, _ in parts]
    x, y = place - np.array([_BEFORE[text.anchor] * sum(widths), 0.0])
    color = _read_color(text.color)
    for (part, size, shift), width in zip(parts, widths, strict=True):
        at = (round(x + shift[0]), round(y + shift[1]))
        cv2.putText(canvas, part, at, _FONT, size, color, _THICK, cv2.LINE_AA)
        x += width
