"""Right answers to measure_object_size, written in ways that the card does not contain."""

import numpy as np


def size_by_inverse(mask: np.ndarray, depth_metric: np.ndarray, K: np.ndarray) -> np.ndarray:
    z = np.where((mask == 255) & (depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.nan)
    z[np.abs(z - np.nanmedian(z)) > 0.05] = np.nan
    v, u = np.nonzero(np.isfinite(z))
    points = np.linalg.inv(K) @ np.stack([u, v, np.ones_like(u)]) * z[v, u]
    return points[:2].max(axis=1) - points[:2].min(axis=1)


def size_as_list(mask: np.ndarray, depth_metric: np.ndarray, K: np.ndarray) -> list[float]:
    return [float(side) for side in size_by_inverse(mask, depth_metric, K)]


def size_in_single_precision(
    mask: np.ndarray, depth_metric: np.ndarray, K: np.ndarray
) -> np.ndarray:
    return size_by_inverse(mask, depth_metric, K.astype(np.float32)).astype(np.float32)


VARIANTS = [size_by_inverse, size_as_list, size_in_single_precision]
