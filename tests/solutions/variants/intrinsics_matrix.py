"""Right answers to intrinsics_matrix, written in ways that the card does not contain."""

import numpy as np


def intrinsics_by_diagonal(fov_y: float, width: int, height: int) -> np.ndarray:
    K = np.eye(3, dtype=np.float32)
    K[0, 0] = K[1, 1] = height / (2 * np.tan(fov_y / 2))
    K[:2, 2] = (width - 1) / 2, (height - 1) / 2
    return K


def intrinsics_as_lists(fov_y: float, width: int, height: int) -> list[list[float]]:
    f = height / 2 * np.cos(fov_y / 2) / np.sin(fov_y / 2)
    return [[f, 0, width / 2 - 0.5], [0, f, height / 2 - 0.5], [0, 0, 1]]


def intrinsics_as_tuples(fov_y: float, width: int, height: int) -> tuple[tuple[float, ...], ...]:
    return tuple(map(tuple, intrinsics_as_lists(fov_y, width, height)))


VARIANTS = [intrinsics_by_diagonal, intrinsics_as_lists, intrinsics_as_tuples]
