"""What the matching explorer is given, and how it is drawn for print."""

from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any

import cv2
import numpy as np

from labutils._guards import check_real_array, check_rgb_image
from labutils.explorers._window_match import DISPARITY_STEP

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Rows of the right picture that are shown, by those of the left one.
STRIP_SHARE = 0.3
_MAX_STEPS = 65535
#: Posters of larger pictures are made smaller: noise makes them heavy.
_POSTER_WIDTH = 320
#: White, and Okabe and Ito's orange and bluish green.
_WHITE, _FOUND, _TRUE = (255, 255, 255), (230, 159, 0), (0, 158, 115)


def make_gray_pair(left: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return two pictures of one size in gray, uint8 (H, W), or raise TypeError or ValueError."""
    pair = _to_gray("left", left), _to_gray("right", right)
    if pair[0].shape != pair[1].shape:
        raise ValueError(f"right: expected the size of left, {pair[0].shape}, got {pair[1].shape}")
    return pair


def _to_gray(name: str, picture: np.ndarray) -> np.ndarray:
    gray = np.asarray(picture)
    if gray.ndim != 2:
        gray = cv2.cvtColor(check_rgb_image(name, gray), cv2.COLOR_RGB2GRAY)
    if gray.dtype != np.uint8 or not gray.size:
        got = f"{gray.dtype} of shape {gray.shape}"
        raise ValueError(f"{name}: expected uint8 with at least one pixel, got {got}")
    return gray


def encode_noisy(gray: np.ndarray) -> bytes:
    """Compress a gray picture, losing nothing; in its noise no run of bytes comes twice."""
    filtered = (cv2.IMWRITE_PNG_STRATEGY, cv2.IMWRITE_PNG_STRATEGY_FILTERED)
    return cv2.imencode(".png", gray, [cv2.IMWRITE_PNG_COMPRESSION, 9, *filtered])[1].tobytes()


def disparity_to_steps(disparity: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Count disparity in steps of `DISPARITY_STEP`: uint16 (H, W), 0 for none, or out of range."""
    pixels = check_real_array("truth", disparity).astype(np.float64)
    if pixels.shape != shape:
        raise ValueError(f"truth: expected the size of left, {shape}, got {pixels.shape}")
    steps = np.round(np.where(np.isfinite(pixels), pixels, 0.0) / DISPARITY_STEP)
    steps[(steps < 0) | (steps > _MAX_STEPS)] = 0
    return steps.astype(np.uint16)


def check_whole(name: str, value: Any, limits: tuple[int, int]) -> int:
    """Return a whole number within limits, both included, or raise TypeError or ValueError."""
    low, high = limits
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{name}: expected a whole number, got {type(value).__name__} {value!r}")
    number = int(value)
    if not low <= number <= high:
        raise ValueError(f"{name}: expected {low} to {high}, got {value}")
    return number


def draw_match(
    pictures: tuple[np.ndarray, np.ndarray],
    pixel: Sequence[int],
    window: int,
    found: int | None,
    true: int | None,
) -> np.ndarray:
    """Draw the left picture with its window, and below it a strip of the right one with both."""
    (left, right), (u, v) = pictures, pixel
    height, width = left.shape[:2]
    rows = min(height, max(1, round(STRIP_SHARE * height)))
    first = min(height - rows, max(0, v - rows // 2))
    strip = np.ascontiguousarray(right[first : first + rows])
    _mark(left, u, v, window, _WHITE)
    for disparity, color in ((true, _TRUE), (found, _FOUND)):
        if disparity is not None:
            _mark(strip, u - disparity, v - first, window, color)
    poster = np.vstack([left, np.full((4, width, 3), 255, np.uint8), strip])
    shrink = max(1, width // _POSTER_WIDTH)
    return cv2.resize(poster, None, fx=1 / shrink, fy=1 / shrink, interpolation=cv2.INTER_AREA)


def _mark(picture: np.ndarray, u: int, v: int, window: int, color: tuple[int, int, int]) -> None:
    """Draw a frame around a window, black outside and colored inside, which covers none of it."""
    for ink, reach in (((0, 0, 0), window // 2 + 2), (color, window // 2 + 1)):
        cv2.rectangle(picture, (u - reach, v - reach), (u + reach, v + reach), ink, 1)
