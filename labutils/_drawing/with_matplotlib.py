"""Draw a figure with Matplotlib: a PNG, the same bytes every time."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import cv2
import matplotlib as mpl
import numpy as np
from cycler import cycler
from matplotlib.figure import Figure

from labutils._drawing import style
from labutils._drawing.end_labels import find_ends, find_shifts
from labutils._drawing.parts import Plot, Sheet
from labutils._picture import Picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.image import AxesImage

    from labutils._drawing.parts import ColorBar, Curve

_DPI = 200  # two device pixels per page pixel

_STYLE: dict[str, Any] = {
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "savefig.facecolor": "none",
    "text.color": style.INK,
    "axes.labelcolor": style.INK,
    "axes.edgecolor": style.INK,
    "axes.titlecolor": style.INK,
    "xtick.color": style.INK,
    "ytick.color": style.INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": style.TITLE_SIZE,
    "font.size": style.FONT_SIZE,
    "axes.prop_cycle": cycler(color=style.CATEGORY_COLORS),
    "image.interpolation": "nearest",
    "legend.frameon": False,
}


def draw(figure: Plot | Sheet) -> Picture:
    """Draw a figure; the same figure gives the same bytes."""
    return Picture(_draw_png(figure), figure.summary)


def draw_on_white(plot: Plot) -> np.ndarray:
    """Draw a plot: uint8 RGB, one pixel per page pixel."""
    png = np.frombuffer(_draw_png(plot), np.uint8)
    bgra = np.asarray(cv2.imdecode(png, cv2.IMREAD_UNCHANGED))
    alpha = bgra[..., 3:] / 255
    on_white = bgra[..., 2::-1] * alpha + 255 * (1 - alpha)
    size = (bgra.shape[1] // 2, bgra.shape[0] // 2)
    return cv2.resize(on_white.round().astype(np.uint8), size, interpolation=cv2.INTER_AREA)


def _draw_png(figure: Plot | Sheet) -> bytes:
    with mpl.rc_context(_STYLE):  # type: ignore[arg-type]  # stubs want literal keys
        drawn = make_sheet(figure) if isinstance(figure, Sheet) else make_plot(figure)
        buffer = io.BytesIO()
        drawn.savefig(buffer, format="png", dpi=_DPI, metadata={"Software": None})
    return buffer.getvalue()


def make_sheet(sheet: Sheet) -> Figure:
    """Lay pictures and color bars out."""
    figure = Figure(figsize=(sheet.width, sheet.height), layout="constrained")
    axes = list(figure.subplots(sheet.rows, sheet.columns, squeeze=False).ravel())
    for ax in axes:
        ax.set_axis_off()
    images = []
    for ax, panel in zip(axes, sheet.panels, strict=False):  # the last row may have room left
        ax.set_title(panel.title)
        low, high = panel.limits or (None, None)
        images.append(ax.imshow(panel.pixels, cmap=panel.color_map, vmin=low, vmax=high))
    for bar in sheet.bars:
        _add_bar(figure, bar, images, axes)
    return figure


def _add_bar(figure: Figure, bar: ColorBar, images: list[AxesImage], axes: list[Axes]) -> None:
    beside = [axes[place] for place in bar.panels]
    gap: dict[str, Any] = {"pad": style.BAR_GAP} if bar.side == "right" else {}
    figure.colorbar(
        images[bar.panels[-1]],
        ax=beside if len(beside) > 1 else beside[0],
        label=bar.label,
        location=bar.side,
        aspect=bar.aspect,
        **gap,
    )


def make_plot(plot: Plot) -> Figure:
    """Draw curves, axes and names."""
    figure = Figure(figsize=(plot.width, plot.height), layout="constrained")
    ax = figure.subplots()
    colors = [_add_curve(ax, curve, plot.line_width) for curve in plot.curves]
    if plot.point:
        ax.plot(*plot.point, "o")
    ax.set_xlabel(plot.x.label)
    ax.set_ylabel(plot.y.label)
    ax.set_title(plot.title, wrap=True)
    ax.set_xscale("log" if plot.x.log else "linear")
    ax.set_yscale("log" if plot.y.log else "linear")
    ax.set_xlim(*plot.x.limits)
    ax.set_ylim(*plot.y.limits)
    if plot.naming == "legend":
        ax.legend()
    elif plot.naming == "ends":
        _label_ends(ax, plot, colors)
    return figure


def _add_curve(ax: Axes, curve: Curve, line_width: float) -> Any:
    """Draw a curve in the next color of the cycle; return the color."""
    if not curve.steps:
        return ax.plot(curve.x, curve.y, lw=line_width, label=curve.name)[0].get_color()
    _, _, patches = ax.hist(
        curve.x[:-1],
        bins=curve.x,  # type: ignore[arg-type]  # stubs want a list
        weights=curve.y,
        histtype="step",
        label=curve.name,
        lw=line_width,
    )
    return patches[0].get_edgecolor()  # type: ignore[index,union-attr]  # of `step`, a list


def _label_ends(ax: Axes, plot: Plot, colors: list[Any]) -> None:
    """Write the name of each curve beside its last point, in its color."""
    rows = zip(plot.curves, find_ends(plot), find_shifts(plot), colors, strict=True)
    for curve, end, shift, color in rows:
        ax.annotate(
            curve.name,
            end,
            xytext=(style.END_LABEL_SHIFT, shift),
            textcoords="offset points",
            va="center",
            color=color,
        )
