"""Posters of the views that draw lines: what a page without scripts, and print, show instead."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cv2
import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping


def draw_lines(
    x: np.ndarray,
    curves: Mapping[str, np.ndarray],
    point: tuple[float, float],
    *,
    labels: tuple[str, str],
    title: str,
    log: bool = False,
) -> np.ndarray:
    """Draw curves over `x`, and one point: uint8 RGB on white.

    Parameters
    ----------
    x : ndarray, shape (N,)
        Where the curves are known.
    curves : mapping of str to ndarray (N,)
        By their name in the legend.
    point : tuple of float
        Where the point is.
    labels : tuple of str
        Of the two axes, with units.
    title : str
        Above the axes.
    log : bool
        Whether both axes are logarithmic.

    Returns
    -------
    ndarray, uint8, shape (H, W, 3)
    """
    # Matplotlib takes long to load, and only posters need it.
    from labutils._picture import Picture, make_axes, use_style  # noqa: PLC0415

    with use_style():
        figure, (axes,) = make_axes(1, "full", 3.6)
        for name, values in curves.items():
            axes.plot(x, values, label=name)
        axes.plot(*point, "o")
        axes.set_xlabel(labels[0])
        axes.set_ylabel(labels[1])
        axes.set_title(title, wrap=True)
        if log:
            axes.set(xscale="log", yscale="log")
        axes.legend()
        png = Picture.from_figure(figure, title).png
    bgra = np.asarray(cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_UNCHANGED))
    alpha = bgra[..., 3:] / 255
    on_white = bgra[..., 2::-1] * alpha + 255 * (1 - alpha)
    size = (bgra.shape[1] // 2, bgra.shape[0] // 2)
    return cv2.resize(on_white.round().astype(np.uint8), size, interpolation=cv2.INTER_AREA)
