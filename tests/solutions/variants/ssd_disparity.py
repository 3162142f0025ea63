"""Right answers to ssd_disparity, written in ways that the card does not contain."""

import cv2
import numpy as np


def by_running_sums(
    left: np.ndarray, right: np.ndarray, max_disparity: int, window: int = 9
) -> np.ndarray:
    height, width = left.shape
    half = window // 2
    best = np.full((height, width), np.inf)
    disparity = np.full((height, width), np.nan)
    for d in range(max_disparity):
        squares = (left[:, d:].astype(float) - right[:, : width - d]) ** 2
        table = np.pad(squares, ((1, 0), (1, 0))).cumsum(axis=0).cumsum(axis=1)
        k = window
        sums = table[k:, k:] - table[:-k, k:] - table[k:, :-k] + table[:-k, :-k]
        rows, columns = slice(half, height - half), slice(d + half, width - half)
        better = sums < best[rows, columns]
        best[rows, columns][better] = sums[better]
        disparity[rows, columns][better] = d
    return disparity


def by_windows_in_single_precision(
    left: np.ndarray, right: np.ndarray, max_disparity: int, window: int = 9
) -> np.ndarray:
    half = window // 2
    height, width = left.shape
    shape = (window, window)
    seen = np.lib.stride_tricks.sliding_window_view(left.astype(np.float32), shape)
    other = np.lib.stride_tricks.sliding_window_view(right.astype(np.float32), shape)
    costs = np.full((max_disparity, *seen.shape[:2]), np.inf, np.float32)
    for d in range(max_disparity):
        if d < seen.shape[1]:
            difference = seen[:, d:] - other[:, : seen.shape[1] - d]
            costs[d, :, d:] = (difference**2).sum(axis=(2, 3))
    disparity = np.full((height, width), np.nan, np.float32)
    disparity[half : height - half, half : width - half] = costs.argmin(axis=0)
    return disparity


def row_by_row(
    left: np.ndarray, right: np.ndarray, max_disparity: int, window: int = 9
) -> list[list[float]]:
    half = window // 2
    height, width = left.shape
    first, second = left.astype(int), right.astype(int)
    rows = []
    for v in range(height):
        row = [float("nan")] * width
        for u in range(half, width - half):
            if not half <= v < height - half:
                continue
            here = first[v - half : v + half + 1, u - half : u + half + 1]
            costs = []
            for d in range(min(max_disparity, u - half + 1)):
                there = second[v - half : v + half + 1, u - d - half : u - d + half + 1]
                costs.append(np.vdot(here - there, here - there))
            row[u] = float(np.argmin(costs))
        rows.append(row)
    return rows


def by_mean_squares(
    left: np.ndarray, right: np.ndarray, max_disparity: int, window: int = 9
) -> np.ndarray:
    # The mean is the sum divided by one number: the same one wins.
    height, width = left.shape
    half = window // 2
    costs = []
    for d in range(max_disparity):
        moved = np.full((height, width), np.nan, np.float32)
        moved[:, d:] = right[:, : width - d]
        squares = np.nan_to_num((left - moved) ** 2, nan=1e7)
        cost = cv2.blur(squares, (window, window))
        cost[:, : d + half] = np.nan
        costs.append(cost)
    volume = np.stack(costs)
    volume[:, :half] = volume[:, height - half :] = np.nan
    volume[:, :, width - half :] = np.nan
    known = ~np.isnan(volume).all(axis=0)
    best = np.nanargmin(np.where(known, volume, 0), axis=0)
    return np.where(known, best, np.nan)


def by_kernel_in_torn_rows(
    left: np.ndarray, right: np.ndarray, max_disparity: int, window: int = 9
) -> np.ndarray:
    # The square of a difference, taken apart: a^2 - 2 a b + b^2.
    kernel = np.ones((window, window))
    half = window // 2
    height, width = left.shape
    a, b = left.astype(np.float64), right.astype(np.float64)
    costs = np.full((max_disparity, height, width), np.inf)
    for d in range(max_disparity):
        x, y = a[:, d:], b[:, : width - d]
        parts = [cv2.filter2D(one, -1, kernel) for one in (x * x, x * y, y * y)]
        cost = parts[0] - 2 * parts[1] + parts[2]
        inner = np.s_[half : height - half, half : cost.shape[1] - half]
        costs[d, :, d:][inner] = cost[inner]
    disparity = costs.argmin(axis=0).astype(float)
    disparity[np.isinf(costs).all(axis=0)] = np.nan
    return disparity


VARIANTS = [
    by_running_sums,
    by_windows_in_single_precision,
    row_by_row,
    by_mean_squares,
    by_kernel_in_torn_rows,
]
