"""Right answers to choose_pan, as strangers wrote them."""
import cmath
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1. plain math
def f1(u, pan, fov_y, width, height):
    f = height / 2 / math.tan(fov_y / 2)
    return pan + math.atan((0.5 * (width - 1) - u) / f)


# 2. NumPy, arctan2, NumPy scalar comes back
def f2(u, pan, fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    return np.float64(pan - np.arctan2(u - (width - 1) / 2, f))


# 3. K and its inverse
def f3(u, pan, fov_y, width, height):
    f = height / (2 * np.tan(fov_y / 2))
    K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
    x, _, z = np.linalg.inv(K) @ [u, (height - 1) / 2, 1]
    return float(pan - np.arctan2(x, z))


# 4. the ray in the world, x forward and y left
def f4(u, pan, fov_y, width, height):
    tan_half = np.tan(fov_y / 2)
    left = -(2 * u + 1 - width) / height * tan_half
    c, s = np.cos(pan), np.sin(pan)
    ray = np.array([[c, -s], [s, c]]) @ np.array([1.0, left])
    angle = math.atan2(ray[1], ray[0])
    turns = round((pan - angle) / (2 * math.pi))   # same revolution as pan
    return angle + 2 * math.pi * turns


# 5. undistortPoints
def f5(u, pan, fov_y, width, height):
    f = height / 2 / math.tan(fov_y / 2)
    K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1.0]])
    p = cv2.undistortPoints(np.array([[[u, 0.0]]], np.float64), K, None)
    return pan - math.atan(float(p[0, 0, 0]))


# 6. complex numbers
def f6(u, pan, fov_y, width, height):
    return pan + cmath.phase(complex(height / math.tan(fov_y / 2), (width - 1) - 2 * u))


# 7. class
@dataclass(frozen=True)
class _Camera:
    fov_y: float
    width: int
    height: int

    def __post_init__(self):
        if not 0 < self.fov_y < math.pi:
            raise ValueError("field of view must lie between 0 and pi")

    @property
    def focal(self):
        return (self.height / 2) / math.tan(self.fov_y / 2)

    def bearing_left(self, u):
        return -math.atan2(u - (self.width - 1) / 2, self.focal)


def f7(u: float, pan: float, fov_y: float, width: int, height: int) -> float:
    return pan + _Camera(fov_y, width, height).bearing_left(u)


# 8. sine by cross product
def f8(u, pan, fov_y, width, height):
    a = np.array([0.0, 0.0, height / 2 / np.tan(fov_y / 2)])
    b = a + [(width - 1) / 2 - u, 0.0, 0.0]
    side = np.sign(b[0])
    cosine = a @ b / np.linalg.norm(a) / np.linalg.norm(b)
    sine = np.linalg.norm(np.cross(a, b)) / np.linalg.norm(a) / np.linalg.norm(b)
    return pan + float(side * np.arctan2(sine, cosine))


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
