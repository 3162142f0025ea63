"""When two answers are the same.

The same comparison decides whether an answer is right and whether it equals a known wrong one, so
that neither is judged more strictly than the other.
"""

from __future__ import annotations

from functools import cache, lru_cache

import cv2
import numpy as np

from labutils.checks.table import Misfit, Outcome, Part, Parts, Raised

#: Side of the cells that sort a cloud, in tolerances: large enough that rounding moves few points
#: across a border, small enough that neighbors in a picture seldom share a cell.
_CELL_TOLERANCES = 16

_CELL_WEIGHTS = np.array([73_856_093, 19_349_663_001, 83_492_791], dtype=np.int64)

#: About as many values of a large answer are looked at first.
_SAMPLES = 8192

#: As many points as may be matched each with each: 1500 times 1500 distances take 20 ms.
_MAX_LOOSE_POINTS = 1500

#: How far a color may lie from its color map, in levels of 255: rounding in the making of the map.
_MAP_LEVELS = 3

#: More colors than this are no map of 256 steps, however it was drawn.
_MAX_MAP_COLORS = 1024

#: The level of a black pixel: further from every true level than any tolerance.
BLACK_LEVEL = -64


def is_same_outcome(parts: tuple[Part, ...], a: Outcome, b: Outcome) -> bool:
    """Tell whether two answers to one case are the same within the tolerances."""
    if isinstance(a, Misfit) or isinstance(b, Misfit):
        return a == b
    if isinstance(a, Raised) or isinstance(b, Raised):
        return isinstance(a, Raised) and isinstance(b, Raised) and _is_same_error(a, b)
    if not _is_alike(a, b):
        return False
    b = align_rows(parts, a, b)
    return all(is_close(part, x, y) for part, x, y in zip(parts, a, b, strict=True))


def _is_same_error(a: Raised, b: Raised) -> bool:
    # A TypeError comes of any wrong call, so its words have to agree too. The words of others
    # differ between versions of Python.
    return a.kind == b.kind and (a.kind != "TypeError" or a.text == b.text)


def _is_alike(a: Parts, b: Parts) -> bool:
    """Compare what is cheap: None, whole or broken numbers, and shapes."""
    for x, y in zip(a, b, strict=True):
        if x is None or y is None:
            if x is not y:
                return False
        elif x.shape != y.shape or any(
            (x.dtype.kind == kind) != (y.dtype.kind == kind) for kind in "fU"
        ):
            return False
    return True


def _is_cloud_alike(x: np.ndarray, y: np.ndarray, atol: float) -> bool:
    """Compare what does not depend on the order: mean and mean square of every column."""
    for power in (1, 2):
        with np.errstate(invalid="ignore"):  # plus and minus infinity in one column
            mean_x, mean_y = (np.mean(c**power, axis=0, dtype=np.float64) for c in (x, y))
        # The square of a value that is off by atol is off by 2 |value| atol.
        slack = atol if power == 1 else 2 * atol * float(np.abs(x).max(initial=0))
        if not (np.abs(mean_x - mean_y) <= slack + 1e-6 * np.abs(mean_x)).all():
            return False  # also where a point is no number: such clouds have no other order
    return True


def get_differences(part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
    """Return yours minus expected; infinite where one of the two is no number."""
    if part.dtype == "str":
        return np.asarray(expected != yours).astype(np.int32)
    if part.kind == "mapped":
        expected, yours = to_levels(expected), to_levels(yours)
        if expected.shape != yours.shape:  # colors of no known map: nothing agrees
            return np.full(yours.shape[:2], np.inf)
    if expected.dtype.kind in "biu" and yours.dtype.kind in "biu":
        # Pictures of small numbers are compared in small numbers: it is several times as fast.
        wide = np.int32 if max(expected.itemsize, yours.itemsize) <= 2 else np.int64
        return yours.astype(wide) - expected.astype(wide)
    x, y = expected.astype(np.float64), yours.astype(np.float64)
    # Equal infinities and NaN at the same place agree.
    agree = (x == y) | (np.isnan(x) & np.isnan(y))
    with np.errstate(invalid="ignore"):
        difference = np.where(agree, 0.0, y - x)
    return np.where(np.isnan(difference), np.inf, difference)


def find_wrong(part: Part, expected: np.ndarray, yours: np.ndarray) -> np.ndarray:
    """Mark the values that are off by more than the tolerance."""
    # A billionth of slack: the tolerance itself, computed in binary, must not count as more.
    return np.abs(get_differences(part, expected, yours)) > part.atol * (1 + 1e-9)


def is_close(part: Part, expected: np.ndarray | None, yours: np.ndarray | None) -> bool:
    """Tell whether one part agrees within its tolerance; shapes have to agree already."""
    if expected is None or yours is None:
        return expected is yours
    if expected.size > 2 * _SAMPLES and part.kind != "mapped":
        # Every n-th value refutes most wrong answers: there are never fewer wrong ones in all.
        step = expected.size // _SAMPLES
        some = find_wrong(part, expected.ravel()[::step], yours.ravel()[::step])
        if np.count_nonzero(some) > part.share * expected.size:
            return False
    wrong = find_wrong(part, expected, yours)
    return bool(np.count_nonzero(wrong) <= part.share * wrong.size)


def align_rows(parts: tuple[Part, ...], expected: Parts, yours: Parts) -> Parts:
    """Bring the points of a cloud, and what is attached to them, into the expected order.

    The order of a cloud carries no meaning. Returns `yours` as it is where no order makes the
    points agree.
    """
    for index, part in enumerate(parts):
        x, y = expected[index], yours[index]
        if part.kind != "cloud" or x is None or y is None or x.shape != y.shape:
            continue
        if is_close(part, x, y) or not _is_cloud_alike(x, y, part.atol):
            continue
        order = match_points(x, y, part.atol)
        if order is not None:
            moved = {"cloud", "attached"}
            return tuple(
                value[order]
                if value is not None and one.kind in moved and len(value) == len(order)
                else value
                for one, value in zip(parts, yours, strict=True)
            )
    return yours


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
    """Return for every expected point its nearest one of yours; None where one has none."""
    nearest = np.zeros(0, dtype=np.int64)
    for some in (expected[:16], expected):  # a few points refute most wrong clouds
        if not len(some):
            return nearest
        gaps = np.abs(some[:, None] - yours[None]).max(axis=2)
        nearest = gaps.argmin(axis=1)
        if gaps[np.arange(len(some)), nearest].max() > atol:
            return None
    return nearest if len(np.unique(nearest)) == len(nearest) else None


@cache
def _get_color_maps() -> tuple[np.ndarray, ...]:
    """Return the maps from blue to red a picture may use, each (256, 3), BGR."""
    ramp = np.arange(256, dtype=np.uint8).reshape(-1, 1)
    known = [cv2.applyColorMap(ramp, code) for code in (cv2.COLORMAP_TURBO, cv2.COLORMAP_JET)]
    straight = np.concatenate([255 - ramp, 0 * ramp, ramp], axis=1).astype(np.int32)
    return (*(table.reshape(256, 3).astype(np.int32) for table in known), straight)


def to_levels(image_bgr: np.ndarray) -> np.ndarray:
    """Read a color-mapped picture back: int16 levels 0 to 255, `BLACK_LEVEL` where it is black.

    Which map from blue to red was used makes no difference. A picture of no known map comes back
    as it is, (H, W, 3); so does what is no color picture.
    """
    if image_bgr.ndim != 3 or image_bgr.shape[2] != 3 or image_bgr.dtype != np.uint8:
        return image_bgr
    levels = _find_levels(image_bgr.tobytes(), image_bgr.shape[:2])
    return image_bgr if levels is None else levels


@lru_cache(maxsize=16)  # message, picture and recognition ask for the same two pictures
def _find_levels(image_bytes: bytes, shape: tuple[int, int]) -> np.ndarray | None:
    pixels = np.frombuffer(image_bytes, dtype=np.uint8).reshape(-1, 3)
    keys, where = np.unique(
        pixels @ np.array([1 << 16, 1 << 8, 1], dtype=np.int32), return_inverse=True
    )
    if len(keys) > _MAX_MAP_COLORS:
        return None
    colors = np.stack([keys >> 16, keys >> 8 & 255, keys & 255], axis=1)
    black = keys == 0
    for table in _get_color_maps():
        gaps = np.abs(colors[:, None] - table[None]).max(axis=2)
        if (gaps.min(axis=1)[~black] <= _MAP_LEVELS).all():
            levels = np.where(black, BLACK_LEVEL, gaps.argmin(axis=1)).astype(np.int16)
            levels = levels[where.reshape(-1)].reshape(shape)
            levels.setflags(write=False)
            return levels
    return None


def to_canonical(parts: tuple[Part, ...], outcome: Outcome) -> Outcome:
    """Bring an answer into the form that comparing needs, so that this is done once."""
    if isinstance(outcome, Raised | Misfit):
        return outcome
    return tuple(
        to_levels(value) if part.kind == "mapped" and value is not None else value
        for part, value in zip(parts, outcome, strict=True)
    )
