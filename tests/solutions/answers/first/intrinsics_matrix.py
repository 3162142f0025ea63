"""Right answers to intrinsics_matrix, as strangers wrote them."""
import cmath
import math
import numbers
import operator

import numpy as np


def by_formula(fov_y, width, height):
    """The formula of the book; ints and NumPy ints only (bool refused)."""
    for n in (width, height):
        if isinstance(n, (bool, np.bool_)) or not isinstance(n, (int, np.integer)):
            raise TypeError("width and height must be whole numbers")
        if n <= 0:
            raise ValueError("width and height must be positive")
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie in (0, pi)")
    f = (height / 2) / np.tan(float(fov_y) / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]], dtype=np.float64)


def whole_floats_allowed(fov_y, width, height):
    """Takes 640.0 as a whole number too; fills a matrix of zeros; math module."""
    fov_y = float(fov_y) if isinstance(fov_y, numbers.Real) else None
    if fov_y is None:
        raise TypeError("fov_y must be a number")
    if math.isnan(fov_y) or fov_y <= 0 or fov_y >= math.pi:
        raise ValueError("fov_y out of (0, pi)")
    for n in (width, height):
        if not isinstance(n, numbers.Real):
            raise TypeError("size must be numbers")
        if not math.isfinite(n) or n != int(n) or n < 1:
            raise ValueError("size must be positive whole numbers")
    K = np.zeros((3, 3))
    K[0, 0] = K[1, 1] = float(height) / (2 * math.tan(fov_y / 2))
    K[0, 2] = 0.5 * (float(width) - 1)
    K[1, 2] = 0.5 * (float(height) - 1)
    K[2, 2] = 1.0
    return K


def half_angle(fov_y, width, height):
    """operator.index for the size, tan of the half angle as sin / (1 + cos)."""
    w, h = operator.index(width), operator.index(height)
    if w < 1 or h < 1:
        raise ValueError("the picture needs at least one pixel")
    if not (fov_y > 0 and fov_y < math.pi):
        raise ValueError("fov_y must be between 0 and pi")
    fov_y = float(fov_y)
    f = h / 2 * (1 + math.cos(fov_y)) / math.sin(fov_y)
    return np.array([f, 0, (w - 1) / 2, 0, f, (h - 1) / 2, 0, 0, 1.0]).reshape(3, 3)


def product_of_matrices(fov_y, width, height):
    """Scale, then shift: from tangents to [0, W] x [0, H] to pixel centers."""
    if not isinstance(width, numbers.Integral) or not isinstance(height, numbers.Integral):
        raise TypeError("whole numbers, please")
    if min(width, height) <= 0:
        raise ValueError("positive numbers, please")
    if not 0.0 < fov_y < math.pi:
        raise ValueError("an angle between 0 and pi, please")
    t = math.tan(float(fov_y) / 2)
    scale = np.diag([int(height) / (2 * t), int(height) / (2 * t), 1.0])
    corner = np.array([[1, 0, int(width) / 2], [0, 1, int(height) / 2], [0, 0, 1.0]])
    center = np.array([[1, 0, -0.5], [0, 1, -0.5], [0, 0, 1.0]])
    return center @ corner @ scale


class _Picture:
    def __init__(self, width, height):
        self.width, self.height = self._check(width), self._check(height)

    @staticmethod
    def _check(n):
        if type(n) is bool or not -math.inf < n < math.inf or int(n) != n:
            raise ValueError(f"{n!r} is no whole number")
        if n < 1:
            raise ValueError(f"{n!r} is not positive")
        return int(n)

    @property
    def middle(self):
        return np.array([self.width - 1, self.height - 1]) / 2


def with_a_class(fov_y, width, height):
    """A class for the picture; the half angle as a complex number on the unit circle."""
    if isinstance(width, (str, bytes)) or isinstance(height, (str, bytes)):
        raise TypeError("the size is text")
    picture = _Picture(width, height)
    if isinstance(fov_y, (str, bytes, complex)):
        raise TypeError("fov_y is no real number")
    if not (0 < fov_y < math.pi):
        raise ValueError("fov_y outside (0, pi)")
    ray = cmath.exp(0.5j * float(fov_y))
    K = np.identity(3)
    K[:2, :2] *= picture.height / 2 * ray.real / ray.imag
    K[:2, 2] = picture.middle
    return K


def nested_loops(fov_y, width, height):
    """A function per entry, list comprehension, tan of the complement instead of a division."""
    try:
        inside = 0 < float(fov_y) < math.pi
    except (TypeError, ValueError) as error:
        raise TypeError("fov_y must be a real number") from error
    if not inside or isinstance(fov_y, str):
        raise ValueError("fov_y must lie between 0 and pi")
    size = []
    for n in (width, height):
        if not isinstance(n, (int, np.integer)) or int(n) <= 0:
            raise ValueError("the size must be positive whole numbers")
        size.append(int(n))

    def entry(i, j):
        if i == j:
            return 1.0 if i == 2 else size[1] / 2 * math.tan(math.pi / 2 - float(fov_y) / 2)
        return (size[i] - 1) / 2 if j == 2 and i < 2 else 0.0

    return np.array([[entry(i, j) for j in range(3)] for i in range(3)])


def from_two_edges(fov_y, width, height, *, check=True):
    """Solves f * tan + c = H - 1/2 and f * -tan + c = -1/2; checks can be switched off."""
    if check:
        if not np.isscalar(fov_y) and np.ndim(fov_y) != 0:
            raise TypeError("fov_y must be one number")
        if not (np.isreal(fov_y) and 0 < fov_y < np.pi):
            raise ValueError("fov_y must lie in (0, pi)")
        if any(not isinstance(n, numbers.Integral) or isinstance(n, bool) for n in (width, height)):
            raise TypeError("size must be whole numbers")
        if not (width > 0 and height > 0):
            raise ValueError("size must be positive")
    t = np.tan(np.float64(fov_y) / 2)
    f, cy = np.linalg.solve(np.array([[t, 1.0], [-t, 1.0]]), np.array([float(height) - 0.5, -0.5]))
    return np.array([[f, 0.0, (float(width) - 1) / 2], [0.0, f, cy], [0.0, 0.0, 1.0]])


ANSWERS = [by_formula, whole_floats_allowed, half_angle, product_of_matrices, with_a_class,
           nested_loops, from_two_edges]
