"""Find the order in which two clouds agree: the order of their points carries no meaning."""

from __future__ import annotations

import numpy as np

#: Side of the cells that sort a cloud, in tolerances: large enough that rounding moves few points
#: across a border, small enough that neighbors in a picture seldom share a cell.
_CELL_TOLERANCES = 16

_CELL_WEIGHTS = np.array([73_856_093, 19_349_663_001, 83_492_791], dtype=np.int64)

#: As many points as may be matched each with each: 1500 times 1500 distances take 20 ms.
_MAX_LOOSE_POINTS = 1500


def is_same_on_average(x: np.ndarray, y: np.ndarray, atol: float) -> bool:
    """Compare what does not depend on the order: mean and mean square of every column."""
    for power in (1, 2):
        with np.errstate(invalid="ignore"):  # plus and minus infinity in one column
            mean_x, mean_y = (np.mean(c**power, axis=0, dtype=np.float64) for c in (x, y))
        # The square of a value that is off by atol is off by 2 |value| atol.
        slack = atol if power == 1 else 2 * atol * float(np.abs(x).max(initial=0))
        if not (np.abs(mean_x - mean_y) <= slack + 1e-6 * np.abs(mean_x)).all():
            return False  # also where a point is no number: such clouds have no other order
    return True


def match_points(expected: np.ndarray, yours: np.ndarray, atol: float) -> np.ndarray | None:
    """Find the order in which the rows of `yours` agree with `expected`, or None.

    Points are sorted into cells much larger than the tolerance; a point alone in its cell on both
    sides is a match to verify. What is left (points near a cell border) is matched each with each.
    """
    order = np.full(len(expected), -1, dtype=np.int64)
    cells = np.floor(
        np.concatenate([expected, yours]).astype(np.float64) / (_CELL_TOLERANCES * atol)
    )
    # One number per cell. Should two cells share one, their points are matched each with each.
    _, names = np.unique(cells.astype(np.int64) @ _CELL_WEIGHTS, return_inverse=True)
    names = names.reshape(-1)
    names_x, names_y = names[: len(expected)], names[len(expected) :]
    count_x = np.bincount(names_x, minlength=names.max() + 1)
    count_y = np.bincount(names_y, minlength=names.max() + 1)
    single = (count_x == 1) & (count_y == 1)
    rows_x = np.flatnonzero(single[names_x])
    rows_y = np.flatnonzero(single[names_y])
    rows_y = rows_y[np.argsort(names_y[rows_y])][np.argsort(np.argsort(names_x[rows_x]))]
    close = np.abs(expected[rows_x] - yours[rows_y]).max(axis=1, initial=0) <= atol
    order[rows_x[close]] = rows_y[close]
    loose_x = np.flatnonzero(order < 0)
    loose_y = np.setdiff1d(np.arange(len(yours)), order[order >= 0])
    if len(loose_x) > _MAX_LOOSE_POINTS:
        return None
    matched = _match_each(expected[loose_x], yours[loose_y], atol)
    if matched is None:
        return None
    order[loose_x] = loose_y[matched]
    return order


def _match_each(expected: np.ndarray, yours: np.ndarray, atol: float) -> np.ndarray | None:
    """Return for every expected point the nearest one of yours; None where one has none.

    Of equal points each takes one that is still free.
    """
    nearest = np.zeros(0, dtype=np.int64)
    for some in (expected[:16], expected):  # a few points refute most wrong clouds
        if not len(some):
            return nearest
        gaps = np.abs(some[:, None] - yours[None]).max(axis=2)
        nearest = gaps.argmin(axis=1)
        if gaps[np.arange(len(some)), nearest].max() > atol:
            return None
    if len(np.unique(nearest)) == len(nearest):
        return nearest
    for row, distances in enumerate(gaps):
        nearest[row] = distances.argmin()
        if distances[nearest[row]] > atol:
            return None
        gaps[:, nearest[row]] = np.inf
    return nearest
