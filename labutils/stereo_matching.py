"""Stereo matching by hand: find the same window in the other picture, refine it, distrust it.

Convention of the module: a rectified pair as in `labutils.stereo`. What the left camera sees in
column u, the right one sees in column ``u - d``, in the same row; d is the disparity, in pixels.
Matches are the left picture's unless a name says otherwise; NaN stands where there is none.
Taught in: the chapter on stereo.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cv2
import numpy as np

from labutils._guards import check_cost_volume, check_count, check_gray_pair, check_odd
from labutils.stereo_refining import lr_check, subpixel

if TYPE_CHECKING:
    from collections.abc import Iterator

__all__ = [
    "cost_to_disparity",
    "lr_check",
    "make_right_cost",
    "matching_cost",
    "ssd_disparity",
    "subpixel",
]


def ssd_disparity(
    left: np.ndarray,
    right: np.ndarray,
    max_disparity: int,
    window: int = 9,
    *,
    padded: bool = False,
) -> np.ndarray:
    """Find the disparity of every pixel by comparing windows along its row.

    For each candidate 0, 1, ..., ``max_disparity - 1`` the window around the pixel is compared
    with the window as many columns farther left in the right picture: by the sum of squared
    differences (SSD). The candidate with the smallest sum wins.

    Parameters
    ----------
    left, right : ndarray, uint8 or float, shape (H, W)
        Gray pictures of a rectified pair.
    max_disparity : int
        How many candidates are tried, at least 1.
    window : int
        Height and width of the window in pixels, odd.
    padded : bool
        Whether windows count that reach beyond the edge, too: the squared differences of the
        pixels at the edge are repeated there.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Whole pixels, of equal sums the smallest; NaN where no candidate has both windows inside
        the pictures (padded: never).

    Raises
    ------
    TypeError, ValueError
        If the pictures are not gray, finite and of one size, or the other arguments not whole
        numbers as said above.

    Examples
    --------
    >>> right = np.tile(np.arange(12.0) ** 2, (3, 1))
    >>> left = np.roll(right, 2, axis=1)
    >>> ssd_disparity(left, right, max_disparity=4, window=3)[1, 3:11]
    array([2., 2., 2., 2., 2., 2., 2., 2.], dtype=float32)

    References
    ----------
    .. [1] Scharstein and Szeliski, A Taxonomy and Evaluation of Dense Two-Frame Stereo
       Correspondence Algorithms, IJCV 47, 2002.
    """
    pair = check_gray_pair(left, right)
    best = np.full(pair[0].shape, np.inf, np.float32)
    disparity = np.full(pair[0].shape, np.nan, np.float32)
    # The winner so far is kept instead of all costs: nothing is left to search, or to hold.
    for shift, cost in _list_costs(*pair, max_disparity, window, padded=padded):
        lowest = best[:, shift:]
        np.copyto(disparity[:, shift:], shift, where=cost < lowest)
        np.minimum(lowest, cost, out=lowest)
    return disparity


def matching_cost(
    left: np.ndarray,
    right: np.ndarray,
    max_disparity: int,
    window: int = 9,
    *,
    padded: bool = False,
) -> np.ndarray:
    """Compute the sum of squared differences of every pixel and candidate: the cost volume.

    Parameters
    ----------
    left, right, max_disparity, window, padded
        As in `ssd_disparity`.

    Returns
    -------
    ndarray, float32, shape (D, H, W)
        ``cost[d, v, u]`` of candidate d; infinite where one of its two windows is not inside its
        picture (padded: where its pixel is not). D is `max_disparity`.

    Raises
    ------
    TypeError, ValueError
        As in `ssd_disparity`.
    """
    pair = check_gray_pair(left, right)
    count = check_count("max_disparity", max_disparity, "disparity")
    costs = np.full((count, *pair[0].shape), np.inf, np.float32)
    for shift, cost in _list_costs(*pair, max_disparity, window, padded=padded):
        costs[shift, :, shift:] = cost
    return costs


def _list_costs(
    left: np.ndarray, right: np.ndarray, max_disparity: Any, window: Any, *, padded: bool
) -> Iterator[tuple[int, np.ndarray]]:
    """Yield every candidate d with the costs of the columns from d on."""
    count = check_count("max_disparity", max_disparity, "disparity")
    size = check_odd("window", window)
    width = left.shape[1]
    for shift in range(min(count, width)):
        difference = left[:, shift:] - right[:, : width - shift]
        cost = cv2.boxFilter(
            difference * difference,
            cv2.CV_32F,
            (size, size),
            normalize=False,
            borderType=cv2.BORDER_REPLICATE,
        )
        if not padded:
            _drop_edges(cost, size // 2)
        yield shift, cost


def _drop_edges(cost: np.ndarray, half: int) -> None:
    """Make costs infinite whose window reaches beyond the columns that both pictures share."""
    for edge in (cost, cost.T):
        edge[:half] = np.inf
        edge[max(0, len(edge) - half) :] = np.inf


def cost_to_disparity(cost: np.ndarray) -> np.ndarray:
    """Let the candidate with the smallest cost win, in every pixel.

    Parameters
    ----------
    cost : ndarray, float, shape (D, H, W)
        As `matching_cost` returns it.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Whole pixels, of equal costs the smallest; NaN where every cost is infinite.

    Raises
    ------
    TypeError, ValueError
        If the costs are not real numbers of that shape.
    """
    costs = check_cost_volume(cost)
    winner = costs.argmin(axis=0)
    lowest = np.take_along_axis(costs, winner[None], axis=0)[0]
    return np.where(np.isfinite(lowest), winner, np.nan).astype(np.float32)


def make_right_cost(cost: np.ndarray) -> np.ndarray:
    """Sort the costs of the left picture's pixels by the pixels of the right one.

    The same windows are compared, whichever picture they are looked for from: column u of the left
    picture with candidate d is column ``u - d`` of the right one with candidate d.

    Parameters
    ----------
    cost : ndarray, float, shape (D, H, W)
        As in `cost_to_disparity`.

    Returns
    -------
    ndarray, float, shape (D, H, W)
        Costs of the right picture's pixels; infinite where the left picture ends.

    Raises
    ------
    TypeError, ValueError
        As in `cost_to_disparity`.
    """
    costs = check_cost_volume(cost)
    right = np.full_like(costs, np.inf)
    width = costs.shape[2]
    for shift in range(min(len(costs), width)):
        right[shift, :, : width - shift] = costs[shift, :, shift:]
    return right
