"""Right answers to depth_to_pointcloud, written in ways that the card does not contain."""

import cv2
import numpy as np


def cloud_column_by_column(
    depth_metric: np.ndarray, K: np.ndarray, rgb_image: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray | None]:
    points, colors = [], []
    for u in range(depth_metric.shape[1]):
        for v in range(depth_metric.shape[0]):
            z = float(depth_metric[v, u])
            if 0.01 < z < 10:
                points.append([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z])
                colors.append([] if rgb_image is None else rgb_image[v, u] / 255)
    rows = np.reshape(points, (-1, 3))
    return rows, None if rgb_image is None else np.reshape(colors, (-1, 3))


def cloud_by_inverse_matrix(
    depth_metric: np.ndarray, K: np.ndarray, rgb_image: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray | None]:
    v, u = np.nonzero((depth_metric > 0.01) & (depth_metric < 10))
    pixels = np.stack([u, v, np.ones_like(u)])
    points = (np.linalg.inv(K) @ pixels * depth_metric[v, u]).T
    return points, None if rgb_image is None else rgb_image[v, u] / 255.0


def cloud_by_cv2_backwards(
    depth_metric: np.ndarray, K: np.ndarray, rgb_image: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray | None]:
    height, width = depth_metric.shape
    grid = np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).reshape(-1, 1, 2)
    slopes = cv2.undistortPoints(grid.astype(np.float64), K, None).reshape(-1, 2)
    z = depth_metric.reshape(-1, 1)
    keep = ((z > 0.01) & (z < 10)).ravel()
    points = np.hstack([slopes * z, z])[keep][::-1].astype(np.float32)
    return points, None if rgb_image is None else (rgb_image.reshape(-1, 3)[keep] / 255)[::-1]


VARIANTS = [cloud_column_by_column, cloud_by_inverse_matrix, cloud_by_cv2_backwards]
