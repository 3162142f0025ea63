"""Right answers to lr_check, written in ways that the card does not contain."""

import numpy as np


def pixel_by_pixel(
    disparity_left: np.ndarray, disparity_right: np.ndarray, tolerance: float = 1.0
) -> list[list[bool]]:
    height, width = disparity_left.shape
    kept = [[False] * width for _ in range(height)]
    for v in range(height):
        for u in range(width):
            d = float(disparity_left[v, u])
            if np.isnan(d):
                continue
            partner = round(u - d)
            if 0 <= partner < width:
                kept[v][u] = abs(float(disparity_right[v, partner]) - d) <= tolerance
    return kept


def by_index_arrays(
    disparity_left: np.ndarray, disparity_right: np.ndarray, tolerance: float = 1.0
) -> np.ndarray:
    kept = np.zeros(disparity_left.shape, dtype=bool)
    v, u = np.nonzero(~np.isnan(disparity_left))
    d = disparity_left[v, u]
    partner = np.rint(u - d).astype(int)
    inside = (partner >= 0) & (partner < disparity_left.shape[1])
    v, u, d, partner = v[inside], u[inside], d[inside], partner[inside]
    kept[v, u] = np.isclose(disparity_right[v, partner], d, rtol=0, atol=tolerance + 1e-9)
    return kept


def by_padding(
    disparity_left: np.ndarray, disparity_right: np.ndarray, tolerance: float = 1.0
) -> np.ndarray:
    # A column of NaN stands for all that lies outside.
    width = disparity_right.shape[1]
    wider = np.pad(disparity_right, ((0, 0), (0, 1)), constant_values=np.nan)
    place = np.arange(width) - disparity_left
    place = np.where(np.isnan(place), -1, np.round(place)).astype(int)
    place[(place < 0) | (place >= width)] = width
    there = np.take_along_axis(wider, place, axis=1)
    with np.errstate(invalid="ignore"):
        return ~((there - disparity_left) ** 2 > tolerance**2) & ~np.isnan(there)


def by_scattering(
    disparity_left: np.ndarray, disparity_right: np.ndarray, tolerance: float = 1.0
) -> np.ndarray:
    # Row by row, in single precision.
    kept = []
    limit = np.float32(tolerance)
    for mine, other in zip(
        disparity_left.astype(np.float32), disparity_right.astype(np.float32), strict=True
    ):
        columns = np.arange(len(mine), dtype=np.float32) - np.nan_to_num(mine, nan=1e6)
        columns = np.rint(columns)
        usable = (columns > -1) & (columns < len(mine))
        row = np.zeros(len(mine), dtype=bool)
        gaps = np.abs(other[columns[usable].astype(int)] - mine[usable])
        row[usable] = gaps <= limit
        kept.append(row)
    return np.array(kept)


VARIANTS = [pixel_by_pixel, by_index_arrays, by_padding, by_scattering]
