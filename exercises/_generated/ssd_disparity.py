"""Starter of the exercise ssd_disparity.

Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`.
"""

import numpy as np


def ssd_disparity(left, right, max_disparity, window=9):
    """Find the disparity of every pixel by comparing windows along its
    row.

    For each candidate 0, 1, ..., ``max_disparity - 1`` the window
    around the pixel is compared with the window as many columns
    farther left in the right picture: by the sum of squared
    differences (SSD). The candidate with the smallest sum wins.

    Parameters
    ----------
    left, right : ndarray, uint8 or float, shape (H, W)
        Gray pictures of a rectified pair.
    max_disparity : int
        How many candidates are tried, at least 2.
    window : int
        Height and width of the window in pixels, odd.

    The arguments stay as they are.

    Returns
    -------
    ndarray, float, shape (H, W)
        Whole pixels; NaN where no candidate has both windows inside
        the pictures.

    Examples
    --------
    >>> right = np.tile(np.arange(12.0) ** 2, (3, 1))
    >>> left = np.roll(right, 2, axis=1)
    >>> ssd_disparity(left, right, max_disparity=4, window=3)[1, 3:8].tolist()
    [2.0, 2.0, 2.0, 2.0, 2.0]
    """
    raise NotImplementedError
