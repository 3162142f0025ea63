"""Posters of the views that draw lines: what a page without scripts, and print, show instead."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing import draw_on_white
from labutils._drawing.parts import Curve, Plot
from labutils._drawing.scales import Axis, get_limits
from labutils._drawing.style import WIDTHS

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
    points = np.concatenate([[point], *(np.stack([x, y], axis=1) for y in curves.values())])
    return draw_on_white(
        Plot(
            title,
            WIDTHS["full"],
            3.6,
            tuple(Curve(name, x, y) for name, y in curves.items()),
            Axis(labels[0], get_limits(points[:, 0], log=log), log),
            Axis(labels[1], get_limits(points[:, 1], log=log), log),
            line_width=1.5,
            naming="legend",
            title=title,
            point=point,
        )
    )
