"""Rectified pairs with known disparities to ask about: textured, noisy, made from a seed, small."""

from __future__ import annotations

import cv2
import numpy as np


def make_disparity(
    rng: np.random.Generator, height: int, width: int, max_disparity: int
) -> np.ndarray:
    """Make whole disparities: a far strip, a wall that comes nearer in steps, and a near box.

    The strip has disparity 0, the box the largest that is searched for.
    """
    last = max_disparity - 1
    middle = int(rng.integers(last // 3, last // 2 + 1))
    rows = np.arange(height)[:, None]
    steps = np.linspace(0, 2.9, height).astype(int)[:, None]
    disparity = np.where(rows < height // 3, 0, middle + steps).repeat(width, axis=1)
    top = int(rng.integers(height // 6, height // 3))
    left = int(rng.integers(width // 3, width // 2))
    disparity[top : top + height // 2, left : left + width // 3] = last
    return np.minimum(disparity, last)


def make_texture(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Make random blots of a few pixels, as floats around 128 that stay clear of 0 and 255."""
    blots = cv2.GaussianBlur(rng.normal(size=(height, width)), (0, 0), 0.8)
    return 128 + 100 * blots / np.abs(blots).max()


def make_pair(
    rng: np.random.Generator, disparity: np.ndarray, noise: float = 3.0
) -> tuple[np.ndarray, np.ndarray]:
    """Make the two pictures of a left view with these disparities, uint8.

    What the right camera does not see has a texture of its own, and every picture its own noise, so
    no two sums of squares are equal.
    """
    height, width = disparity.shape
    right = make_texture(rng, height, width)
    place = np.arange(width) - disparity
    left = np.take_along_axis(right, np.maximum(place, 0), axis=1)
    hidden = (place < 0) | _is_covered(place, disparity)
    left[hidden] = make_texture(rng, height, width)[hidden]
    noisy = (one + rng.normal(0, noise, one.shape) for one in (left, right))
    first, second = (np.clip(np.rint(one), 0, 255).astype(np.uint8) for one in noisy)
    return first, second


def _is_covered(place: np.ndarray, disparity: np.ndarray) -> np.ndarray:
    """Mark pixels whose place in the right picture something nearer takes."""
    nearest = np.full(disparity.shape, -1)
    rows = np.indices(disparity.shape)[0]
    inside = place >= 0
    np.maximum.at(nearest, (rows[inside], place[inside]), disparity[inside])
    return np.asarray(np.take_along_axis(nearest, np.maximum(place, 0), axis=1) > disparity)
