"""Refine a disparity below a pixel, and distrust what the other picture contradicts.

Conventions are those of `labutils.stereo_matching`. Stands on NumPy alone.
Taught in: the chapter on stereo.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from labutils._guards import check_cost_volume, check_depth_image, check_positive

__all__ = ["lr_check", "subpixel"]


def subpixel(cost: np.ndarray, disparity: np.ndarray) -> np.ndarray:
    """Refine whole disparities: put a parabola through the smallest cost and its two neighbors.

    Convention
    ----------
    With the costs a, b, c of d - 1, d, d + 1 the parabola is lowest at
    ``d + (a - c) / (2 (a - 2 b + c))``, at most half a pixel away.

    Parameters
    ----------
    cost : ndarray, float, shape (D, H, W)
        Cost of each of D candidates 0, 1, ..., D - 1, as `matching_cost` returns it.
    disparity : ndarray, float, shape (H, W)
        The candidates that won: whole pixels from 0 to D - 1, or NaN.

    Returns
    -------
    ndarray, float32, shape (H, W)
        Pixels. A disparity stays as it is where a neighbor is missing (at 0 and at D - 1),
        infinite or lower, and where all three costs are equal. NaN stays NaN.

    Raises
    ------
    TypeError, ValueError
        If the costs or the disparities are not real numbers of these shapes, or a disparity is no
        candidate.

    Examples
    --------
    >>> cost = np.array([5.0, 2.0, 1.0, 4.0]).reshape(4, 1, 1)
    >>> subpixel(cost, np.array([[2.0]]))
    array([[1.75]], dtype=float32)

    References
    ----------
    .. [1] Szeliski, Computer Vision: Algorithms and Applications, 2nd edition, section 12.3.1.
    """
    costs = check_cost_volume(cost)
    whole, known = _check_winners(disparity, costs)
    rows, columns = np.nonzero(known & (whole > 0) & (whole < len(costs) - 1))
    places = whole[rows, columns]
    before, lowest, after = (
        costs[places + step, rows, columns].astype(np.float64) for step in (-1, 0, 1)
    )
    with np.errstate(invalid="ignore"):  # infinite costs beside each other; they are left out
        bend = before - 2 * lowest + after
        fits = (before >= lowest) & (after >= lowest) & (bend > 0) & np.isfinite(bend)
        moves = np.divide(before - after, 2 * bend, out=np.zeros_like(bend), where=fits)
    refined = np.where(known, whole, np.nan)
    refined[rows, columns] += moves
    return refined.astype(np.float32)


def lr_check(
    disparity_left: np.ndarray, disparity_right: np.ndarray, tolerance: float = 1.0
) -> np.ndarray:
    """Keep the matches that the other picture confirms: the left-right check.

    A pixel of the left picture with disparity d leads to column ``u - d`` of the right picture,
    rounded to the nearest one. What was found there has to lead back: it may differ by the
    tolerance.

    Parameters
    ----------
    disparity_left : ndarray, float, shape (H, W)
        Pixels; NaN where there is no match.
    disparity_right : ndarray, float, shape (H, W)
        The same of the right picture: its column u is found in column u + d of the left one.
    tolerance : float
        How far the two may differ, in pixels, > 0.

    Returns
    -------
    ndarray, bool, shape (H, W)
        True where the match is kept: both disparities exist, and agree. False where the left one
        leads out of the picture.

    Raises
    ------
    TypeError, ValueError
        If the disparities are not real numbers of one shape, or the tolerance is not positive.

    References
    ----------
    .. [1] Fua, A Parallel Stereo Algorithm that Produces Dense Depth Maps and Preserves Image
       Features, Machine Vision and Applications 6, 1993.
    """
    from_left = check_depth_image("disparity_left", disparity_left).astype(np.float64)
    from_right = check_depth_image("disparity_right", disparity_right).astype(np.float64)
    if from_left.shape != from_right.shape:
        raise ValueError(
            f"disparity_right: expected shape {from_left.shape} as disparity_left has, "
            f"got {from_right.shape}"
        )
    limit = check_positive("tolerance", tolerance, "pixels")
    width = from_left.shape[1]
    # Half a column lies between two: the right one is as near, and it is what floor(x + 0.5) says.
    place = np.floor(np.arange(width) - from_left + 0.5)
    inside = (place >= 0) & (place < width)  # false for NaN
    there = np.where(inside, place, 0).astype(np.intp)
    back = np.take_along_axis(from_right, there, axis=1)
    return np.asarray(inside & (np.abs(back - from_left) <= limit))


def _check_winners(disparity: Any, costs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the winners as whole numbers, 0 where there is none, and where there is one."""
    found = check_depth_image("disparity", disparity)
    if found.shape != costs.shape[1:]:
        raise ValueError(
            f"disparity: expected shape {costs.shape[1:]} as the costs have, got {found.shape}"
        )
    known = ~np.isnan(found)
    whole = np.where(known, found, 0)
    wrong = (whole != np.round(whole)) | (whole < 0) | (whole >= len(costs))
    if wrong.any():
        raise ValueError(
            f"disparity: expected whole numbers from 0 to {len(costs) - 1} or NaN, "
            f"got {whole[wrong][0]}"
        )
    return whole.astype(np.intp), known
