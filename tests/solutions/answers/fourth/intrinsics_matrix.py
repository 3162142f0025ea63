"""Right answers to intrinsics_matrix, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import numpy as np


def f1(fov_y, width, height):
    f = height / 2 / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def f2(fov_y, width, height):
    K = np.eye(3)
    K[0, 0] = K[1, 1] = 0.5 * height / math.tan(0.5 * fov_y)
    K[:2, 2] = (np.array([width, height]) - 1) / 2
    return K


# cotangent and a product of matrices: shift times scale
def f3(fov_y, width, height):
    scale = np.diag([1 / np.tan(fov_y / 2)] * 2 + [1.0])
    to_pixels = np.array([[height / 2, 0, width / 2 - 0.5], [0, height / 2, height / 2 - 0.5], [0, 0, 1]])
    return to_pixels @ scale


# game developer: projection matrix and viewport
def f4(fov_y, width, height):
    aspect = width / height
    e = 1.0 / math.tan(fov_y / 2.0)
    P = np.array([[e / aspect, 0, 0], [0, e, 0], [0, 0, 1.0]])
    viewport = np.array([[width / 2, 0, (width - 1) / 2], [0, height / 2, (height - 1) / 2], [0, 0, 1.0]])
    return viewport.dot(P)


# float32
def f5(fov_y, width, height):
    f = np.float32(height) / (np.float32(2) * np.tan(np.float32(fov_y) / np.float32(2)))
    return np.array([[f, 0, (width - 1) * 0.5], [0, f, (height - 1) * 0.5], [0, 0, 1]], dtype=np.float32)


# half angle identity: tan(a/2) = (1 - cos a) / sin a
def f6(fov_y, width, height):
    f = (height / 2) * math.sin(fov_y) / (1 - math.cos(fov_y))
    values = [f, 0, width / 2 - 1 / 2, 0, f, height / 2 - 1 / 2, 0, 0, 1]
    return np.asarray(values, dtype=float).reshape(3, 3)


@dataclass
class Camera:
    fov_y: float
    width: int
    height: int

    def __post_init__(self):
        if not 0 < self.fov_y < math.pi:
            raise ValueError("fov_y must be between 0 and pi")
        if self.width < 1 or self.height < 1:
            raise ValueError("size must be positive")

    @property
    def focal(self):
        return self.height / (2 * math.tan(self.fov_y / 2))

    @property
    def center(self):
        return (self.width - 1) / 2, (self.height - 1) / 2

    def matrix(self):
        cx, cy = self.center
        return np.array([[self.focal, 0.0, cx], [0.0, self.focal, cy], [0.0, 0.0, 1.0]])


def f7(fov_y, width, height):
    return Camera(fov_y, width, height).matrix()


# OpenCV for the center, unit-plane edge for the focal length, complex numbers for the angle
def f8(fov_y, width, height):
    K = np.diag([1.0, 1.0, 1.0])
    edge = np.exp(1j * fov_y / 2)
    K[[0, 1], [0, 1]] = height / 2 * edge.real / edge.imag
    K[0, 2] = np.mean(np.arange(width))
    K[1, 2] = np.mean(np.arange(height))
    return K


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
