"""All figures of the book: one style, readable on light and dark pages.

Every function returns a `Picture`, which shows itself as the last line of a cell. The verb
``plot_`` stands for exactly that.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from labutils._constants import TURN_WORLD
from labutils._guards import check_columns, check_depth_image
from labutils._picture import (
    CATEGORY_COLORS,
    WIDTHS,
    Picture,
    label_ends,
    make_axes,
    use_style,
)
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

#: The camera that draws a cloud: width and height in pixels, and K with f = 1300.
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
    """
    columns = columns or len(images)
    rows = -(-len(images) // columns)
    first = next(iter(images.values()))
    cell = WIDTHS[width] / columns
    with use_style():
        height = rows * (cell * first.shape[0] / first.shape[1] + 0.36)
        figure = Figure(figsize=(WIDTHS[width], height), layout="constrained")
        axes = figure.subplots(rows, columns, squeeze=False).ravel()
        for ax in axes:
            ax.set_axis_off()
        for ax, (title, image) in zip(axes, images.items(), strict=False):
            ax.set_title(title)
            ax.imshow(image, cmap="gray" if image.ndim == 2 else None)
        return Picture.from_figure(figure, "; ".join(images))


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
    low, high = limits or (np.nanmin(shown), np.nanmax(shown))
    with use_style():
        aspect = depth.shape[0] / depth.shape[1]
        figure, (ax,) = make_axes(1, width, WIDTHS[width] * 0.87 * aspect + 0.36)
        image = ax.imshow(shown, cmap="turbo", vmin=low, vmax=high)
        ax.set_title(title)
        ax.set_axis_off()
        figure.colorbar(image, ax=ax, label=f"depth ({unit})", pad=0.02)
        return Picture.from_figure(figure, title or "depth image")


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
    low, high = limits or (np.nanmin(truth), np.nanmax(truth))
    if error_limit_mm is None:
        error_limit_mm = max(float(np.nanpercentile(np.abs(error_mm), 99)), 1e-6)
    with use_style():
        height = WIDTHS["full"] / 3 * ours.shape[0] / ours.shape[1] + 0.95
        figure, axes = make_axes(3, "full", height)
        for ax, title, image in zip(axes, ("ours", "truth"), (ours, truth), strict=False):
            ax.set_title(title)
            shown = ax.imshow(image, cmap="turbo", vmin=low, vmax=high)
        figure.colorbar(shown, ax=list(axes[:2]), label="m", location="bottom", aspect=40)
        axes[2].set_title("error = ours - truth")
        signed = axes[2].imshow(error_mm, cmap="RdBu_r", vmin=-error_limit_mm, vmax=error_limit_mm)
        figure.colorbar(signed, ax=axes[2], label="mm", location="bottom", aspect=20)
        for ax in axes:
            ax.set_axis_off()
        return Picture.from_figure(figure, "ours, truth and error in mm")


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
    low, high = limits or (
        min(v.min() for v in finite.values()),
        max(v.max() for v in finite.values()),
    )
    with use_style():
        figure, (ax,) = make_axes(1, "full", 2.6)
        for name, values in finite.items():
            ax.hist(values, bins=bins, range=(low, high), histtype="step", label=name, lw=1.6)
        ax.set_xlabel(label)
        ax.set_ylabel("pixels")
        ax.set_xlim(low, high)
        if log:
            ax.set_yscale("log")
        if len(finite) > 1:
            ax.legend()
        return Picture.from_figure(figure, f"histogram of {', '.join(finite)}")


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
    """
    with use_style():
        figure, (ax,) = make_axes(1, "full", 2.8)
        drawn = [ax.plot(x, y, lw=1.8)[0] for y in lines.values()]
        ax.set_xlabel(x_label)
        ax.set_ylabel(y_label)
        ax.margins(x=0.02)
        if log_y:
            ax.set_yscale("log")
        label_ends(ax, dict(zip(lines, drawn, strict=True)))
        return Picture.from_figure(figure, f"{y_label} over {x_label}: {', '.join(lines)}")


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
    if colors is None:
        colors = get_depth_colors(points)
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
