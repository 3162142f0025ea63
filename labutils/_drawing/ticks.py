"""Round numbers along an axis, and how they are written: by Matplotlib's rules."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from labutils._drawing.style import MINUS, TIMES
from labutils._drawing.tick_labels import write_ticks

if TYPE_CHECKING:
    from labutils._drawing.scales import Axis, Limits

_ROUND_STEPS = np.array([1, 2, 2.5, 5, 10])
_MOST_TICKS = 9
#: From here on, numbers are far from zero: their size over their range.
_FAR = 100
_MOST_DECADES_WITH_MULTIPLES = 10
#: Below so many decades, every multiple of a power of ten has a label.
_SHORT_LOG_AXIS = 0.4
_ROUNDING = 1e-9


class Label(NamedTuple):
    """What stands at a tick: a text, and perhaps an exponent above it."""

    text: str
    exponent: str = ""


class Ticks(NamedTuple):
    """Ticks of an axis: values with their labels, values without, and what all labels share."""

    values: np.ndarray
    labels: list[Label]
    minor: np.ndarray
    note: str = ""


def make_ticks(axis: Axis, most: int) -> Ticks:
    """Choose the ticks of an axis that has room for `most` labels."""
    if axis.log:
        return _make_log_ticks(axis.limits, min(max(most, 2), _MOST_TICKS))
    return _make_even_ticks(axis.limits, min(max(most, 1), _MOST_TICKS))


def _make_even_ticks(limits: Limits, intervals: int) -> Ticks:
    low, high = limits
    values = find_round_values(low, high, intervals)
    texts, note = write_ticks(values, limits)
    inside = (values >= low) & (values <= high)
    labels = [Label(text) for text, shown in zip(texts, inside, strict=True) if shown]
    return Ticks(values[inside], labels, np.empty(0), note)


def find_round_values(low: float, high: float, intervals: int) -> np.ndarray:
    """Return evenly spaced round values in steps of 1, 2, 2.5 or 5 times a power of ten.

    Parameters
    ----------
    low, high : float
        Limits of the axis, low < high.
    intervals : int
        At most this many.

    Returns
    -------
    ndarray, shape (N,)
        At least two lie inside the limits; the first and the last may lie just outside.
    """
    middle, span = (low + high) / 2, high - low
    # Far from zero, steps are counted from a round number near by: less is lost to rounding.
    far = abs(middle) / span >= _FAR
    offset = math.copysign(10 ** math.floor(math.log10(abs(middle))), middle) if far else 0.0
    scale = 10.0 ** math.floor(math.log10(span / intervals))
    steps = scale * np.concatenate([0.1 * _ROUND_STEPS[:-1], _ROUND_STEPS, [20]])
    start, end = low - offset, high - offset
    largest = int(np.argmax(steps >= span / intervals))
    ticks = np.empty(0)
    for step in steps[largest::-1]:
        first = start // step * step
        slack = _find_slack(step, offset)
        count = math.ceil((end - first) / step - slack)
        skipped = math.floor((start - first) / step + slack)
        ticks = np.arange(skipped, count + 1) * step + first
        if ((ticks >= start) & (ticks <= end)).sum() >= 2:
            break
    return ticks + offset


def _find_slack(step: float, offset: float) -> float:
    """Return the share of a step by which rounding may move a limit."""
    if not offset:
        return 1e-10
    return min(0.4999, max(1e-10, 10 ** (math.log10(abs(offset) / step) - 12)))


def _make_log_ticks(limits: Limits, most: int) -> Ticks:
    """Mark powers of ten; between them, if all of them have room, their multiples."""
    low, high = (float(x) for x in np.log10(limits))
    first, last = math.ceil(low), math.floor(high)
    powers = _choose_powers(first, last, most)
    multiples: np.ndarray = np.empty(0)
    if len(powers) == last - first + 1 < _MOST_DECADES_WITH_MULTIPLES:
        decades = 10.0 ** np.arange(first - 1, last + 1)
        multiples = (decades[:, None] * np.arange(2, 10)).ravel()
        multiples = multiples[(multiples >= limits[0]) & (multiples <= limits[1])]
    if len(powers) + len(multiples) <= 1:
        return _make_even_ticks(limits, _MOST_TICKS)
    values = np.sort(np.concatenate([10.0 ** np.array(powers, float), multiples]))
    labels = [_write_power(value) for value in values]
    written = _choose_factors(len(powers), high - low)
    chosen = np.array([factor in written for factor, _ in labels], bool)
    texts = [label for factor, label in labels if factor in written]
    return Ticks(values[chosen], texts, values[~chosen])


def _choose_factors(powers: int, decades: float) -> set[int]:
    """Choose which multiples of a power of ten get labels: one power alone gives no scale."""
    if powers > 1:
        return {1}
    return {1, 2, 3, 4, 6} if decades > _SHORT_LOG_AXIS else set(range(1, 10))


def _write_power(value: float) -> tuple[int, Label]:
    """Return the factor before the power of ten, and the label."""
    power = math.floor(math.log10(value) + _ROUNDING)
    factor = round(value / 10.0**power)
    text = "10" if factor == 1 else f"{factor}{TIMES}10"
    return factor, Label(text, str(power).replace("-", MINUS))


def _choose_powers(first: int, last: int, most: int) -> range:
    """Choose at most so many powers of ten from `first` to `last`, evenly spaced."""
    available = last - first + 1
    stride = available // (most + 1) + 1
    count = min(math.ceil(available / stride), most)
    if count < 2:
        return range(first, last + 1, max(available, 1))
    # The widest stride with as many ticks; at multiples of it, if that costs none.
    stride = (available - 1) // (count - 1)
    if stride < available / count:
        stride = available // count
    least = max(available - stride * count, 0)
    beyond = min(available - stride * (count - 1), stride)
    offset = -first % stride
    start = first + (offset if least <= offset < beyond else least)
    return range(start, last + 1, stride)
