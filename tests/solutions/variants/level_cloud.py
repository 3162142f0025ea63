"""Right answers to level_cloud, written in ways that the card does not contain."""

from typing import Any

import cv2
import numpy as np


def level_by_eigenvectors(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    rng, best = np.random.default_rng(5), (0, None)
    for _ in range(60):
        some = points[rng.permutation(len(points))[:3]]
        normal = np.cross(some[1] - some[0], some[2] - some[0])
        near = np.abs((points - some[0]) @ normal) / np.linalg.norm(normal) < 0.006
        best = max(best, (near.sum(), near), key=lambda pair: pair[0])
    near = best[1]
    for _ in range(4):
        center = points[near].mean(axis=0)
        normal = np.linalg.eigh(np.cov(points[near].T))[1][:, 0]
        near = np.abs((points - center) @ normal) < 0.012
    normal = normal if normal @ center < 0 else -normal
    d = -normal @ center
    axis = np.cross(normal, [0, 0, 1])
    angle = np.arctan2(np.linalg.norm(axis), normal[2])
    R, _ = cv2.Rodrigues(axis / np.linalg.norm(axis) * angle)
    return np.r_[normal, d], (R @ points.T).T + np.array([0, 0, d])


def level_by_columns(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    plane, _ = level_by_eigenvectors(points)
    n, up = plane[:3], np.array([0.0, 0, 1])
    # Two reflections make the smallest rotation: at the plane of n, then at the plane between.
    half = (n + up) / np.linalg.norm(n + up)
    moved = points - 2 * np.outer(points @ n, n)
    moved = moved - 2 * np.outer(moved @ half, half)
    moved[:, 2] += plane[3]
    return plane, moved


def level_as_lists(points: np.ndarray) -> tuple[list[Any], list[Any]]:
    plane, leveled = level_by_columns(points)
    return plane.tolist(), leveled.tolist()


VARIANTS = [level_by_eigenvectors, level_by_columns, level_as_lists]
