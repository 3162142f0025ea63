"""Valid input of the exercises on depth images, colors and masks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cv2
import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

#: Depths on both sides of every limit that a statement names, and what is no number.
_SPECIAL = (np.nan, np.inf, -np.inf, 0.0, -1.0, 0.004, 0.01, 0.012, 0.03, 9.9, 10.0, 10.2, 12.0, 40)


def make_depths(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Draw a depth image, float32 meters: surfaces, with few or many special values."""
    depth = rng.uniform(0.3, rng.choice([2.0, 9.0]), size=(height, width)).astype(np.float32)
    where = rng.random((height, width)) < rng.choice([0.0, 0.2, 0.7])
    depth[where] = rng.choice(_SPECIAL, size=np.count_nonzero(where))
    return depth


def make_size(rng: np.random.Generator, most: int) -> tuple[int, int]:
    """Draw height and width."""
    height, width = rng.integers(1, most + 1, size=2)
    return int(height), int(width)


def _process_depth(rng: np.random.Generator) -> tuple[Any, ...]:
    raw = rng.uniform(0, 1, size=make_size(rng, 5))
    where = rng.random(raw.shape) < 0.3
    special = (0, 1, np.nan, -0.3, 1.4, -np.inf, np.inf, -1e-4, 1.0001, 0.999)
    raw[where] = rng.choice(special, size=np.count_nonzero(where))
    kind = rng.choice(["float32", "float64"])
    # Up to a ratio at which float32 loses less than the tolerance.
    near = float(rng.choice([0.02, 0.1, 1.0])) * float(rng.uniform(1, 5))
    return raw.astype(kind), near, near + float(rng.uniform(0.5, 12))


def _visualize_depth(rng: np.random.Generator) -> tuple[Any, ...]:
    depth = make_depths(rng, *make_size(rng, 6))
    if rng.random() < 0.2:
        depth = depth.astype(np.float64)
    return depth, float(rng.uniform(0.5, 15))


def _fill_invalid_depth(rng: np.random.Generator) -> tuple[Any, ...]:
    while True:
        depth = make_depths(rng, *make_size(rng, 7))
        if ((depth > 0.01) & (depth < 10)).any():
            return (depth,)


def _draw_hsv(rng: np.random.Generator, low: Any, high: Any, size: tuple[int, int]) -> np.ndarray:
    """Draw blocks of colors in and around a range, as RGB."""
    hsv = np.empty((*size, 3), np.uint8)
    hsv[:] = (int(rng.integers(180)), 40, 150)
    tops = (179, 255, 255)
    for _ in range(rng.integers(1, 7)):
        near = [
            int(np.clip(rng.choice([a, b]) + rng.integers(-3, 4), 0, top))
            for a, b, top in zip(low, high, tops, strict=True)
        ]
        free = [int(rng.integers(0, top + 1)) for top in tops]
        color = [
            one if rng.random() < 0.7 else other for one, other in zip(near, free, strict=True)
        ]
        top, left = int(rng.integers(-3, size[0])), int(rng.integers(-3, size[1]))
        tall, wide = map(int, rng.integers(1, 12, size=2))
        hsv[max(top, 0) : max(top + tall, 0), max(left, 0) : max(left + wide, 0)] = color
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2RGB)


def _segment_by_color(rng: np.random.Generator) -> tuple[Any, ...]:
    hues = [int(one) for one in rng.integers(0, 180, size=2)]
    if rng.random() < 0.2:
        hues = [int(rng.choice([0, 90, 179])), int(rng.choice([0, 90, 179]))]
    levels = np.sort(rng.choice([0, 60, 90, 120, 200, 254, 255], size=(2, 2)), axis=0)
    low, high = (hues[0], *map(int, levels[0])), (hues[1], *map(int, levels[1]))
    height, width = map(int, rng.integers(1, 22, size=2))
    return _draw_hsv(rng, low, high, (height, width)), (low, high)


def _find_object_centroid(rng: np.random.Generator) -> tuple[Any, ...]:
    while True:
        height, width = make_size(rng, 24)
        mask = np.zeros((height, width), np.uint8)
        for _ in range(rng.integers(0, 4)):
            corners = rng.integers(0, [width, height], size=(int(rng.integers(1, 5)), 2))
            cv2.fillPoly(mask, [corners.astype(np.int32)], 255)
        if rng.random() < 0.3:  # a hole
            top, left = rng.integers(0, height), rng.integers(0, width)
            mask[top : top + 4, left : left + 4] = 0
        outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        areas = sorted((cv2.contourArea(one) for one in outlines), reverse=True)
        if len(areas) > 1 and areas[0] == areas[1] > 0:
            continue  # a tie: the largest is not one of them
        return (mask // 255 * np.uint8(rng.choice([1, 255])),)


def _find_all_objects(rng: np.random.Generator) -> tuple[Any, ...]:
    """Draw bars, L shapes and diagonals of different areas, one in each cell of a grid."""
    cell, rows, columns = 9, *map(int, rng.integers(1, 4, size=2))
    hsv = np.empty((rows * cell, columns * cell, 3), np.uint8)
    hsv[:] = (90, 20, 120)
    ranges = [
        ("red", (170, 110, 80), (6, 255, 255)),
        ("yellow", (22, 110, 80), (34, 255, 255)),
        ("blue", (108, 110, 80), (128, 250, 240)),
    ]
    hues = {"red": (170, 179, 0, 6), "yellow": (22, 30, 34), "blue": (108, 120, 128)}
    shapes: dict[int, np.ndarray] = {}
    while len(shapes) < rows * columns:
        shape = np.zeros((cell - 2, cell - 2), bool)
        tall, wide = map(int, rng.integers(1, cell - 1, size=2))
        shape[:tall, 0] = shape[tall - 1, :wide] = True
        if rng.random() < 0.5:
            shape[:tall, :wide] = True
        elif rng.random() < 0.3:
            shape = np.eye(cell - 2, dtype=bool) & (np.arange(cell - 2) < tall)
        shapes.setdefault(int(shape.sum()), shape)
    for number, shape in enumerate(rng.permutation(np.array(list(shapes.values())))):
        row, column = divmod(number, columns)
        name = str(rng.choice(list(hues)))
        color = (int(rng.choice(hues[name])), int(rng.choice([110, 200, 250])), 200)
        if rng.random() < 0.1:
            color = (color[0], 60, 200)  # too pale for an object
        inside = hsv[row * cell + 1 : (row + 1) * cell - 1, column * cell + 1 : column * cell + 8]
        inside[shape] = color
    chosen = [ranges[one] for one in rng.permutation(3)[: rng.integers(1, 4)]]
    least = int(rng.choice([0, 1, 2, *shapes]))
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2RGB), tuple(chosen), least


MAKERS: dict[str, Callable[[np.random.Generator], tuple[Any, ...]]] = {
    "process_depth": _process_depth,
    "visualize_depth": _visualize_depth,
    "fill_invalid_depth": _fill_invalid_depth,
    "segment_by_color": _segment_by_color,
    "find_object_centroid": _find_object_centroid,
    "find_all_objects": _find_all_objects,
}
