"""Right answers to intrinsics_matrix, as strangers wrote them."""
import cmath
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1. the formula
def f1(fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


# 2. C programmer, element by element
def f2(fov_y, width, height):
    K = np.zeros((3, 3), dtype=np.double)
    K[0, 0] = K[1, 1] = 0.5 * height / math.tan(0.5 * fov_y)
    K[0, 2] = 0.5 * width - 0.5
    K[1, 2] = 0.5 * height - 0.5
    K[2, 2] = 1.0
    return K


# 3. GPU: float32
def f3(fov_y, width, height):
    half = np.float32(fov_y) / np.float32(2)
    f = np.float32(height) / np.float32(2) / np.tan(half)
    K = np.diag(np.array([f, f, 1], np.float32))
    K[:2, 2] = (np.array([width, height], np.float32) - 1) / 2
    return K


# 4. product of matrices: shift by half a pixel, scale, focal
def f4(fov_y, width, height):
    to_pixels = np.array([[1, 0, width / 2 - 0.5], [0, 1, height / 2 - 0.5], [0, 0, 1]])
    return to_pixels @ np.diag([height / 2, height / 2, 1]) @ np.diag([1 / np.tan(fov_y / 2)] * 2 + [1])


# 5. solve: the upper edge's ray goes to v = -1/2, the lower one's to H - 1/2
def f5(fov_y, width, height):
    t = math.tan(fov_y / 2)
    A = np.array([[-t, 1.0], [t, 1.0]])
    f, cy = np.linalg.solve(A, [-0.5, height - 0.5])
    K = np.eye(3)
    K[[0, 1], [0, 1]] = f
    K[0, 2], K[1, 2] = (width - 1) / 2, cy
    return K


# 6. one-liner: cotangent by the half angle formula
def f6(fov_y, width, height): return np.array([*map(float, ((g := height * (1 + math.cos(fov_y)) / math.sin(fov_y) / 2), 0, (width - 1) / 2, 0, g, (height - 1) / 2, 0, 0, 1))]).reshape(3, 3)


# 7. over-engineered
@dataclass(frozen=True)
class _Pinhole:
    fov_y: float
    width: int
    height: int

    def __post_init__(self):
        if not 0 < self.fov_y < math.pi:
            raise ValueError(f"fov_y must lie in (0, pi), got {self.fov_y}")
        if self.width < 1 or self.height < 1:
            raise ValueError("the picture needs at least one pixel")

    def matrix(self):
        f = abs(cmath.rect(self.height / 2, 0)) / math.tan(self.fov_y / 2)
        K = np.identity(3)
        K[:2] *= f
        K[:2, 2] = np.mean([0, self.width - 1]), np.mean([0, self.height - 1])
        return K


def f7(fov_y: float, width: int, height: int) -> np.ndarray:
    return _Pinhole(fov_y, width, height).matrix()


# 8. OpenCV places the center
def f8(fov_y, width, height):
    f = height / (2 * np.tan(fov_y / 2))
    return cv2.getDefaultNewCameraMatrix(np.diag([f, f, 1.0]), (int(width), int(height)), True)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
