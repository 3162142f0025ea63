"""All figures of the book: one style, readable on light and dark pages.

Every function returns a `Picture`, which shows itself as the last line of a cell. The verb
``plot_`` stands for exactly that. Matplotlib draws where it is installed; where it is not, as in
the browser, the same figures are SVG (`labutils._drawing`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._constants import TURN_WORLD
from labutils._drawing import draw
from labutils._drawing.parts import ColorBar, Curve, Panel, Plot, Sheet
from labutils._drawing.scales import Axis, get_color_limits, get_limits, widen
from labutils._drawing.style import CATEGORY_COLORS, WIDTHS
from labutils._guards import check_columns, check_curve, check_depth_image, check_picture
from labutils._picture import Picture
from labutils._splat import (
    get_depth_colors,
    get_view_point,
    make_axes_points,
    make_look_at,
    render_points,
)
from labutils.cameras import intrinsics_matrix

if TYPE_CHECKING:
    from collections.abc import Mapping

#: The camera that draws a cloud: size in pixels, and K with f = 1300.
_CLOUD_SIZE = (1440, 1000)
_CLOUD_K = intrinsics_matrix(2 * np.arctan(500 / 1300), *_CLOUD_SIZE)

__all__ = [
    "CATEGORY_COLORS",
    "Picture",
    "plot_cloud",
    "plot_comparison",
    "plot_depth",
    "plot_histogram",
    "plot_images",
    "plot_lines",
]


def plot_images(
    images: Mapping[str, np.ndarray], *, width: str = "full", columns: int | None = None
) -> Picture:
    """Show pictures side by side.

    Parameters
    ----------
    images : mapping of str to ndarray
        Title to picture: uint8 RGB (H, W, 3), or one channel (H, W) shown in gray (bool and
        uint8 masks as black and white).
    width : "full" or "half"
        Of the text column.
    columns : int, optional
        Pictures per row; all in one row without it.

    Returns
    -------
    Picture

    Raises
    ------
    ValueError
        If there is no picture, or one has another shape.
    """
    if not images:
        raise ValueError("images: expected at least one picture, got none")
    columns = columns or len(images)
    panels = tuple(
        Panel(title, check_picture(f"images[{title!r}]", image)) for title, image in images.items()
    )
    rows, first = -(-len(panels) // columns), panels[0].pixels
    cell = WIDTHS[width] / columns
    height = rows * (cell * first.shape[0] / first.shape[1] + 0.36)
    return draw(Sheet("; ".join(images), WIDTHS[width], height, columns, panels))


def plot_depth(
    depth: np.ndarray,
    *,
    title: str = "",
    limits: tuple[float, float] | None = None,
    unit: str = "m",
    width: str = "full",
) -> Picture:
    """Show a depth image in turbo (blue close, red far) with its color bar.

    Parameters
    ----------
    depth : ndarray, real, shape (H, W)
        NaN and infinite pixels stay empty.
    title : str
        Above the picture.
    limits : (low, high), optional
        Of the color scale; without it the range of the data.
    unit : str
        Written at the color bar.
    width : "full" or "half"
        Of the text column.

    Returns
    -------
    Picture
    """
    depth = check_depth_image("depth", depth)
    shown = np.where(np.isfinite(depth), depth, np.nan)
    panel = Panel(title, shown, "turbo", get_color_limits(shown, limits))
    height = WIDTHS[width] * 0.87 * depth.shape[0] / depth.shape[1] + 0.36
    bar = ColorBar(f"depth ({unit})", (0,), "right")
    return draw(Sheet(title or "depth image", WIDTHS[width], height, 1, (panel,), (bar,)))


def plot_comparison(
    ours: np.ndarray,
    truth: np.ndarray,
    *,
    limits: tuple[float, float] | None = None,
    error_limit_mm: float | None = None,
) -> Picture:
    """Show ours, truth and the signed error of a depth image, the error in millimeters.

    Parameters
    ----------
    ours, truth : ndarray, real, shape (H, W)
        Meters; NaN where there is nothing.
    limits : (low, high), optional
        Shared color scale of the first two pictures, in meters.
    error_limit_mm : float, optional
        Scale of the error picture; without it the 99th percentile of the error.

    Returns
    -------
    Picture
    """
    ours = check_depth_image("ours", ours)
    truth = check_depth_image("truth", truth)
    if ours.shape != truth.shape:
        raise ValueError(f"truth: expected the size of ours {ours.shape}, got {truth.shape}")
    error_mm = 1000.0 * (ours.astype(np.float64) - truth)
    limits = get_color_limits(truth, limits)
    if error_limit_mm is None:
        error_limit_mm = max(1e-6, float(np.nanpercentile(np.abs(error_mm), 99)))
    scale = get_color_limits(error_mm, (-error_limit_mm, error_limit_mm))
    panels = (
        Panel("ours", ours, "turbo", limits),
        Panel("truth", truth, "turbo", limits),
        Panel("error = ours - truth", error_mm, "RdBu_r", scale),
    )
    bars = (ColorBar("m", (0, 1), "bottom", 40), ColorBar("mm", (2,), "bottom"))
    height = WIDTHS["full"] / 3 * ours.shape[0] / ours.shape[1] + 0.95
    return draw(Sheet("ours, truth and error in mm", WIDTHS["full"], height, 3, panels, bars))


def plot_histogram(
    samples: Mapping[str, np.ndarray],
    *,
    label: str,
    bins: int = 60,
    limits: tuple[float, float] | None = None,
    log: bool = False,
) -> Picture:
    """Show how values are distributed, one outlined histogram per sample.

    Parameters
    ----------
    samples : mapping of str to ndarray
        Name to values; NaN and infinite values are left out.
    label : str
        Of the horizontal axis, with its unit.
    bins : int
        Number of bins over `limits`.
    limits : (low, high), optional
        Range of the horizontal axis; without it the range of the data.
    log : bool
        Logarithmic counts.

    Returns
    -------
    Picture
    """
    finite = {name: v[np.isfinite(v)].ravel() for name, v in samples.items()}
    span = widen(*(limits or get_limits(np.concatenate(list(finite.values())), margin=0)))
    counted = {name: np.histogram(values, bins, span) for name, values in finite.items()}
    curves = tuple(Curve(name, x, y, steps=True) for name, (y, x) in counted.items())
    counts = np.concatenate([curve.y for curve in curves])
    count_limits = get_limits(counts, log=True) if log else (0.0, 1.05 * max(counts.max(), 1))
    return draw(
        Plot(
            f"histogram of {', '.join(finite)}",
            WIDTHS["full"],
            2.6,
            curves,
            Axis(label, span),
            Axis("pixels", count_limits, log),
            line_width=1.6,
            naming="legend" if len(finite) > 1 else "none",
        )
    )


def plot_lines(
    x: np.ndarray,
    lines: Mapping[str, np.ndarray],
    *,
    x_label: str,
    y_label: str,
    log_y: bool = False,
) -> Picture:
    """Show one or more curves over a shared axis, each named at its end.

    Parameters
    ----------
    x : ndarray, shape (N,)
        Shared horizontal values.
    lines : mapping of str to ndarray, shape (N,)
        Name to vertical values.
    x_label, y_label : str
        With units.
    log_y : bool
        Logarithmic vertical axis.

    Returns
    -------
    Picture

    Raises
    ------
    ValueError
        If a curve has no finite value.
    """
    x = np.asarray(x)
    curves = tuple(Curve(name, x, check_curve(f"lines[{name!r}]", y)) for name, y in lines.items())
    heights = np.concatenate([curve.y for curve in curves])
    shown = np.concatenate([curve.x[np.isfinite(curve.y)] for curve in curves])
    return draw(
        Plot(
            f"{y_label} over {x_label}: {', '.join(lines)}",
            WIDTHS["full"],
            2.8,
            curves,
            Axis(x_label, get_limits(shown, margin=0.02)),
            Axis(y_label, get_limits(heights, log=log_y), log_y),
            line_width=1.8,
            naming="ends",
        )
    )


def plot_cloud(
    points: np.ndarray,
    colors: np.ndarray | None = None,
    *,
    frame: str = "camera",
    azimuth_deg: float = 25.0,
    elevation_deg: float = 20.0,
    point_size: int = 3,
    axes: bool = True,
) -> Picture:
    """Draw a point cloud from a chosen side, without OpenGL.

    Parameters
    ----------
    points : ndarray, real, shape (N, 3)
        Meters.
    colors : ndarray, real in [0, 1], shape (N, 3), optional
        RGB; without it, by the third coordinate.
    frame : "camera" or "world"
        Which way is up: -y in the OpenCV camera frame, +z in the world.
    azimuth_deg, elevation_deg : float
        Where to look from: 0, 0 is the camera's own direction.
    point_size : int
        In pixels.
    axes : bool
        Draw x (red), y (green), z (blue), 0.2 m long, at the origin of the frame.

    Returns
    -------
    Picture
    """
    points = check_columns("points", points, 3)
    if frame not in {"camera", "world"}:
        raise ValueError(f"frame: expected 'camera' or 'world', got {frame!r}")
    colors = get_depth_colors(points) if colors is None else colors
    turn = np.eye(3) if frame == "camera" else TURN_WORLD
    turned = points @ turn.T
    if axes:
        axes_points, axes_colors = make_axes_points(0.2)
        turned = np.concatenate([turned, axes_points @ turn.T])
        colors = np.concatenate([colors, axes_colors])
    target, eye = get_view_point(points @ turn.T, azimuth_deg, elevation_deg)
    T_cam_world = make_look_at(eye, target, np.array([0.0, -1.0, 0.0]))
    rgba = render_points(turned, colors, T_cam_world, _CLOUD_K, _CLOUD_SIZE, point_size=point_size)
    return Picture.from_rgb(rgba, f"point cloud of {len(points)} points in the {frame} frame")
