"""Right answers to which_camera, as strangers wrote them."""
import collections
import math

import cv2
import numpy as np


def loop_over_cameras(points, pixels, fovs, width, height):
    """One loop, mean distance per camera, the smallest wins (the first of equals)."""
    best, best_error = -1, float("inf")
    for k, fov in enumerate(fovs):
        f = (height / 2) / np.tan(fov / 2)
        u = f * points[:, 0] / points[:, 2] + (width - 1) / 2
        v = f * points[:, 1] / points[:, 2] + (height - 1) / 2
        error = float(np.mean(np.hypot(u - pixels[:, 0], v - pixels[:, 1])))
        if error < best_error:
            best, best_error = k, error
    return best, best_error


def all_at_once(points, pixels, fovs, width, height):
    """Broadcasting over cameras, argmin; returns Python numbers."""
    f = 0.5 * height / np.tan(np.asarray(fovs) / 2)
    slopes = points[:, :2] / points[:, 2:]
    center = np.array([width - 1, height - 1]) / 2
    projected = f[:, None, None] * slopes + center
    errors = np.linalg.norm(projected - pixels, axis=2).mean(axis=1)
    return int(errors.argmin()), errors.min().item()


def pure_python(points, pixels, fovs, width, height):
    """Lists, math and min over tuples."""
    def error(fov):
        f = height / (2 * math.tan(fov / 2))
        total = 0.0
        for (x, y, z), (u, v) in zip(points.tolist(), pixels.tolist()):
            total += math.hypot(f * x / z + (width - 1) / 2 - u, f * y / z + (height - 1) / 2 - v)
        return total / len(points)

    error_px, camera = min((error(float(fov)), k) for k, fov in enumerate(fovs))
    return camera, error_px


def with_matrices(points, pixels, fovs, width, height):
    """A 3x3 K per camera, homogeneous coordinates; error as NumPy float64; of equal cameras the last."""
    errors = []
    for fov in fovs:
        K = np.diag([1.0, 1.0, 1.0])
        K[0, 0] = K[1, 1] = height / 2 / np.tan(fov / 2)
        K[:2, 2] = (width - 1) / 2, (height - 1) / 2
        h = points @ K.T
        errors.append(np.sqrt(np.sum((h[:, :2] / h[:, 2:] - pixels) ** 2, axis=1)).mean())
    errors = np.array(errors)
    camera = len(errors) - 1 - int(np.argmin(errors[::-1]))
    return camera, errors[camera]


Answer = collections.namedtuple("Answer", "camera error_px")


def with_opencv(points, pixels, fovs, width, height):
    """cv2.projectPoints and a named tuple."""
    zero = np.zeros(3)
    distances = {}
    for k in range(len(fovs)):
        f = (height / 2) / math.tan(fovs[k] / 2)
        K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
        projected = cv2.projectPoints(np.array(points, dtype=np.float64), zero, zero, K, None)[0].reshape(-1, 2)
        distances[k] = float(np.linalg.norm(projected - pixels, axis=1).mean())
    camera = min(distances, key=distances.get)
    return Answer(camera, distances[camera])


def least_squares(points, pixels, fovs, width, height):
    """"Best" by the sum of squares (likeliest for normal noise); the error reported is the mean distance."""
    center = np.array([(width - 1) / 2, (height - 1) / 2])
    slopes = points[:, :2] / points[:, [2]]
    focals = [(height / 2) / np.tan(fov / 2) for fov in fovs]
    squares = [float(((f * slopes + center - pixels) ** 2).sum()) for f in focals]
    camera = squares.index(min(squares))
    off = focals[camera] * slopes + center - pixels
    return camera, float(np.mean(np.sqrt(np.einsum("ij,ij->i", off, off))))


class _Candidate:
    def __init__(self, number, fov, width, height):
        self.number = number
        self.f = height / 2 * math.cos(fov / 2) / math.sin(fov / 2)
        self.c = complex((width - 1) / 2, (height - 1) / 2)

    def error(self, slopes, found):
        return float(np.abs(self.f * slopes + self.c - found).mean())


def with_complex_numbers(points, pixels, fovs, width, height):
    """A class per candidate; pixels as complex numbers, sorted by error."""
    slopes = (points[:, 0] + 1j * points[:, 1]) / points[:, 2]
    found = pixels[:, 0] + 1j * pixels[:, 1]
    candidates = [_Candidate(k, float(fov), width, height) for k, fov in enumerate(fovs)]
    candidates.sort(key=lambda c: c.error(slopes, found))
    winner = candidates[0]
    return winner.number, winner.error(slopes, found)


ANSWERS = [loop_over_cameras, all_at_once, pure_python, with_matrices, with_opencv, least_squares,
           with_complex_numbers]
