"""Right answers to draw_top_view, written in ways that the card does not contain."""

from typing import Any

import numpy as np


def map_by_sorting(
    points_world: np.ndarray,
    colors: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    pixels_per_meter: int,
) -> np.ndarray:
    order = np.argsort(points_world[:, 2])
    height, width = (round(float(side)) for side in (high - low) * pixels_per_meter)
    picture = np.zeros((height, width, 3), np.uint8)
    for point, color in zip(points_world[order], colors[order], strict=True):
        row, column = ((high - point[:2]) * pixels_per_meter).tolist()
        if 0 <= row < height and 0 <= column < width:
            picture[int(row), int(column)] = 255 * color
    return picture


def map_by_unique(
    points_world: np.ndarray,
    colors: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    pixels_per_meter: int,
) -> np.ndarray:
    size = np.rint((high - low) * pixels_per_meter).astype(int)
    place = np.floor((high - points_world[:, :2]) * pixels_per_meter).astype(int)
    keep = ((place >= 0) & (place < size)).all(axis=1)
    order = np.flatnonzero(keep)[np.argsort(-points_world[keep, 2])]
    flat = place[order] @ [size[1], 1]
    cells, first = np.unique(flat, return_index=True)  # the first is the highest
    picture = np.zeros((size.prod(), 3))
    picture[cells] = colors[order][first] * 255
    return picture.round().astype(np.uint8).reshape(*size, 3)


def map_as_lists(
    points_world: np.ndarray,
    colors: np.ndarray,
    low: np.ndarray,
    high: np.ndarray,
    pixels_per_meter: int,
) -> list[Any]:
    return map_by_unique(points_world, colors, low, high, pixels_per_meter).tolist()


VARIANTS = [map_by_sorting, map_by_unique, map_as_lists]
