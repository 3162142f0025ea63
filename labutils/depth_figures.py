"""Several depth images in one figure, with one scale for all of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing import draw
from labutils._drawing.parts import ColorBar, Panel, Sheet
from labutils._drawing.scales import widen
from labutils._drawing.style import WIDTHS
from labutils._guards import check_depth_image

if TYPE_CHECKING:
    from collections.abc import Mapping

    from labutils._picture import Picture


def plot_depths(depths: Mapping[str, np.ndarray], *, limits: tuple[float, float]) -> Picture:
    """Show depth images side by side in turbo (blue close, red far), with one color bar.

    Parameters
    ----------
    depths : mapping of str to ndarray
        Title to depth in meters, real, shape (H, W); NaN and infinite pixels stay empty.
    limits : (low, high)
        Of the color scale that all pictures share, in meters.

    Returns
    -------
    Picture

    Raises
    ------
    ValueError
        If there is no picture, or one has another shape.

    Notes
    -----
    Limits are asked for: pictures with scales of their own could not be compared.
    """
    if not depths:
        raise ValueError("depths: expected at least one depth image, got none")
    panels = tuple(
        Panel(title, _check_shown(title, depth), "turbo", widen(*limits))
        for title, depth in depths.items()
    )
    rows, columns = panels[0].pixels.shape
    height = WIDTHS["full"] / len(panels) * rows / columns + 0.95
    bar = ColorBar("depth (m)", tuple(range(len(panels))), "bottom", 40)
    return draw(Sheet("; ".join(depths), WIDTHS["full"], height, len(panels), panels, (bar,)))


def _check_shown(title: str, depth: np.ndarray) -> np.ndarray:
    depth = check_depth_image(f"depths[{title!r}]", depth)
    return np.where(np.isfinite(depth), depth, np.nan)
