"""Right answers to choose_pan, as strangers wrote them."""
import cmath
import math

import cv2
import numpy as np


def f1(u, pan, fov_y, width, height):
    f = height / 2 / np.tan(fov_y / 2)
    return pan + np.arctan(((width - 1) / 2 - u) / f)


def f2(u, pan, fov_y, width, height):
    focal = (height / 2) / math.tan(fov_y / 2)
    middle = (width - 1) / 2
    angle_to_the_right = math.atan2(u - middle, focal)
    return float(pan - angle_to_the_right)


# direction in the world, then its heading
def f3(u, pan, fov_y, width, height):
    f = height / (2 * np.tan(fov_y / 2))
    x = (u - (width - 1) / 2) / f
    forward = np.array([np.cos(pan), np.sin(pan)])
    right = np.array([np.sin(pan), -np.cos(pan)])
    d = forward + x * right
    turn = np.arctan2(forward[0] * d[1] - forward[1] * d[0], forward @ d)
    return float(pan + turn)


def f4(u, pan, fov_y, width, height):
    f = height / 2 / math.tan(fov_y / 2)
    return pan + cmath.phase(complex(f, (width - 1) / 2 - u))


# K and its inverse
def f5(u, pan, fov_y, width, height):
    f = 0.5 * height / np.tan(0.5 * fov_y)
    K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
    ray = np.linalg.solve(K, [u, (height - 1) / 2, 1])
    return np.float64(pan - np.arctan2(ray[0], ray[2]))


class Neck:
    def __init__(self, pan):
        self.pan = float(pan)

    def turned_left(self, angle):
        return Neck(self.pan + angle)


def f6(u: float, pan: float, fov_y: float, width: int, height: int) -> float:
    if not 0 < fov_y < math.pi:
        raise ValueError("fov_y in radians, between 0 and pi")
    right = (2 * u - (width - 1)) / height * math.tan(fov_y / 2)
    return Neck(pan).turned_left(-math.atan(right)).pan


# float32
def f7(u, pan, fov_y, width, height):
    f = np.float32(height) / 2 / np.tan(np.float32(fov_y) / 2)
    return np.float32(pan) + np.arctan((np.float32(width - 1) / 2 - np.float32(u)) / f)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7]
