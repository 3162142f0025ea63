"""Starter of the exercise subpixel.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def subpixel(cost, disparity):
    """Refine whole disparities: put a parabola through the smallest cost
    and its two neighbors.

    Parameters
    ----------
    cost : ndarray, float32, shape (D, H, W)
        Cost of each of D candidates 0, 1, ..., D - 1; infinite where
        one does not fit.
    disparity : ndarray, float32, shape (H, W)
        The candidates with the smallest cost, whole pixels; NaN where
        none fits.

    The arguments stay as they are.

    Returns
    -------
    refined : ndarray, float, shape (H, W)
        Pixels. A disparity stays as it is where a neighbor is missing
        (at 0 and at D - 1) or infinite, and where all three costs are
        equal. NaN stays NaN.

    Examples
    --------
    >>> cost = np.array([5.0, 2.0, 1.0, 4.0]).reshape(4, 1, 1)
    >>> subpixel(cost, np.array([[2.0]])).tolist()
    [[1.75]]
    """
    raise NotImplementedError
