"""Where values stand on an axis, and how far an axis reaches."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

Limits = tuple[float, float]

# An axis, or a color scale, of one value: Matplotlib widens it by this share.
_WIDENED = 0.05
_WIDENED_COLORS = 0.1


@dataclass(frozen=True)
class Axis:
    """One direction of a plot."""

    label: str
    limits: Limits
    log: bool = False

    def to_share(self, values: np.ndarray | float) -> np.ndarray:
        """Return 0 at the lower limit and 1 at the upper; what has no logarithm is at the lower."""
        values = np.asarray(values, float)
        if not self.log:
            low, high = self.limits
            return (values - low) / (high - low)
        low, high = np.log10(self.limits)
        return (np.log10(np.where(values <= 0, self.limits[0], values)) - low) / (high - low)


def get_limits(values: np.ndarray, *, log: bool = False, margin: float = 0.05) -> Limits:
    """Return the limits of an axis: the range of the finite values and a margin on both sides.

    A logarithmic axis leaves out what is not positive; an axis without values is 0 to 1, a
    logarithmic one 1 to 10.
    """
    shown = values[np.isfinite(values) & ((values > 0) | (not log))]
    if not shown.size:
        return (1.0, 10.0) if log else (0.0, 1.0)
    low, high = float(shown.min()), float(shown.max())
    if not log:
        return _add_margin(*widen(low, high), margin)
    low, high = math.log10(low), math.log10(high)
    if low == high:  # the powers of ten around it
        low, high = math.ceil(low) - 1, math.floor(high) + 1
    low, high = _add_margin(low, high, margin)
    return 10**low, 10**high


def _add_margin(low: float, high: float, margin: float) -> Limits:
    return low - margin * (high - low), high + margin * (high - low)


def get_color_limits(values: np.ndarray, limits: Limits | None = None) -> Limits:
    """Return limits for a color scale: without any, the range of the finite values, or 0 to 1."""
    shown = values[np.isfinite(values)]
    if limits is None and not shown.size:
        return 0.0, 1.0
    return widen(*(limits or (float(shown.min()), float(shown.max()))), _WIDENED_COLORS)


def widen(low: float, high: float, share: float = _WIDENED) -> Limits:
    """Make a range of one value wide enough to draw.

    Raises
    ------
    ValueError
        If the limits are in the wrong order, or one is not a number.
    """
    if low < high:
        return low, high
    if low != high:
        raise ValueError(f"limits: expected low <= high, got {low:g} and {high:g}")
    return (low - share * abs(low), high + share * abs(high)) if low else (-share, share)
