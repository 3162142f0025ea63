"""Right answers to intrinsics_matrix, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1.
def K_plain(fov_y, width, height):
    f = height / 2 / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


# 2. beginner
def K_beginner(fov_y, width, height):
    half_angle = fov_y / 2
    half_height = height / 2
    focal = half_height / math.tan(half_angle)
    middle_u = (width - 1) / 2
    middle_v = (height - 1) / 2
    K = np.zeros((3, 3))
    K[0, 0] = focal
    K[1, 1] = focal
    K[0, 2] = middle_u
    K[1, 2] = middle_v
    K[2, 2] = 1
    return K


# 3. another textbook: half-angle identity, cot(t/2) = sin t / (1 - cos t)
def K_half_angle(fov_y, width, height):
    cot = math.sin(fov_y) / (1 - math.cos(fov_y)) if fov_y > 1e-3 else 1 / math.tan(fov_y / 2)
    f = 0.5 * height * cot
    return np.diag([f, f, 1.0]) + np.outer([(width - 1) / 2, (height - 1) / 2, 0], [0, 0, 1])


# 4. mathematician: K maps the edges of the view to the edges of the picture
def K_from_edges(fov_y, width, height):
    t = math.tan(fov_y / 2)
    # rays through the upper and the lower edge hit v = -1/2 and v = H - 1/2
    f, cy = np.linalg.solve([[-t, 1.0], [t, 1.0]], [-0.5, height - 0.5])
    cx = np.mean([-0.5, width - 0.5])
    return np.array([[f, 0.0, cx], [0.0, f, cy], [0.0, 0.0, 1.0]])


# 5. product of simple matrices: shift @ scale, like in OpenGL
def K_product(fov_y, width, height):
    shift = np.array([[1, 0, width / 2 - 0.5], [0, 1, height / 2 - 0.5], [0, 0, 1]])
    viewport = np.diag([width / 2, height / 2, 1])
    aspect = width / height
    projection = np.diag([1 / (aspect * np.tan(0.5 * fov_y)), 1 / np.tan(0.5 * fov_y), 1])
    return shift @ viewport @ projection


# 6. OpenCV puts the principal point
def K_opencv(fov_y, width, height):
    f = (height * 0.5) / math.tan(fov_y * 0.5)
    return np.array(cv2.getDefaultNewCameraMatrix(np.diag([f, f, 1.0]), (int(width), int(height)), True))


# 7. float32
def K_float32(fov_y, width, height):
    K = np.eye(3, dtype=np.float32)
    K[[0, 1], [0, 1]] = np.float32(height / (2 * np.tan(np.float64(fov_y) / 2)))
    K[:2, 2] = [(width - 1) * 0.5, (height - 1) * 0.5]
    return K


# 8. Java
@dataclass(frozen=True)
class PinholeCamera:
    fov_y: float
    width: int
    height: int

    def __post_init__(self):
        if not 0 < self.fov_y < math.pi:
            raise ValueError("the field of view must lie between 0 and pi")
        if self.width < 1 or self.height < 1:
            raise ValueError("the picture needs pixels")

    @property
    def focal_length(self):
        return self.height / 2 * math.tan(math.pi / 2 - self.fov_y / 2)

    @property
    def principal_point(self):
        return (self.width - 1) / 2.0, (self.height - 1) / 2.0

    def matrix(self):
        f = self.focal_length
        cx, cy = self.principal_point
        return np.array([f, 0, cx, 0, f, cy, 0, 0, 1], dtype=np.float64).reshape(3, 3)


def K_java(fov_y, width, height):
    return PinholeCamera(float(fov_y), int(width), int(height)).matrix()


# 9. complex numbers: the edge ray has the argument fov/2
def K_complex(fov_y, width, height):
    ray = complex(math.cos(fov_y / 2), math.sin(fov_y / 2))
    f = height / 2 * ray.real / ray.imag
    cx, cy = np.arange(width).mean(), np.arange(height).mean()
    return np.block([[f * np.eye(2), np.array([[cx], [cy]])], [np.zeros((1, 2)), np.ones((1, 1))]])


ANSWERS = [K_plain, K_beginner, K_half_angle, K_from_edges, K_product, K_opencv, K_float32,
           K_java, K_complex]
