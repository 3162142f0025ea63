"""Read a color-mapped picture back as the numbers it shows, whichever map was used."""

from __future__ import annotations

from functools import cache, lru_cache

import cv2
import numpy as np

#: How far a color may lie from its color map, in levels of 255: rounding in the making of the map.
_MAP_LEVELS = 3

#: More colors than this are no map of 256 steps, however it was drawn.
_MAX_MAP_COLORS = 1024

#: The level of a black pixel: further from every true level than any tolerance.
BLACK_LEVEL = -64


@cache
def get_color_maps() -> tuple[np.ndarray, ...]:
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
    for table in get_color_maps():
        gaps = np.abs(colors[:, None] - table[None]).max(axis=2)
        if (gaps.min(axis=1)[~black] <= _MAP_LEVELS).all():
            levels = np.where(black, BLACK_LEVEL, gaps.argmin(axis=1)).astype(np.int16)
            levels = levels[where.reshape(-1)].reshape(shape)
            levels.setflags(write=False)
            return levels
    return None
