"""Sensor noise that Python and the page make alike, from whole numbers.

Each pixel gets the sum of the four bytes of a hash of its place: numbers around 0 with almost the
shape of a bell, none farther out than 3.5 standard deviations.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

#: Spreads the second picture's places away from the first one's.
_STRIDE = 0x9E3779B9
#: Twice the standard deviation of the sum of four bytes, to the next whole number.
_TWICE_SD = 296


@lru_cache(maxsize=8)
def make_noise(count: int, seed: int) -> np.ndarray:
    """Make noise for `count` pixels: int64, -510 to 510, standard deviation 148.

    References
    ----------
    .. [1] Wellons, Prospecting for Hash Functions, nullprogram.com, 2018: the hash "lowbias32".
    """
    start = (seed * _STRIDE) % 2**32
    hashed = np.arange(count, dtype=np.uint32) + np.uint32(start)
    for shift, factor in ((16, 0x7FEB352D), (15, 0x846CA68B)):
        hashed ^= hashed >> np.uint32(shift)
        hashed *= np.uint32(factor)
    hashed ^= hashed >> np.uint32(16)
    return hashed.astype("<u4").view(np.uint8).reshape(-1, 4).sum(axis=1, dtype=np.int64) - 510


def add_noise(gray: np.ndarray, sigma: int, seed: int) -> np.ndarray:
    """Add noise of a standard deviation of `sigma` gray levels: uint8, same shape."""
    noise = make_noise(gray.size, seed).reshape(gray.shape)
    # halves go up, as in JavaScript
    levels = (2 * sigma * noise + _TWICE_SD // 2) // _TWICE_SD
    return np.clip(gray + levels, 0, 255).astype(np.uint8)
