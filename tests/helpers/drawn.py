"""Read a drawn figure back, from SVG or from Matplotlib, in the same words: for comparison."""

from __future__ import annotations

import base64
import io
import re
from dataclasses import dataclass, field
from typing import Any
from xml.etree import ElementTree as ET

import cv2
import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_hex

from labutils._drawing import as_svg, with_matplotlib
from labutils._drawing.axis_shapes import FONT
from labutils._drawing.parts import Plot, Sheet

NAMESPACE = "{http://www.w3.org/2000/svg}"
_DPI = 200
#: From the middle of a number down to its baseline, as a share of the font size.
_HALF_DIGIT = 0.365

Tick = tuple[str, float]


@dataclass
class Curve:
    """A line: its color, and its points as shares of the axes from the lower left corner."""

    color: str
    shares: np.ndarray


@dataclass
class Picture:
    """Pixels (RGBA), and the rectangle they fill: x, y, width, height as shares of the figure."""

    box: np.ndarray
    rgba: np.ndarray

    def sample(self, rows: int, columns: int) -> np.ndarray:
        """Return the colors in the middles of so many rows and columns."""
        v = ((np.arange(rows) + 0.5) * self.rgba.shape[0] / rows).astype(int)
        u = ((np.arange(columns) + 0.5) * self.rgba.shape[1] / columns).astype(int)
        return self.rgba[v[:, None], u]


@dataclass
class Drawn:
    """What a figure shows, whatever drew it."""

    size: tuple[float, float]
    titles: list[str] = field(default_factory=list)
    labels: list[str] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    ticks: list[str] = field(default_factory=list)
    axes: np.ndarray | None = None
    x_ticks: list[Tick] = field(default_factory=list)
    y_ticks: list[Tick] = field(default_factory=list)
    curves: list[Curve] = field(default_factory=list)
    pictures: list[Picture] = field(default_factory=list)


def read_svg(part: Plot | Sheet) -> Drawn:
    """Draw as SVG and read what it shows."""
    root = ET.fromstring(as_svg.draw(part).svg)  # noqa: S314 - our own text
    width, height = (float(x) for x in root.attrib["viewBox"].split()[2:])
    found = Drawn((width, height))
    texts = {
        name: [node for node in root.iter(f"{NAMESPACE}text") if node.get("data-part") == name]
        for name in ("title", "label", "name", "note", "tick")
    }
    found.labels = sorted(_read_text(node) for node in texts["label"])
    found.names = [_read_text(node) for node in texts["name"]]
    found.notes = sorted(_read_text(node) for node in texts["note"])
    found.ticks = sorted(_read_text(node) for node in texts["tick"])
    titles = [_read_text(node) for node in texts["title"]]
    # lines of one title come from below to above
    found.titles = [" ".join(reversed(titles))] if isinstance(part, Plot) and titles else titles
    if isinstance(part, Plot):
        _read_axes(found, root, texts["tick"])
    for node in root.iter(f"{NAMESPACE}image"):
        if node.get("data-part") == "picture":
            found.pictures.append(_read_image(node, width, height))
    return found


def _read_text(node: ET.Element) -> str:
    exponents = "".join(f"^{child.text}" for child in node)
    return f"{node.text}{exponents}"


def _read_path(node: ET.Element) -> np.ndarray:
    return np.array(re.findall(r"[ML](\S+) ([^ML]+)", node.attrib["d"]), float)


def _read_axes(found: Drawn, root: ET.Element, ticks: list[ET.Element]) -> None:
    paths = list(root.iter(f"{NAMESPACE}path"))
    frame = _read_path(next(node for node in paths if node.get("data-part") == "axis"))
    (left, top), (_, bottom), (right, _) = frame
    size = np.array([right - left, bottom - top])
    found.axes = np.array([left, top, *size]) / np.tile(found.size, 2)
    for node in paths:
        if node.get("data-part") == "curve":
            shares = (_read_path(node) - [left, bottom]) / size * [1, -1]
            found.curves.append(Curve(node.attrib["stroke"].lower(), shares))
    for node in ticks:
        x, y = float(node.attrib["x"]), float(node.attrib["y"]) - _HALF_DIGIT * FONT
        if node.get("text-anchor") == "middle":
            found.x_ticks.append((_read_text(node), (x - left) / size[0]))
        else:
            found.y_ticks.append((_read_text(node), (bottom - y) / size[1]))


def _read_image(node: ET.Element, width: float, height: float) -> Picture:
    box = np.array([float(node.attrib[name]) for name in ("x", "y", "width", "height")])
    png = base64.b64decode(node.attrib["href"].partition(",")[2])
    return Picture(box / [width, height, width, height], decode_rgba(png))


def decode_rgba(png: bytes) -> np.ndarray:
    """Read a PNG as RGBA."""
    image = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_UNCHANGED)
    assert image is not None
    code = cv2.COLOR_BGRA2RGBA if image.shape[2] == 4 else cv2.COLOR_BGR2RGBA
    return cv2.cvtColor(image, code)


def read_matplotlib(part: Plot | Sheet) -> Drawn:
    """Draw with Matplotlib and read what it shows."""
    # Inside the style: ticks are chosen again when one asks for them.
    with mpl.rc_context(with_matplotlib._STYLE):  # type: ignore[arg-type]  # wants literal keys
        figure = (
            with_matplotlib.make_plot(part)
            if isinstance(part, Plot)
            else with_matplotlib.make_sheet(part)
        )
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=_DPI)
        found = Drawn((100 * part.width, 100 * part.height))
        for ax in figure.axes:
            _read_mpl_axes(found, ax, decode_rgba(buffer.getvalue()))
    for words in (found.labels, found.notes, found.ticks):
        words.sort()
    return found


def _read_mpl_axes(found: Drawn, ax: Axes, canvas: np.ndarray) -> None:
    if ax.get_title():
        found.titles.append(ax.get_title())
    if ax.axison:
        for axis, places in ((ax.xaxis, found.x_ticks), (ax.yaxis, found.y_ticks)):
            found.labels += [axis.label.get_text()] * bool(axis.label.get_text())
            note = axis.get_offset_text().get_text()
            found.notes += [note] * bool(note)
            shown = _read_mpl_ticks(ax, axis)
            found.ticks += [text for text, _ in shown]
            places.extend(shown)
    box = ax.get_position()
    place = np.array([box.x0, 1 - box.y1, box.width, box.height])
    if ax.lines or ax.patches:
        found.axes = place
        _read_mpl_curves(found, ax)
    if ax.images:
        x, y, w, h = (place * np.tile(canvas.shape[1::-1], 2)).tolist()
        pixels = canvas[round(y) : round(y + h), round(x) : round(x + w)]
        found.pictures.append(Picture(place, pixels))


def _read_mpl_ticks(ax: Axes, axis: Any) -> list[Tick]:
    """Return labels inside the limits, and where they stand as shares of the axis."""
    low, high = sorted(axis.get_view_interval())
    shown = []
    for is_minor in (False, True):
        locations = axis.get_ticklocs(minor=is_minor)
        for text, at in zip(axis.get_ticklabels(minor=is_minor), locations, strict=True):
            if text.get_text() and low <= at <= high:
                point = (at, ax.get_ylim()[0]) if axis is ax.xaxis else (ax.get_xlim()[0], at)
                share = ax.transAxes.inverted().transform(ax.transData.transform(point))
                shown.append((strip_math(text.get_text()), share[int(axis is ax.yaxis)]))
    return shown


def strip_math(text: str) -> str:
    """Write a label of Matplotlib as plain text: a caret before an exponent."""
    for mark, plain in (("\\mathdefault", ""), ("\\times", "\N{MULTIPLICATION SIGN}")):
        text = text.replace(mark, plain)
    if text.startswith("$"):
        text = text.replace("-", "\N{MINUS SIGN}")
    return re.sub(r"[${}]", "", text)


def _read_mpl_curves(found: Drawn, ax: Axes) -> None:
    to_shares = ax.transData - ax.transAxes
    lines = [line for line in ax.lines if line.get_linestyle() != "None"]
    for line in lines:
        points = to_shares.transform(np.array(line.get_data(), float).T)
        found.curves.append(Curve(to_hex(line.get_color()), points))
    for patch in ax.patches:
        points = to_shares.transform(np.asarray(patch.get_path().vertices))
        found.curves.append(Curve(to_hex(patch.get_edgecolor()), points))
    legend = ax.get_legend()
    named = legend.get_texts() if legend else ax.texts
    found.names = [text.get_text() for text in named]
