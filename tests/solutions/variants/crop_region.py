"""Right answers to crop_region, written in ways that the card does not contain."""

import numpy as np


def region_by_homogeneous(
    points_world: np.ndarray, T_world_robot: np.ndarray, low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    moved = np.linalg.solve(T_world_robot, np.c_[points_world, np.ones(len(points_world))].T)[:3].T
    return moved[(moved == np.clip(moved, low, high)).all(axis=1)]


def region_backwards(
    points_world: np.ndarray, T_world_robot: np.ndarray, low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    return region_by_homogeneous(points_world[::-1], T_world_robot, low, high).astype(np.float32)


def region_by_loop(
    points_world: np.ndarray, T_world_robot: np.ndarray, low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    kept = []
    for point in points_world:
        moved = T_world_robot[:3, :3].T @ (point - T_world_robot[:3, 3])
        if all(a <= b <= c for a, b, c in zip(low, moved, high, strict=True)):
            kept.append(tuple(moved))
    return np.reshape(kept, (-1, 3))


VARIANTS = [region_by_homogeneous, region_backwards, region_by_loop]
