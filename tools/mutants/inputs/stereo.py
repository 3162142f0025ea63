"""Valid input of the exercises on stereo matching."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

#: What disparities are beside whole pixels: nothing that rounding to a column could decide.
_PARTS = (-0.375, -0.25, 0.0, 0.25, 0.375)


def _ssd_disparity(rng: np.random.Generator) -> tuple[Any, ...]:
    """Draw unrelated pictures, or the same moved by whole columns, as uint8 or as floats.

    Each candidate wins somewhere, and of random numbers no two sums of a pixel are the smallest.
    """
    window = int(rng.choice([3, 5, 7]))
    height, width = (int(one) for one in rng.integers([1, 5], [14, 18]))
    count = int(rng.integers(2, 9))
    if rng.random() < 0.2:
        count = int(rng.integers(2, width + 4))  # wider than the picture, too
    right = rng.integers(0, 256, (height, width))
    left = rng.integers(0, 256, (height, width))
    if rng.random() < 0.5:
        moved = np.roll(right, int(rng.integers(0, count)), axis=1)
        left = np.clip(moved + rng.integers(-9, 10, moved.shape), 0, 255)
    if rng.random() < 0.3:
        floats = (one + rng.uniform(0, 0.5, one.shape) for one in (left, right))
        return (*floats, count, window)
    return left.astype(np.uint8), right.astype(np.uint8), count, window


def _subpixel(rng: np.random.Generator) -> tuple[Any, ...]:
    count, height, width = (int(one) for one in rng.integers([2, 1, 1], [7, 4, 6]))
    cost = np.round(rng.uniform(0, 900, (count, height, width)), 1)
    # Costs do not fit from some candidate on; or fit nowhere.
    fits = rng.integers(0, count + 1, (height, width))
    if rng.random() < 0.5:
        cost[np.arange(count)[:, None, None] >= fits] = np.inf
    winner = np.where(np.isfinite(cost.min(axis=0)), cost.argmin(axis=0), np.nan)
    flat = (rng.random((height, width)) < 0.15) & np.isfinite(cost).all(axis=0)
    cost[:, flat] = 300.0
    winner[flat] = rng.integers(0, count, np.count_nonzero(flat))
    return cost.astype(np.float32), winner.astype(np.float32)


def _lr_check(rng: np.random.Generator) -> tuple[Any, ...]:
    height, width = (int(one) for one in rng.integers([1, 2], [4, 16]))
    tolerance = float(rng.choice([0.5, 1.0, 1.25, 2.0]))
    most = int(rng.integers(1, 9))
    left, right = rng.integers(0, most + 1, (2, height, width)) + rng.choice(
        _PARTS, (2, height, width)
    )
    if rng.random() < 0.5:  # pairs that agree, or nearly
        place = np.clip(np.floor(np.arange(width) - left + 0.5).astype(int), 0, width - 1)
        steps = rng.choice([-tolerance, 0, tolerance, -tolerance - 0.125], left.shape)
        np.put_along_axis(right, place, left + steps, axis=1)
    for picture in (left, right):
        picture[rng.random(picture.shape) < 0.15] = np.nan
    return left.astype(np.float32), right.astype(np.float32), tolerance


def _disparity_to_depth(rng: np.random.Generator) -> tuple[Any, ...]:
    height, width = (int(one) for one in rng.integers(1, 7, size=2))
    disparity = rng.uniform(0.5, 60, (height, width))
    special = rng.random((height, width)) < 0.3
    disparity[special] = rng.choice([0.0, np.nan, -1.0, -0.125, -40.0], np.count_nonzero(special))
    focal = rng.uniform(40, 700, 2)
    K = np.array([[focal[0], 0, rng.uniform(0, 40)], [0, focal[1], rng.uniform(0, 40)], [0, 0, 1]])
    return disparity.astype(np.float32), K, float(rng.uniform(0.02, 0.4))


MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {
    "ssd_disparity": _ssd_disparity,
    "subpixel": _subpixel,
    "lr_check": _lr_check,
    "disparity_to_depth": _disparity_to_depth,
}
