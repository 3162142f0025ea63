"""Right answers to find_all_objects, written in ways that the card does not contain."""

from collections.abc import Iterator
from typing import Any

import cv2
import numpy as np

from solutions.find_all_objects import Range


def _split(
    rgb_image: np.ndarray, color_ranges: tuple[Range, ...], min_area: int
) -> Iterator[tuple[str, int, tuple[np.integer, ...]]]:
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(int)
    for name, low, high in color_ranges:
        hue = (hsv[..., 0] - low[0]) % 180 <= (high[0] - low[0]) % 180
        rest = (hsv[..., 1:] >= low[1:]).all(2) & (hsv[..., 1:] <= high[1:]).all(2)
        count, regions = cv2.connectedComponents((hue & rest).astype(np.uint8))
        for number in range(1, count):
            v, u = np.nonzero(regions == number)
            if len(v) >= min_area:
                yield name, len(v), (u.min(), v.min(), np.ptp(u) + 1, np.ptp(v) + 1)


def objects_by_labels(
    rgb_image: np.ndarray, color_ranges: tuple[Range, ...], min_area: int
) -> tuple[tuple[Any, ...], ...]:
    found = sorted(_split(rgb_image, color_ranges, min_area), key=lambda one: -one[1])
    return tuple(zip(*found, strict=True)) or ((), (), ())


def objects_as_arrays(
    rgb_image: np.ndarray, color_ranges: tuple[Range, ...], min_area: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    names, areas, boxes = objects_by_labels(rgb_image, color_ranges, min_area)
    return np.array(names), np.array(areas, np.int32), np.array(boxes)


def objects_by_outlines(
    rgb_image: np.ndarray, color_ranges: tuple[Range, ...], min_area: int
) -> tuple[list[str], list[int], list[list[int]]]:
    # The outline runs through pixel centers: add half of its length and one (Pick's theorem).
    found = []
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    for name, low, high in color_ranges:
        turned = hsv.copy()
        turned[..., 0] = (hsv[..., 0].astype(int) - low[0]) % 180
        mask = cv2.inRange(turned, (0, *low[1:]), ((high[0] - low[0]) % 180, *high[1:]))
        for outline in cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]:
            area = round(cv2.contourArea(outline) + len(outline) / 2 + 1)
            if area >= min_area:
                found.append((area, name, list(cv2.boundingRect(outline))))
    found.sort(reverse=True)
    return [f[1] for f in found], [f[0] for f in found], [f[2] for f in found]


VARIANTS = [objects_by_labels, objects_as_arrays, objects_by_outlines]
