"""Wrong answers to intrinsics_matrix, as strangers wrote them."""
import math
import numpy as np


def _right(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y")
    for n in (width, height):
        if isinstance(n, bool) or int(n) != n:
            raise TypeError("size")
        if n <= 0:
            raise ValueError("size")
    f = height / 2 / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1.0]])


def w_corner_center(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must be between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size must be positive")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, width / 2], [0, f, height / 2], [0, 0, 1]], float)


def w_degrees(fov_y, width, height):
    fov_y = np.deg2rad(fov_y)
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y out of range")
    if int(width) != width or int(height) != height or min(width, height) < 1:
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_width_for_focal(fov_y, width, height):
    if fov_y <= 0 or fov_y >= np.pi:
        raise ValueError
    if int(width) != width or int(height) != height or min(width, height) < 1:
        raise ValueError
    f = width / (2 * np.tan(fov_y / 2))
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_both_directions_same_angle(fov_y, width, height):
    if fov_y <= 0 or fov_y >= np.pi:
        raise ValueError("fov_y")
    if int(width) != width or int(height) != height or min(width, height) < 1:
        raise ValueError("size")
    fx = (width / 2) / np.tan(fov_y / 2)
    fy = (height / 2) / np.tan(fov_y / 2)
    return np.array([[fx, 0, (width - 1) / 2], [0, fy, (height - 1) / 2], [0, 0, 1]])


def w_height_minus_one(fov_y, width, height):
    if fov_y <= 0 or fov_y >= np.pi:
        raise ValueError("fov_y")
    if int(width) != width or int(height) != height or min(width, height) < 1:
        raise ValueError("size")
    cx, cy = (width - 1) / 2, (height - 1) / 2
    f = cy / np.tan(fov_y / 2)
    return np.array([[f, 0, cx], [0, f, cy], [0, 0, 1]])


def w_no_checks(fov_y, width, height):
    f = (height / 2) / np.tan(fov_y / 2)
    K = np.eye(3)
    K[0, 0] = K[1, 1] = f
    K[0, 2] = (width - 1) / 2
    K[1, 2] = (height - 1) / 2
    return K


def w_accepts_fractions(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0:
        raise ValueError("size must be positive")
    width, height = int(width), int(height)
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_accepts_zero_size(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if int(width) != width or int(height) != height:
        raise TypeError("size must be whole numbers")
    if width < 0 or height < 0:
        raise ValueError("size must not be negative")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_checks_width_twice(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or int(width) != width or width <= 0 or int(width) != width:
        raise ValueError("size must be positive whole numbers")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_asserts(fov_y, width, height):
    assert 0 < fov_y < math.pi, "fov_y must be between 0 and pi"
    assert width > 0 and height > 0 and width % 1 == 0 and height % 1 == 0
    f = (height / 2) / math.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_accepts_pi(fov_y, width, height):
    if fov_y < 0 or fov_y > np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_float32(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]], dtype=np.float32)


def w_integer_center(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) // 2], [0, f, (height - 1) // 2], [0, 0, 1]])


def w_centers_swapped(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (height - 1) / 2], [0, f, (width - 1) / 2], [0, 0, 1]])


def w_transposed(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, 0], [0, f, 0], [(width - 1) / 2, (height - 1) / 2, 1]])


def w_last_entry_zero(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    K = np.zeros((3, 3))
    K[0, 0], K[1, 1] = f, f
    K[0, 2], K[1, 2] = (width - 1) / 2, (height - 1) / 2
    return K


def w_angle_not_halved(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_shared_matrix(fov_y, width, height, K=np.eye(3)):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    K[0, 0] = K[1, 1] = (height / 2) / np.tan(fov_y / 2)
    K[:2, 2] = (width - 1) / 2, (height - 1) / 2
    return K


def w_refuses_wide(fov_y, width, height):
    if not 0 < fov_y < np.pi / 2:
        raise ValueError("the field of view must lie between 0 and 90 degrees")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_refuses_odd_sizes(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width % 2 or height % 2:
        raise ValueError("size must be even")
    f = (height / 2) / np.tan(fov_y / 2)
    return np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])


def w_returns_tuple(fov_y, width, height):
    if not 0 < fov_y < np.pi:
        raise ValueError("fov_y must lie between 0 and pi")
    if width <= 0 or height <= 0 or width != int(width) or height != int(height):
        raise ValueError("size")
    f = (height / 2) / np.tan(fov_y / 2)
    K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
    return K, fov_y


WRONG = [
    (w_corner_center, "principal point at W/2, H/2; every input"),
    (w_degrees, "takes fov_y as degrees; every input"),
    (w_width_for_focal, "focal length from the width; pictures that are not square"),
    (w_both_directions_same_angle, "fx from the width, fy from the height with the same angle, so fx != fy; pictures that are not square"),
    (w_height_minus_one, "focal length from H-1; every input"),
    (w_no_checks, "no error for bad input; fov_y = 0, 4 or -1, size 0 or 10.5"),
    (w_accepts_fractions, "cuts fractional sizes instead of refusing them; width 640.5"),
    (w_accepts_zero_size, "accepts 0 as a size; height 0"),
    (w_checks_width_twice, "copy-paste slip: height is never checked; height 0 or -480"),
    (w_asserts, "AssertionError instead of ValueError or TypeError; fov_y = 4"),
    (w_accepts_pi, "ends of the range accepted; fov_y = pi or 0"),
    (w_float32, "float32 instead of float64; every input"),
    (w_integer_center, "integer division for the center; even sizes"),
    (w_centers_swapped, "cx from the height, cy from the width; pictures that are not square"),
    (w_transposed, "the center in the last row; every input"),
    (w_last_entry_zero, "K[2, 2] is 0; every input"),
    (w_angle_not_halved, "tangent of the whole angle; every input"),
    (w_shared_matrix, "one default matrix is filled and returned again and again; the first K changes with the second call"),
    (w_refuses_wide, "refuses 90 degrees and more; fov_y = pi/2"),
    (w_refuses_odd_sizes, "refuses odd sizes; 641 x 481"),
    (w_returns_tuple, "answers (K, fov_y) instead of K; every input"),
]


def _cases():
    L = [(np.pi / 2, 640, 480), (0.8, 640, 480), (1.0, 33, 21), (2.5, 30, 50), (0.5, 64, 64),
         (0.0, 640, 480), (np.pi, 640, 480), (-1.0, 640, 480), (4.0, 640, 480), (0.8, 0, 480), (0.8, 640, 0),
         (0.8, 640, -480), (0.8, 640.5, 480), (0.8, 640, 480.5)]
    return [lambda t=t: t for t in L]
