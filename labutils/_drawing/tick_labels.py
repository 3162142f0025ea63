"""How numbers along an axis are written: by the rules of Matplotlib's ScalarFormatter."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

import numpy as np

from labutils._drawing.style import MINUS

if TYPE_CHECKING:
    from labutils._drawing.scales import Limits

#: Numbers as small, or as large, as these powers of ten are written with a common factor.
_SMALL, _LARGE = -5, 6
#: A common summand is split off where it saves this many digits.
_SAVED_DIGITS = 4


def write_ticks(values: np.ndarray, limits: Limits) -> tuple[list[str], str]:
    """Write the values of ticks with the same number of digits.

    Parameters
    ----------
    values : ndarray, shape (N,)
        Ticks, also outside the limits.
    limits : (low, high)
        Of the axis.

    Returns
    -------
    texts : list of str
        One per value.
    note : str
        What all have in common, as "1e6" or "+1.5"; empty for most axes.
    """
    low, high = limits
    shown = values[(values >= low) & (values <= high)]
    summand = _find_summand(shown)
    power = _find_power(shown, summand, limits)
    scaled = (values - summand) / 10.0**power
    texts = [f"{0 if abs(x) < 1e-8 else x:.{_find_digits(scaled)}f}" for x in scaled]
    note = f"1e{power}" if power else ""
    if summand:
        note += f"{'+' if summand > 0 else ''}{_write_scientific(summand)}"
    return [text.replace("-", MINUS) for text in texts], note.replace("-", MINUS)


def _find_summand(shown: np.ndarray) -> float:
    """Return what is worth splitting off, else 0."""
    if len(shown) < 2 or shown[0] <= 0 <= shown[-1]:
        return 0.0
    least, most = sorted(abs(float(x)) for x in (shown[0], shown[-1]))
    powers = itertools.count(math.ceil(math.log10(most)), -1)
    power = 1 + next(p for p in powers if least // 10.0**p != most // 10.0**p)
    if (most - least) / 10.0**power <= 1e-2:  # on both sides of a rounder number
        powers = itertools.count(math.ceil(math.log10(most)), -1)
        power = 1 + next(p for p in powers if most // 10.0**p - least // 10.0**p > 1)
    count = most // 10.0**power
    if count < 10 ** (_SAVED_DIGITS - 1):
        return 0.0
    return math.copysign(count * 10.0**power, shown[0])


def _find_power(shown: np.ndarray, summand: float, limits: Limits) -> int:
    """Return the power of ten that all labels are divided by; 0 for most."""
    largest = limits[1] - limits[0] if summand else np.abs(shown).max(initial=0.0)
    power = math.floor(math.log10(largest)) if largest > 0 else 0
    return power if power <= _SMALL or power >= _LARGE else 0


def _find_digits(scaled: np.ndarray) -> int:
    """Return the fewest decimals that tell the values to a thousandth of their range."""
    span = float(np.ptp(scaled)) or float(np.abs(scaled).max()) or 1.0
    power = math.floor(math.log10(span))
    least = 1e-3 * 10.0**power
    digits = max(0, 3 - power)
    while digits >= 0 and np.abs(scaled - np.round(scaled, digits)).max() < least:
        digits -= 1
    return digits + 1


def _write_scientific(value: float) -> str:
    power = math.floor(math.log10(abs(value)))
    factor = round(value / 10.0**power, 10)
    text = f"{factor:.0f}" if factor % 1 == 0 else f"{factor:.10g}"
    return f"{text}e{power}" if power else text
