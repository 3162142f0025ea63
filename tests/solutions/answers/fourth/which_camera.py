"""Right answers to which_camera, as strangers wrote them."""
import math

import cv2
import numpy as np


def f1(points, pixels, fovs, width, height):
    best, best_error = None, np.inf
    for i, fov in enumerate(fovs):
        f = height / 2 / np.tan(fov / 2)
        u = f * points[:, 0] / points[:, 2] + (width - 1) / 2
        v = f * points[:, 1] / points[:, 2] + (height - 1) / 2
        error = np.mean(np.hypot(u - pixels[:, 0], v - pixels[:, 1]))
        if error < best_error:
            best, best_error = i, error
    return best, best_error


def f2(points, pixels, fovs, width, height):
    f = height / (2 * np.tan(np.asarray(fovs) / 2))
    xy = points[:, :2] / points[:, 2:]
    uv = f[:, None, None] * xy[None] + [(width - 1) / 2, (height - 1) / 2]
    errors = np.linalg.norm(uv - pixels, axis=2).mean(axis=1)
    k = errors.argmin()
    return k, errors[k]


def f3(points, pixels, fovs, width, height):
    def K(fov):
        f = 0.5 * height / math.tan(fov / 2)
        return np.array([[f, 0, width / 2 - 0.5], [0, f, height / 2 - 0.5], [0, 0, 1]])

    def error(fov):
        h = (K(fov) @ points.T).T
        return float(np.sqrt(((h[:, :2] / h[:, 2:3] - pixels) ** 2).sum(axis=1)).mean())

    errors = list(map(error, fovs))
    return errors.index(min(errors)), min(errors)


def f4(points, pixels, fovs, width, height):
    results = []
    for i in range(len(fovs)):
        f = height / 2 / math.tan(float(fovs[i]) / 2)
        total = 0.0
        for (x, y, z), (u, v) in zip(points.tolist(), pixels.tolist()):
            total += math.dist((f * x / z + (width - 1) / 2, f * y / z + (height - 1) / 2), (u, v))
        results.append((total / len(points), i))
    error, camera = min(results)
    return camera, error


def f5(points, pixels, fovs, width, height):
    errors = np.empty(len(fovs))
    for i, fov in enumerate(fovs):
        K = np.diag([height / 2 / np.tan(fov / 2)] * 2 + [1])
        K[:2, 2] = (width - 1) / 2, (height - 1) / 2
        uv, _ = cv2.projectPoints(np.array(points, float).reshape(-1, 1, 3), np.zeros(3), np.zeros(3), K, None)
        errors[i] = np.linalg.norm(uv[:, 0] - pixels, axis=1).mean()
    order = np.argsort(errors)
    return int(order[0]), float(errors[order[0]])


class Candidate:
    def __init__(self, number, fov, size):
        if not 0 < fov < np.pi:
            raise ValueError("fov out of range")
        self.number = number
        self.f = size[1] / 2 / np.tan(fov / 2)
        self.center = (np.asarray(size) - 1) / 2

    def error(self, points, pixels):
        off = self.f * points[:, :2] / points[:, 2, None] + self.center - pixels
        return np.abs(off[:, 0] + 1j * off[:, 1]).mean()


def f6(points, pixels, fovs, width, height):
    cameras = [Candidate(i, fov, (width, height)) for i, fov in enumerate(fovs)]
    winner = min(cameras, key=lambda c: c.error(points, pixels))
    return winner.number, float(winner.error(points, pixels))


ANSWERS = [f1, f2, f3, f4, f5, f6]
