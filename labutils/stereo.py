"""Two cameras side by side: what disparity is, and how well it tells the depth.

Convention of the module: both cameras have the same K and look the same way; the right one stands
`baseline` meters to the right, along x of the left one's frame (a rectified pair). Pictures are the
left camera's unless a name says otherwise. Stands on NumPy alone. Taught in: step 2, step 3.
"""

from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any

import numpy as np

from labutils._guards import check_intrinsics, check_positive, check_real_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

#: What becomes of a pixel of the left picture in the right one.
OUTSIDE, SEEN, HIDDEN = range(3)


def depth_to_disparity(depth_metric: ArrayLike, K: ArrayLike, baseline: float) -> np.ndarray:
    """Compute how many columns farther left the right camera sees a point.

    Convention
    ----------
    ``d = f b / Z``, with f in pixels from ``K[0, 0]``; positive for every point in front.

    Parameters
    ----------
    depth_metric : array-like, real, any shape
        Meters along the optical axis.
    K : array-like, shape (3, 3)
        Intrinsic matrix of both cameras.
    baseline : float
        Distance between the cameras in meters, > 0.

    Returns
    -------
    ndarray, float64, same shape
        Pixels; 0 where the depth is infinite, NaN where it is NaN, 0 or negative.

    Raises
    ------
    TypeError, ValueError
        If the depth is not real numbers, K is no intrinsic matrix, or the baseline not positive.

    Examples
    --------
    >>> K = np.array([[500.0, 0, 319.5], [0, 500.0, 239.5], [0, 0, 1]])
    >>> depth_to_disparity(np.array([1.0, 2.0, 4.0]), K, baseline=0.1)
    array([50. , 25. , 12.5])

    References
    ----------
    .. [1] Szeliski, Computer Vision: Algorithms and Applications, 2nd edition, section 12.1.
    """
    depth = check_real_array("depth_metric", depth_metric).astype(np.float64)
    product = _multiply(K, baseline)
    return product / np.where(depth > 0, depth, np.nan)


def disparity_to_depth(disparity: ArrayLike, K: ArrayLike, baseline: float) -> np.ndarray:
    """Compute the depth that a disparity stands for: the inverse of `depth_to_disparity`.

    Parameters
    ----------
    disparity : array-like, real, any shape
        Pixels, positive where the right camera sees the point farther left.
    K : array-like, shape (3, 3)
        Intrinsic matrix of both cameras.
    baseline : float
        Distance between the cameras in meters, > 0.

    Returns
    -------
    ndarray, float64, same shape
        Meters along the optical axis; infinite where the disparity is 0, NaN where it is NaN or
        negative: no point in front of both cameras has such a disparity.

    Raises
    ------
    TypeError, ValueError
        As in `depth_to_disparity`.
    """
    pixels = check_real_array("disparity", disparity).astype(np.float64)
    product = _multiply(K, baseline)
    with np.errstate(divide="ignore"):  # at 0 infinity is the answer
        # + 0.0 turns -0.0 into 0.0, which would be minus infinity.
        return product / (np.where(pixels >= 0, pixels, np.nan) + 0.0)


def find_depth_interval(
    depth_metric: ArrayLike, match_error: float, K: ArrayLike, baseline: float
) -> tuple[np.ndarray, np.ndarray]:
    """Find the depths that a point may have if its match may be some pixels off.

    Convention
    ----------
    From ``f b / (d + e)`` to ``f b / (d - e)``, with the true disparity d and the match error e.
    Where d <= e the far end is infinite: the point could be as far away as one likes.

    Parameters
    ----------
    depth_metric : array-like, real, any shape
        True depth in meters.
    match_error : float
        How far the disparity may be off to either side, in pixels, > 0.
    K, baseline
        As in `depth_to_disparity`.

    Returns
    -------
    near, far : ndarray, float64, same shape
        Meters; NaN where the depth is NaN, 0 or negative.

    Raises
    ------
    TypeError, ValueError
        As in `depth_to_disparity`, or if the match error is not positive.

    Notes
    -----
    Both ends are ``Z = f b / d`` of `depth_to_disparity`, for the smallest and the largest
    disparity that the match allows.
    """
    disparity = depth_to_disparity(depth_metric, K, baseline)
    error = check_positive("match_error", match_error, "pixels")
    product = _multiply(K, baseline)
    near = product / (disparity + error)
    bounded = ~(disparity <= error)  # NaN stays in, and stays NaN
    far = np.full(disparity.shape, np.inf)
    np.divide(product, disparity - error, out=far, where=bounded)
    return near, far


def find_depth_error(
    depth_metric: ArrayLike, match_error: float, K: ArrayLike, baseline: float
) -> np.ndarray:
    """Compute the largest depth error of a match that may be some pixels off.

    Convention
    ----------
    The far end of `find_depth_interval` is the farther off: by ``Z^2 e / (f b - Z e)``.

    Parameters
    ----------
    depth_metric, match_error, K, baseline
        As in `find_depth_interval`.

    Returns
    -------
    ndarray, float64, same shape
        Meters; infinite where the interval has no far end, NaN as in `find_depth_interval`.

    Raises
    ------
    TypeError, ValueError
        As in `find_depth_interval`.

    Notes
    -----
    ``f b / (d - e) - Z`` with ``d = f b / Z``, brought to one fraction: computed like that, two
    nearly equal depths are never subtracted.
    """
    disparity = depth_to_disparity(depth_metric, K, baseline)
    error = check_positive("match_error", match_error, "pixels")
    product = _multiply(K, baseline)
    depth = np.asarray(depth_metric, dtype=np.float64)
    left = product - depth * error
    # Next to d = e rounding may leave nothing where there should be a little: no far end either.
    bounded = (disparity > error) & (left > 0)
    largest = np.where(np.isnan(disparity), np.nan, np.inf)
    np.divide(depth**2 * error, left, out=largest, where=bounded)
    return largest


def find_linear_depth_error(
    depth_metric: ArrayLike, match_error: float, K: ArrayLike, baseline: float
) -> np.ndarray:
    """Compute the depth error for a small match error: ``Z^2 e / (f b)``.

    The first term of the series of `find_depth_error` in e, which shows the law: twice the
    depth, four times the error; twice the baseline, half of it.

    Parameters
    ----------
    depth_metric, match_error, K, baseline
        As in `find_depth_interval`.

    Returns
    -------
    ndarray, float64, same shape
        Meters; NaN where the depth is NaN, 0 or negative.

    Raises
    ------
    TypeError, ValueError
        As in `find_depth_interval`.

    References
    ----------
    .. [1] Gallup, Frahm, Mordohai and Pollefeys, Variable Baseline/Resolution Stereo, CVPR 2008.
    """
    depth = check_real_array("depth_metric", depth_metric).astype(np.float64)
    error = check_positive("match_error", match_error, "pixels")
    return np.where(depth > 0, depth, np.nan) ** 2 * error / _multiply(K, baseline)


def find_right_state(u: int, disparity_row: ArrayLike) -> int:
    """Tell whether the right camera sees the point of one pixel.

    Convention
    ----------
    A point is outside when its column in the right picture lies left of that picture's edge, -0.5.
    It is hidden when something nearer in the same row of the left picture, by more than one pixel
    of disparity, lands within half a pixel of it. What the left camera does not see cannot be
    known to hide anything.

    Parameters
    ----------
    u : int
        Column of the pixel.
    disparity_row : array-like, real, shape (W,)
        Disparities of the whole row in pixels; NaN where there is no surface.

    Returns
    -------
    int
        `OUTSIDE`, `SEEN` or `HIDDEN`.

    Raises
    ------
    TypeError, ValueError
        If the row is not one row of real numbers, or `u` no column of it that sees a surface.

    References
    ----------
    .. [1] Scharstein and Szeliski, A Taxonomy and Evaluation of Dense Two-Frame Stereo
       Correspondence Algorithms, IJCV 47, 2002, section 5.1: occluded regions.
    """
    row = check_real_array("disparity_row", disparity_row)
    if row.ndim != 1:
        raise ValueError(f"disparity_row: expected shape (W,), got shape {row.shape}")
    column = _check_column(u, row)
    place = column - row[column]
    if place < -0.5:
        return OUTSIDE
    # A point lands farther left than its own column: only columns to the right can hide it.
    columns = np.arange(column + 1, row.size)
    others = row[columns]
    nearer = others > row[column] + 1  # false for NaN: no surface hides nothing
    covers = nearer & (np.abs(columns - others - place) <= 0.5)
    return HIDDEN if covers.any() else SEEN


def _multiply(K: ArrayLike, baseline: float) -> float:
    """Return f b, in pixels times meters."""
    return float(check_intrinsics(K)[0, 0]) * check_positive("baseline", baseline, "meters")


def _check_column(u: Any, row: np.ndarray) -> int:
    if isinstance(u, bool) or not isinstance(u, numbers.Integral):
        raise TypeError(f"u: expected a whole number, got {type(u).__name__} {u!r}")
    column = int(u)
    if not 0 <= column < row.size:
        raise ValueError(f"u: expected a column from 0 to {row.size - 1}, got {u}")
    if np.isnan(row[column]):
        raise ValueError(f"u: expected a column that sees a surface, got {u}: its disparity is NaN")
    return column
