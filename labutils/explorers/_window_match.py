"""Match the window around one pixel, for the view that shows how: costs, minimum, sub-pixel."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils.stereo_matching import matching_cost

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Sides of the windows that can be tried, in pixels.
WINDOWS = tuple(range(3, 32, 2))
#: Disparity travels as 16-bit PNG in steps of this many pixels: KITTI's, 0 for none.
DISPARITY_STEP = 1 / 256


def find_costs(
    left: np.ndarray, right: np.ndarray, pixel: Sequence[int], window: int, search: int
) -> np.ndarray:
    """Sum the squared differences of the windows around a pixel and its candidates.

    Parameters
    ----------
    left, right : ndarray, uint8, shape (H, W)
        A rectified pair.
    pixel : (u, v)
        Of the left picture.
    window : int
        Side of the square window in pixels, odd.
    search : int
        How many disparities are tried, from 0 on.

    Returns
    -------
    ndarray, float64, shape (N,)
        By disparity. N is smaller than `search` where the window would leave the right picture;
        0 where it leaves the left one.
    """
    (u, v), reach = pixel, window // 2
    height, width = left.shape
    if not (reach <= u < width - reach and reach <= v < height - reach):
        return np.zeros(0)
    count = min(search, u - reach + 1)
    # what no candidate of this pixel needs is not compared
    band = np.s_[v - reach : v + reach + 1, u - reach - count + 1 : u + reach + 1]
    costs = matching_cost(left[band], right[band], count, window)
    return costs[:, reach, -1 - reach].astype(np.float64)


def refine(costs: np.ndarray, disparity: int) -> float:
    """Move a disparity to the lowest point of the parabola through its cost and its neighbors'.

    As `labutils.stereo_matching.subpixel`, which rounds to float32, in double precision: an end of
    the curve stays, and so does a minimum without a parabola.
    """
    if not 0 < disparity < costs.size - 1:
        return float(disparity)
    before, here, after = (float(one) for one in costs[disparity - 1 : disparity + 2])
    bend = before - 2 * here + after
    return disparity + (before - after) / (2 * bend) if bend > 0 else float(disparity)


def find_runner_up(costs: np.ndarray, best: int) -> int | None:
    """Find the lowest of the other valleys of the curve; None where there is no other."""
    inner = np.arange(1, costs.size - 1)
    is_valley = (costs[inner] < costs[inner - 1]) & (costs[inner] <= costs[inner + 1])
    valleys = inner[is_valley & (np.abs(inner - best) > 1)]
    return int(valleys[np.argmin(costs[valleys])]) if valleys.size else None


def find_error(costs: np.ndarray, truth: float) -> float | None:
    """Return how far the lowest point of a curve is from the truth, in pixels; None for neither."""
    if not costs.size or np.isnan(truth):
        return None
    return abs(refine(costs, int(costs.argmin())) - truth)
