"""Score a disparity picture against the truth of a simulated pair, region by region.

Conventions are those of `labutils.stereo_matching`. Truth comes from depth images of both cameras,
so what the right camera does not see is known, not guessed. Taught in: the chapter on stereo.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np

from labutils._guards import (
    check_depth_image,
    check_gray_image,
    check_mask,
    check_odd,
    check_positive,
)
from labutils.stereo import depth_to_disparity

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike

__all__ = [
    "DisparityScore",
    "find_disparity_edges",
    "find_occluded",
    "find_textureless",
    "score_disparity",
    "score_regions",
]


@dataclass(frozen=True)
class DisparityScore:
    """How good the disparities of some pixels are; shares from 0 to 1, NaN of no pixels.

    Parameters
    ----------
    count : int
        Pixels that were counted.
    density : float
        Share of them with a disparity.
    bad1, bad2 : float
        Share of those with a disparity that is off by more than 1 or 2 pixels.
    wrong : float
        Share of all counted pixels whose disparity is off by more than 2 pixels.
    not_correct : float
        Share of all counted pixels that are missing or off by more than 2 pixels.
    sd : float
        Standard deviation of the error in pixels, of disparities less than 1 pixel off.
    """

    count: int
    density: float
    bad1: float
    bad2: float
    wrong: float
    not_correct: float
    sd: float


def score_disparity(
    disparity: ArrayLike, truth: ArrayLike, counted: ArrayLike | None = None
) -> DisparityScore:
    """Score disparities against the truth.

    Parameters
    ----------
    disparity : array-like, real, shape (H, W)
        Pixels; NaN where there is none.
    truth : array-like, real, shape (H, W)
        True disparities in pixels. Where they are not finite, nothing is counted.
    counted : array-like, bool or uint8, shape (H, W), optional
        The pixels to count: usually those that the right camera sees, too. Default: all.

    Returns
    -------
    DisparityScore
        Shares and the standard deviation of the error.

    Raises
    ------
    TypeError, ValueError
        If the arrays are not of one shape (H, W), or of other numbers than said above.
    """
    yours = check_depth_image("disparity", disparity).astype(np.float64)
    due = check_depth_image("truth", truth).astype(np.float64)
    _check_same_shape("truth", due, yours)
    chosen = np.isfinite(due)
    if counted is not None:
        mask = check_mask("counted", counted)
        _check_same_shape("counted", mask, yours)
        chosen &= mask > 0
    error = (yours - due)[chosen]
    known = error[np.isfinite(error)]
    off = np.abs(known)
    wrong = int(np.count_nonzero(off > 2))
    missing = error.size - known.size
    close = known[off < 1]
    return DisparityScore(
        count=error.size,
        density=_divide(known.size, error.size),
        bad1=_divide(int(np.count_nonzero(off > 1)), known.size),
        bad2=_divide(wrong, known.size),
        wrong=_divide(wrong, error.size),
        not_correct=_divide(wrong + missing, error.size),
        sd=float(close.std()) if close.size else float("nan"),
    )


def score_regions(
    disparity: ArrayLike, truth: ArrayLike, regions: Mapping[str, ArrayLike]
) -> dict[str, DisparityScore]:
    """Score disparities in each of several regions.

    Parameters
    ----------
    disparity, truth
        As in `score_disparity`.
    regions : mapping of str to array-like, bool or uint8, shape (H, W)
        The pixels of each region by its name.

    Returns
    -------
    dict of str to DisparityScore
        In the order of the regions.

    Raises
    ------
    TypeError, ValueError
        As in `score_disparity`.
    """
    return {name: score_disparity(disparity, truth, region) for name, region in regions.items()}


def find_occluded(
    depth_metric: ArrayLike, depth_right: ArrayLike, K: ArrayLike, baseline: float
) -> np.ndarray:
    """Find what the left camera sees and the right one does not.

    Convention
    ----------
    A pixel is occluded where its match lies left of the right picture's edge, -0.5, or where the
    right camera sees another depth there, by more than 2 %: 2 % is more than one pixel of a slanted
    surface makes, and less than the gap between two things.

    Parameters
    ----------
    depth_metric, depth_right : array-like, real, shape (H, W)
        Depth images of the left and the right camera, in meters.
    K : array-like, shape (3, 3)
        Intrinsic matrix of both cameras.
    baseline : float
        Distance between the cameras in meters, > 0.

    Returns
    -------
    ndarray, bool, shape (H, W)
        True where the right camera does not see the point; also where there is no depth.

    Raises
    ------
    TypeError, ValueError
        If the depth images have not one shape (H, W), or K and baseline are none.
    """
    left = check_depth_image("depth_metric", depth_metric).astype(np.float64)
    right = check_depth_image("depth_right", depth_right).astype(np.float64)
    _check_same_shape("depth_right", right, left)
    place = np.floor(np.arange(left.shape[1]) - depth_to_disparity(left, K, baseline) + 0.5)
    inside = place >= 0  # false for NaN
    there = np.where(inside, place, 0).astype(np.intp)
    seen = np.take_along_axis(right, there, axis=1)
    with np.errstate(invalid="ignore"):
        same = np.abs(seen - left) <= 0.02 * left
    return np.asarray(~(inside & same))


def find_disparity_edges(truth: ArrayLike, window: int = 9) -> np.ndarray:
    """Find the pixels whose window reaches over a jump of the disparity.

    Parameters
    ----------
    truth : array-like, real, shape (H, W)
        True disparities in pixels.
    window : int
        Height and width of the window in pixels, odd.

    Returns
    -------
    ndarray, bool, shape (H, W)
        True where the Laplacian is above 1 pixel somewhere in the window: a slope has none.

    Raises
    ------
    TypeError, ValueError
        If the truth is no array of shape (H, W), or the window no odd number.
    """
    disparity = check_depth_image("truth", truth).astype(np.float32)
    size = check_odd("window", window)
    # NaN is no number to compare: what is unknown counts as a jump.
    jumps = ~(np.abs(cv2.Laplacian(disparity, cv2.CV_32F)) <= 1)
    return cv2.dilate(jumps.astype(np.uint8), np.ones((size, size), np.uint8)) > 0


def find_textureless(image: ArrayLike, window: int = 9, limit: float = 4.0) -> np.ndarray:
    """Find the pixels whose window looks alike everywhere, so that any match fits as well.

    Parameters
    ----------
    image : array-like, uint8 or float, shape (H, W)
        Gray picture.
    window : int
        Height and width of the window in pixels, odd.
    limit : float
        Standard deviation of the gray values in the window below which it counts as plain, > 0.
        The default is twice the noise of the book's stereo cameras.

    Returns
    -------
    ndarray, bool, shape (H, W)
        True where there is no texture.

    Raises
    ------
    TypeError, ValueError
        If the picture is not gray and finite, or window and limit are not as said above.
    """
    gray = check_gray_image("image", image)
    size = check_odd("window", window)
    most = check_positive("limit", limit, "gray levels")
    mean = cv2.blur(gray, (size, size))
    # Squares of what is left after the mean: no two large numbers are subtracted.
    spread = cv2.blur((gray - mean) ** 2, (size, size))
    return np.asarray(spread < most**2)


def _check_same_shape(name: str, value: np.ndarray, other: np.ndarray) -> None:
    if value.shape != other.shape:
        raise ValueError(f"{name}: expected shape {other.shape} as the others, got {value.shape}")


def _divide(part: int, whole: int) -> float:
    return float(part / whole) if whole else float("nan")
