"""Right answers to process_depth, written in ways that the card does not contain."""

import numpy as np


def depth_by_inverse(depth_raw: np.ndarray, near: float, far: float) -> np.ndarray:
    inverse = 1 / near + np.clip(depth_raw, 0, 1) * (1 / far - 1 / near)
    return 1 / inverse


def depth_by_ndc(depth_raw: np.ndarray, near: float, far: float) -> np.ndarray:
    ndc = 2 * np.clip(depth_raw.astype(np.float64), 0, 1) - 1
    return 2 * near * far / (far + near - ndc * (far - near))


def depth_in_place(depth_raw: np.ndarray, near: float, far: float) -> np.ndarray:
    # Step by step in one array of its own.
    depth = np.array(depth_raw)
    depth[depth < 0] = 0
    depth[depth > 1] = 1
    depth[:] = near / (1 - depth * (1 - near / far))
    return depth


def depth_as_lists(depth_raw: np.ndarray, near: float, far: float) -> list[list[float]]:
    return depth_by_ndc(depth_raw, near, far).tolist()


VARIANTS = [depth_by_inverse, depth_by_ndc, depth_in_place, depth_as_lists]
