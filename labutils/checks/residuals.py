"""Say how an answer is off without saying what is right.

Of many numbers (a picture, a cloud) the message tells how many are off, to which side and by how
much typically. Of few numbers (a matrix, a pixel) it tells which, to which side and roughly by
which share: "off by 12.5" would give the right number away.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labutils.checks.compare import get_differences, to_levels

if TYPE_CHECKING:
    from collections.abc import Sequence

    from labutils.checks.table import Part

_AXES = ("x", "y", "z")
_COLUMNS: dict[str, Sequence[str]] = {
    "attached": "RGB",
    "pixels": "uv",
    "boxes": ("left", "top", "width", "height"),
}


def describe_residual(
    part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
) -> str:
    """Describe how `yours` is off where `wrong` is marked."""
    if part.kind in ("choice", "flags", "names"):
        return _describe_choices(part, expected, yours, wrong)
    if part.kind in ("number", "matrix", "pixel", "vector"):
        return _describe_few(part, expected, yours, wrong)
    if part.kind in ("rows", "cloud", "attached", "pixels", "boxes", "list"):
        return _describe_rows(part, expected, yours, wrong)
    return _describe_picture(part, expected, yours, wrong)


def _describe_choices(
    part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
) -> str:
    if part.kind == "choice":
        return f"{part.name} is not the right one."
    count = np.count_nonzero(wrong)
    if part.kind == "names":
        return f"{count} of {wrong.size} {part.name} are not the right ones."
    extra = np.count_nonzero(wrong & yours & ~expected)
    return (
        f"{part.name}: {count} of {wrong.size} are wrong: {extra} True that should be False, "
        f"{count - extra} False that should be True."
    )


def _describe_few(part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray) -> str:
    texts = []
    for place in zip(*np.nonzero(np.atleast_1d(wrong)), strict=True):
        x = float(np.atleast_1d(expected)[place])
        y = float(np.atleast_1d(yours)[place])
        texts.append(f"{_name_place(part, place)} is {_describe_side(x, y)}")
    shown = "; ".join(texts[:3])
    more = f"; and {len(texts) - 3} more" if len(texts) > 3 else ""
    return f"{shown}{more}."


def _name_place(part: Part, place: tuple[int, ...]) -> str:
    if part.kind == "matrix":
        return f"{part.name}[{place[0]}, {place[1]}]"
    if part.kind == "pixel":
        return _AXES[place[0]]
    if part.kind == "vector":
        return f"{part.name}[{place[0]}]"
    return part.name


def _describe_side(expected: float, yours: float) -> str:
    if not np.isfinite(yours):
        return "no finite number"
    if expected == 0:
        return "not zero, as it has to be"
    if yours == 0:
        return "zero"
    if (expected < 0) != (yours < 0):
        return "of the wrong sign"
    side = "large" if abs(yours) > abs(expected) else "small"
    share = abs(yours - expected) / abs(expected)
    for limit, words in ((0.001, "less than 0.1 %"), (0.01, "less than 1 %"), (0.1, "1 to 10 %")):
        if share < limit:
            return f"too {side} by {words}"
    return f"too {side} by more than 10 %"


def _describe_rows(part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray) -> str:
    unit = f" {part.unit}" if part.unit else ""
    if part.kind == "list":  # one column without a name
        expected, yours, wrong = expected[:, None], yours[:, None], wrong[:, None]
    columns: Sequence[str] = _COLUMNS.get(part.kind, _AXES)
    texts = []
    for axis in np.flatnonzero(wrong.any(axis=0)):
        gaps = np.abs(get_differences(part, expected[:, axis], yours[:, axis]))
        finite = gaps[np.isfinite(gaps) & wrong[:, axis]]
        count = np.count_nonzero(wrong[:, axis])
        typical = f", typically by {_round(np.median(finite))}{unit}" if len(finite) > 1 else ""
        where = f"{count} of {len(wrong)}"
        if part.kind == "list":
            return f"{where} values of {part.name} are off{typical}."
        texts.append(f"{columns[int(axis)]} in {where} rows{typical}")
    return f"{part.name}: off are {'; '.join(texts)}."


def _describe_picture(
    part: Part, expected: np.ndarray, yours: np.ndarray, wrong: np.ndarray
) -> str:
    off = wrong.any(axis=2) if wrong.ndim == 3 else wrong
    count = np.count_nonzero(off)
    if part.kind == "mapped" and to_levels(yours).ndim == 3:
        return (
            f"{part.name}: these colors belong neither to COLORMAP_TURBO nor to COLORMAP_JET nor "
            "to a straight ramp from blue to red."
        )
    start = f"{count} of {off.size} pixels of {part.name} are off"
    difference = get_differences(part, expected, yours)[wrong]
    if part.kind == "mask":
        extra = np.count_nonzero(difference > 0)
        return f"{start}: {extra} marked that should not be, {count - extra} missing."
    finite = difference[np.isfinite(difference)]
    lost = np.count_nonzero(~np.isfinite(difference))
    texts = [f"{lost} of them are NaN or infinite on one side only"] if lost else []
    if len(finite) > 1:
        share = np.count_nonzero(finite > 0) / len(finite)
        side = "too large" if share > 0.9 else "too small" if share < 0.1 else "to both sides"
        unit = f" {part.unit}" if part.unit else ""
        texts.append(f"{side}, typically by {_round(np.median(np.abs(finite)))}{unit}")
    return f"{start}{': ' if texts else ''}{'; '.join(texts)}."


def _round(value: float) -> str:
    """Write a number with one digit that counts: 0.04, 3, 200."""
    return np.format_float_positional(float(f"{value:.1g}"), trim="-")


def find_worst_pixel(part: Part, expected: np.ndarray, yours: np.ndarray) -> tuple[int, int] | None:
    """Return (u, v) of the pixel that is off most, or None where the sizes differ."""
    if expected.shape != yours.shape:
        return None
    gaps = np.abs(get_differences(part, expected, yours))
    if gaps.ndim == 3:
        gaps = gaps.max(axis=2)
    v, u = np.unravel_index(int(np.argmax(gaps)), gaps.shape)
    return int(u), int(v)
