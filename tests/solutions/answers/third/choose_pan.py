"""Right answers to choose_pan, as strangers wrote them."""
import cmath
import math

import cv2
import numpy as np


# 1.
def pan_arctan(u, pan, fov_y, width, height):
    f = height / 2 / np.tan(fov_y / 2)
    return pan - np.arctan((u - (width - 1) / 2) / f)


# 2. beginner
def pan_beginner(u, pan, fov_y, width, height):
    focal = (height / 2) / math.tan(fov_y / 2)
    middle = (width - 1) / 2
    pixels_to_the_left = middle - u
    angle = math.atan(pixels_to_the_left / focal)
    new_pan = pan + angle
    return new_pan


# 3. OpenCV: the ray of the pixel
def pan_opencv(u, pan, fov_y, width, height):
    f = 0.5 * height / math.tan(0.5 * fov_y)
    K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
    ray = cv2.undistortPoints(np.array([[[float(u), (height - 1) / 2]]]), K, None).ravel()
    return float(pan) - math.atan2(float(ray[0]), 1.0)


# 4. mathematician: the ray in the world, its azimuth
def pan_world_ray(u, pan, fov_y, width, height):
    f = height / (2 * np.tan(fov_y / 2))
    right, forward = (u - (width - 1) / 2) / f, 1.0
    # pan = 0 looks along x, its right is -y
    direction = np.array([forward, -right])
    c, s = np.cos(pan), np.sin(pan)
    change = np.arctan2(direction[1], direction[0])
    turned = np.array([[c, -s], [s, c]]) @ direction
    azimuth = np.arctan2(turned[1], turned[0])
    # the azimuth is known up to whole turns: take the one next to pan
    return float(azimuth + 2 * np.pi * np.round((pan + change - azimuth) / (2 * np.pi)))


# 5. Java
class Neck:
    def __init__(self, angle):
        self.angle = float(angle)

    def turned_left_by(self, change):
        return Neck(self.angle + change)


class Lens:
    def __init__(self, fov_y, width, height):
        if not 0.0 < fov_y < math.pi:
            raise ValueError("fov_y in radians, between 0 and pi")
        self.focal = height / 2.0 / math.tan(fov_y / 2.0)
        self.center = (width - 1) / 2.0

    def angle_to_the_right(self, u):
        return math.atan2(u - self.center, self.focal)


def pan_java(u, pan, fov_y, width, height):
    return Neck(pan).turned_left_by(-Lens(fov_y, width, height).angle_to_the_right(u)).angle


# 6. another formula: through the half width; tan(a) = s tan(fov_x / 2)
def pan_half_width(u, pan, fov_y, width, height):
    half_fov_x = math.atan(math.tan(fov_y / 2) * width / height)
    share = (2 * u + 1) / width - 1           # -1 at the left edge, 1 at the right edge
    return pan - math.atan(share * math.tan(half_fov_x))


# 7. complex numbers; the result is a NumPy number
def pan_complex(u, pan, fov_y, width, height):
    f = (height / 2) / math.tan(fov_y / 2)
    return np.float64(pan + cmath.phase(complex(f, (width - 1) / 2 - u)))


# 8. root finding: bisection on "where does it appear after the turn?"
def pan_bisection(u, pan, fov_y, width, height):
    f = height / 2 / math.tan(fov_y / 2)
    tangent = (u - (width - 1) / 2) / f
    low, high = -math.pi / 2, math.pi / 2
    for _ in range(80):
        middle = (low + high) / 2
        if math.sin(middle) > tangent * math.cos(middle):
            high = middle
        else:
            low = middle
    return pan - (low + high) / 2


ANSWERS = [pan_arctan, pan_beginner, pan_opencv, pan_world_ray, pan_java, pan_half_width,
           pan_complex, pan_bisection]
