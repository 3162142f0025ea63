"""Paint a depth image and count its pixels, for the views that show depth.

Depth is kept in whole steps of `DEPTH_STEP`, as it travels: the page counts the same pixels.
"""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np

from labutils._constants import MAX_DEPTH, MIN_DEPTH
from labutils._guards import check_depth_image
from labutils.depth_values import find_valid_depth
from labutils.explorers._base import DEPTH_STEP, decode_depth

#: Which kind of pixel it is.
NEARER, INSIDE, FARTHER, NO_SURFACE = range(4)

#: Name and OpenCV's code; gray has none.
COLOR_MAPS = {"turbo": cv2.COLORMAP_TURBO, "viridis": cv2.COLORMAP_VIRIDIS, "gray": None}

# the darkest gray of a surface: black stays for what is none
_DARKEST = 48

#: Two colors each, RGB: stripes are in no color map.
STRIPES = {
    NEARER: ((255, 255, 255), (214, 60, 140)),
    FARTHER: ((200, 200, 200), (140, 140, 140)),
}


class Limits(NamedTuple):
    """A lower and an upper limit in steps."""

    low: int
    high: int


def to_step(meters: float) -> int:
    """Return the step that holds a number of meters; halves go up, as in JavaScript."""
    return int(np.floor(meters / DEPTH_STEP + 0.5))


#: The limits of `labutils.find_valid_depth` in steps, both excluded: the page compares steps, so
#: that no rounding to float stands between it and Python.
VALID_STEPS = Limits(to_step(MIN_DEPTH), to_step(MAX_DEPTH))


def decode_steps(png: bytes) -> np.ndarray:
    """Read a depth image as whole steps, int64 (H, W)."""
    return np.round(decode_depth(png).astype(np.float64) / DEPTH_STEP).astype(np.int64)


def check_has_surface(depth_metric: np.ndarray) -> np.ndarray:
    """Return a depth image that holds at least one surface, or raise ValueError."""
    depth = check_depth_image("depth_metric", depth_metric)
    if not find_valid_depth(depth).any():
        raise ValueError(
            f"depth_metric: expected a surface between {MIN_DEPTH:g} and {MAX_DEPTH:g} m, got none"
        )
    return depth


def is_surface(steps: np.ndarray) -> np.ndarray:
    """Mark the pixels that see a surface."""
    return (steps > VALID_STEPS.low) & (steps < VALID_STEPS.high)


def find_kinds(steps: np.ndarray, limits: Limits) -> np.ndarray:
    """Tell which kind each pixel is: an array of `NEARER`, `INSIDE`, `FARTHER`, `NO_SURFACE`."""
    kinds = np.full(steps.shape, INSIDE)
    kinds[steps < limits.low] = NEARER
    kinds[steps > limits.high] = FARTHER
    kinds[~is_surface(steps)] = NO_SURFACE
    return kinds


def make_color_tables() -> bytes:
    """Join the 256 RGB colors of every map in `COLOR_MAPS`: OpenCV's, and a ramp of grays."""
    places = np.arange(256, dtype=np.uint8)[:, None]
    grays = np.linspace(_DARKEST, 255, 256).round().astype(np.uint8)[:, None]
    tables = [
        np.repeat(grays, 3, axis=1)
        if code is None
        else cv2.applyColorMap(places, code)[:, 0, ::-1]  # BGR to RGB
        for code in COLOR_MAPS.values()
    ]
    return np.ascontiguousarray(tables).tobytes()


def paint_depth(steps: np.ndarray, near: float, far: float, color_map: int) -> np.ndarray:
    """Color a depth image: uint8 RGB (H, W, 3), black where there is no surface.

    The colors spread from `near` to `far`; with `near` 0 they are those of
    `labutils.visualize_depth`. Nearer pixels have stripes that lean left, farther ones stripes
    that lean right.
    """
    table = np.frombuffer(make_color_tables(), np.uint8).reshape(-1, 256, 3)[color_map]
    share = (steps * DEPTH_STEP - near) / (far - near) if far > near else np.zeros(steps.shape)
    rgb = table[(np.clip(share, 0, 1) * 255).astype(np.uint8)]
    kinds = find_kinds(steps, Limits(to_step(near), to_step(far)))
    v, u = np.mgrid[: steps.shape[0], : steps.shape[1]]
    for kind, across in ((NEARER, u + v), (FARTHER, u - v)):
        chosen = kinds == kind
        rgb[chosen] = np.array(STRIPES[kind], np.uint8)[(across[chosen] >> 3) & 1]
    rgb[kinds == NO_SURFACE] = 0
    return rgb
