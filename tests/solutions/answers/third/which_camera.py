"""Right answers to which_camera, as strangers wrote them."""
import math

import cv2
import numpy as np


# 1. all cameras at once
def which_vectorised(points, pixels, fovs, width, height):
    f = height / 2 / np.tan(fovs / 2)
    xy = points[:, :2] / points[:, 2:]
    center = np.array([(width - 1) / 2, (height - 1) / 2])
    projected = f[:, None, None] * xy + center
    errors = np.linalg.norm(projected - pixels, axis=2).mean(axis=1)
    camera = int(np.argmin(errors))
    return camera, float(errors[camera])


# 2. beginner
def which_beginner(points, pixels, fovs, width, height):
    best_camera = -1
    best_error = 1e30
    for camera in range(len(fovs)):
        f = (height / 2) / math.tan(fovs[camera] / 2)
        total = 0
        for i in range(len(points)):
            x = points[i][0]
            y = points[i][1]
            z = points[i][2]
            u = f * x / z + (width - 1) / 2
            v = f * y / z + (height - 1) / 2
            total = total + math.sqrt((u - pixels[i][0]) ** 2 + (v - pixels[i][1]) ** 2)
        error = total / len(points)
        if error < best_error:
            best_error = error
            best_camera = camera
    return best_camera, best_error


# 3. OpenCV
def which_opencv(points, pixels, fovs, width, height):
    def error(fov):
        f = 0.5 * height / np.tan(0.5 * fov)
        K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
        seen = cv2.projectPoints(points.reshape(-1, 1, 3), np.zeros(3), np.zeros(3), K, None)[0]
        return np.hypot(*(seen.reshape(-1, 2) - pixels).T).mean()

    return min(((k, error(fov)) for k, fov in enumerate(fovs)), key=lambda pair: pair[1])


# 4. mathematician: estimate f by least squares, take the camera with the nearest f
def which_least_squares(points, pixels, fovs, width, height):
    a = (points[:, :2] / points[:, 2:3]).reshape(-1, 1)
    b = (pixels - [(width - 1) / 2, (height - 1) / 2]).reshape(-1)
    (f_seen,), *_ = np.linalg.lstsq(a, b, rcond=None)
    f = (height / 2) / np.tan(np.asarray(fovs) / 2)
    camera = np.abs(f - f_seen).argmin()
    rest = (a[:, 0] * f[camera] - b).reshape(-1, 2)
    return camera, np.sqrt((rest ** 2).sum(axis=1)).mean()


# 5. Java
class CandidateCamera:
    def __init__(self, number, fov_y, width, height):
        f = height / (2.0 * math.tan(fov_y / 2.0))
        self.number = number
        self._K = np.array([[f, 0, (width - 1) / 2.0], [0, f, (height - 1) / 2.0], [0, 0, 1]])

    def project(self, point):
        u, v, w = self._K @ point
        return u / w, v / w

    def mean_error(self, points, pixels):
        distances = [math.dist(self.project(p), q) for p, q in zip(points, pixels)]
        return math.fsum(distances) / len(distances)


def which_java(points, pixels, fovs, width, height):
    if len(points) != len(pixels):
        raise ValueError("one pixel per point")
    cameras = [CandidateCamera(i, float(fov), width, height) for i, fov in enumerate(fovs)]
    ranked = sorted(cameras, key=lambda c: c.mean_error(points, pixels))
    return ranked[0].number, ranked[0].mean_error(points, pixels)


# 6. homogeneous einsum, a stack of K
def which_einsum(points, pixels, fovs, width, height):
    f = np.divide(height / 2, np.tan(np.divide(fovs, 2)))
    K = np.zeros((len(f), 3, 3))
    K[:, 0, 0] = K[:, 1, 1] = f
    K[:, :, 2] = [(width - 1) / 2, (height - 1) / 2, 1]
    h = np.einsum("cij,nj->cni", K, points)
    offset = h[..., :2] / h[..., 2:] - pixels[None]
    e = np.sqrt(np.einsum("cni,cni->cn", offset, offset)).mean(axis=-1)
    return [np.argsort(e)[0], np.min(e)]


# 7. R: sapply, which.min; the smallest sum of squares decides
def which_squares(points, pixels, fovs, width, height):
    table = []
    for fov in np.nditer(np.asarray(fovs, float)):
        f = height / 2 / np.tan(fov / 2)
        du = f * points[:, 0] / points[:, 2] + (width - 1) / 2 - pixels[:, 0]
        dv = f * points[:, 1] / points[:, 2] + (height - 1) / 2 - pixels[:, 1]
        table.append((np.sum(du * du + dv * dv), np.mean(np.sqrt(du * du + dv * dv))))
    sums, means = zip(*table)
    camera = sums.index(min(sums))
    return camera, means[camera]


ANSWERS = [which_vectorised, which_beginner, which_opencv, which_least_squares, which_java,
           which_einsum, which_squares]
