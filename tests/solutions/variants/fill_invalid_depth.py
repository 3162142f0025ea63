"""Right answers to fill_invalid_depth, written in ways that the card does not contain."""

import numpy as np


def fill_by_loop(depth_metric: np.ndarray) -> np.ndarray:
    depth = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, 0).astype(float)
    while (holes := np.argwhere(depth == 0)).size:
        before = np.pad(depth, 1)
        for v, u in holes:
            depth[v, u] = before[v : v + 3, u : u + 3].max()
    return depth


def fill_by_windows(depth_metric: np.ndarray) -> np.ndarray:
    depth = np.nan_to_num(depth_metric, nan=0, posinf=0, neginf=0)
    depth[(depth <= 0.01) | (depth >= 10)] = 0
    while not depth.all():
        windows = np.lib.stride_tricks.sliding_window_view(np.pad(depth, 1), (3, 3))
        depth = np.where(depth > 0, depth, windows.max(axis=(2, 3)))
    return depth


def fill_as_lists(depth_metric: np.ndarray) -> list[list[float]]:
    return fill_by_windows(depth_metric).tolist()


VARIANTS = [fill_by_loop, fill_by_windows, fill_as_lists]
