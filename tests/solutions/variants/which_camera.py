"""Right answers to which_camera, written in ways that the card does not contain."""

import cv2
import numpy as np


def camera_by_matrix(
    points: np.ndarray, pixels: np.ndarray, fovs: np.ndarray, width: int, height: int
) -> tuple[int, float]:
    errors = []
    for fov in fovs:
        f = height / 2 / np.tan(fov / 2)
        K = np.array([[f, 0, width / 2 - 0.5], [0, f, height / 2 - 0.5], [0, 0, 1]])
        projected = points @ K.T
        gaps = projected[:, :2] / projected[:, 2:] - pixels
        errors.append(np.mean(np.hypot(*gaps.T)))
    best = int(np.argmin(errors))
    return best, errors[best]


def camera_by_cv2(
    points: np.ndarray, pixels: np.ndarray, fovs: np.ndarray, width: int, height: int
) -> list[float]:
    best = (np.inf, 0)
    for number, fov in enumerate(fovs):
        f = height / 2 / np.tan(fov / 2)
        K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
        projected, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), K, None)
        best = min(best, (np.linalg.norm(projected[:, 0] - pixels, axis=1).mean(), number))
    return [best[1], best[0]]


def camera_in_single_precision(
    points: np.ndarray, pixels: np.ndarray, fovs: np.ndarray, width: int, height: int
) -> tuple[np.int64, np.float32]:
    places, found = points.astype(np.float32), pixels.astype(np.float32)
    camera, error = camera_by_matrix(places, found, fovs, width, height)
    return np.int64(camera), np.float32(error)


VARIANTS = [camera_by_matrix, camera_by_cv2, camera_in_single_precision]
