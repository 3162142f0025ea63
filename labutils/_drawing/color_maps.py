"""Paint one channel in the color maps of the figures, as Matplotlib does."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import cv2
import numpy as np

if TYPE_CHECKING:
    from labutils._drawing.parts import ColorMap
    from labutils._drawing.scales import Limits

_SIZE = 256

#: ColorBrewer's RdBu from its blue end: eleven colors, evenly spaced.
_RED_WHITE_BLUE = np.array(
    [
        [5, 48, 97],
        [33, 102, 172],
        [67, 147, 195],
        [146, 197, 222],
        [209, 229, 240],
        [247, 247, 247],
        [253, 219, 199],
        [244, 165, 130],
        [214, 96, 77],
        [178, 24, 43],
        [103, 0, 31],
    ]
)


@cache
def get_table(name: ColorMap) -> np.ndarray:
    """Return the 256 colors of a map: uint8 RGB, shape (256, 3)."""
    steps = np.arange(_SIZE, dtype=np.uint8)
    if name == "turbo":
        table = cv2.applyColorMap(steps[:, None], cv2.COLORMAP_TURBO)[:, 0, ::-1]  # BGR to RGB
    elif name == "RdBu_r":
        places = np.linspace(0, 1, len(_RED_WHITE_BLUE))
        at = np.linspace(0, 1, _SIZE)
        channels = [np.interp(at, places, channel) for channel in _RED_WHITE_BLUE.T]
        table = np.stack(channels, axis=1).round().astype(np.uint8)
    else:
        table = np.repeat(steps[:, None], 3, axis=1)
    table.setflags(write=False)
    return table


def find_steps(values: np.ndarray, limits: Limits) -> np.ndarray:
    """Return the place in the table of every value: uint8; what is not finite gets 0."""
    low, high = limits
    span = high - low or np.inf  # one value only: the first color
    shares = np.nan_to_num((values.astype(np.float64) - low) / span, nan=0, posinf=0, neginf=0)
    return np.clip(shares * _SIZE, 0, _SIZE - 1).astype(np.uint8)


def paint(values: np.ndarray, name: ColorMap, limits: Limits | None = None) -> np.ndarray:
    """Color one channel.

    Parameters
    ----------
    values : ndarray, real or bool, shape (H, W)
        One channel.
    name : "gray", "turbo" or "RdBu_r"
        The color map.
    limits : (low, high), optional
        Values of the first and the last color; without it the range of the finite values.

    Returns
    -------
    ndarray, uint8, shape (H, W, 3) or (H, W, 4)
        RGB; RGBA, transparent where a value is not finite, if there is such a value.
    """
    finite = np.isfinite(values)
    if limits is None:
        shown = values[finite].astype(np.float64)
        limits = (shown.min(), shown.max()) if shown.size else (0.0, 1.0)
    rgb = get_table(name)[find_steps(values, limits)]
    if finite.all():
        return rgb
    return np.dstack([rgb, np.where(finite, np.uint8(255), np.uint8(0))])


def to_bytes(pixels: np.ndarray) -> np.ndarray:
    """Return RGB or RGBA as uint8: real numbers from 0 to 1, or whole ones from 0 to 255."""
    if pixels.dtype.kind == "f":
        pixels = 255 * np.nan_to_num(pixels)
    return np.clip(pixels, 0, 255).astype(np.uint8)
