"""Where the names of curves stand that are written at their ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from labutils._drawing.parts import Plot

# Share of a figure's height that Matplotlib gives to axes before it makes room for their labels.
_AXES_SHARE = 0.77
_GAP_PT = 13.0  # between the middles of two labels, one above the other
_POINTS_PER_INCH = 72


def find_ends(plot: Plot) -> np.ndarray:
    """Return the last point of every curve that has a height, shape (N, 2)."""
    ends = []
    for curve in plot.curves:
        last = np.flatnonzero(np.isfinite(curve.y))[-1]
        ends.append((curve.x[last], curve.y[last]))
    return np.array(ends, float)


def find_shifts(plot: Plot) -> np.ndarray:
    """Return how far above the end of its curve each name stands, in points, shape (N,)."""
    shares = plot.y.to_share(find_ends(plot)[:, 1])
    heights_pt = _POINTS_PER_INCH * plot.height * _AXES_SHARE * shares
    return spread_labels(heights_pt, _GAP_PT) - heights_pt


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
