"""The one style of all figures, and the object that carries a finished one."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import cv2
import matplotlib as mpl
import numpy as np
from cycler import cycler
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from collections.abc import Mapping
    from contextlib import AbstractContextManager

    from matplotlib.axes import Axes
    from matplotlib.lines import Line2D

#: Okabe-Ito: eight colors that stay apart for every kind of color vision.
CATEGORY_COLORS = (
    "#0072B2",
    "#E69F00",
    "#009E73",
    "#D55E00",
    "#56B4E9",
    "#CC79A7",
    "#F0E442",
    "#8A8A8A",
)

#: Mid gray: contrast above 4:1 on the book's paper and on its dark ground. No color reaches 4.5:1
#: on both; figures ask for 3:1.
_INK = "#767b85"

WIDTHS = {"full": 7.2, "half": 3.6}  # inches; the text column is 7.2 inches at 100 px per inch
_LABEL_GAP_PT = 13.0  # between the middles of two labels, one above the other
_DPI = 200  # two device pixels per page pixel

_STYLE: dict[str, Any] = {
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "savefig.facecolor": "none",
    "text.color": _INK,
    "axes.labelcolor": _INK,
    "axes.edgecolor": _INK,
    "axes.titlecolor": _INK,
    "xtick.color": _INK,
    "ytick.color": _INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 12,
    "font.size": 11,  # on a phone a figure is half as wide
    "axes.prop_cycle": cycler(color=CATEGORY_COLORS),
    "image.interpolation": "nearest",
    "legend.frameon": False,
    # A fixed salt makes the ids in SVG files, and so the built book, the same in every run.
    "svg.hashsalt": "labutils",
}


class Picture:
    """A finished figure that a notebook, a page and a test can use.

    Parameters
    ----------
    png : bytes
        The picture, two device pixels per page pixel.
    summary : str
        What it shows, in words: shown where no picture can be.
    """

    def __init__(self, png: bytes, summary: str) -> None:
        self.png = png
        self.summary = summary

    @classmethod
    def from_figure(cls, figure: Figure, summary: str) -> Picture:
        """Draw a Matplotlib figure; the same figure gives the same bytes."""
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=_DPI, metadata={"Software": None})
        return cls(buffer.getvalue(), summary)

    @classmethod
    def from_rgb(cls, image: np.ndarray, summary: str) -> Picture:
        """Wrap a uint8 image (H, W, 3) or (H, W, 4)."""
        code = cv2.COLOR_RGBA2BGRA if image.shape[2] == 4 else cv2.COLOR_RGB2BGR
        done, png = cv2.imencode(".png", cv2.cvtColor(image, code))
        if not done:
            raise ValueError(f"image: expected a picture that PNG can hold, got {image.shape}")
        return cls(png.tobytes(), summary)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in device pixels, read from the PNG header."""
        return (int.from_bytes(self.png[16:20], "big"), int.from_bytes(self.png[20:24], "big"))

    def _repr_mimebundle_(self, **_: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        width = min(self.size[0] // 2, 720)
        return {"image/png": self.png, "text/plain": repr(self)}, {"image/png": {"width": width}}

    def __repr__(self) -> str:
        return f"<Picture {self.size[0]}x{self.size[1]}: {self.summary}>"


def use_style() -> AbstractContextManager[None]:
    """Draw in the book's style inside a ``with`` block."""
    return mpl.rc_context(_STYLE)  # type: ignore[arg-type]  # stubs want literal keys


def make_axes(columns: int, width: str, height: float, **options: Any) -> tuple[Figure, list[Any]]:
    """Make a figure with a row of axes; `height` is in inches."""
    figure = Figure(figsize=(WIDTHS[width], height), layout="constrained")
    axes = list(figure.subplots(1, columns, squeeze=False, **options)[0])
    return figure, axes


def label_ends(ax: Axes, lines: Mapping[str, Line2D]) -> None:
    """Write the name of each line beside its last point, in its color.

    Parameters
    ----------
    ax : Axes
        With its limits and scales set: where labels would overlap depends on them.
    lines : mapping of str to Line2D
        Name to line.
    """
    ends = []
    for line in lines.values():
        x, y = (np.asarray(values) for values in line.get_data())
        last = np.flatnonzero(np.isfinite(y))[-1]
        ends.append((x[last], y[last]))
    heights_pt = ax.transData.transform(np.array(ends))[:, 1] * 72 / ax.figure.get_dpi()
    shifts_pt = spread_labels(heights_pt, _LABEL_GAP_PT) - heights_pt
    for (name, line), end, shift_pt in zip(lines.items(), ends, shifts_pt, strict=True):
        ax.annotate(
            name,
            end,
            xytext=(6, shift_pt),
            textcoords="offset points",
            va="center",
            color=line.get_color(),
        )


def spread_labels(heights: np.ndarray, gap: float) -> np.ndarray:
    """Move labels apart, as little as it takes to keep their order and a gap.

    Parameters
    ----------
    heights : ndarray, shape (N,)
        Where the labels would stand.
    gap : float
        Least distance between two, in the same unit.

    Returns
    -------
    ndarray, shape (N,)
        Where they may stand; the middle of all of them stays.
    """
    order = np.argsort(heights, kind="stable")
    steps = gap * np.arange(len(heights))
    spread = np.empty(len(heights))
    spread[order] = np.maximum.accumulate(heights[order] - steps) + steps
    return spread + heights.mean() - spread.mean()
