"""Right answers to depth_to_pointcloud, as strangers wrote them."""
from dataclasses import dataclass
from typing import Optional

import cv2
import numpy as np


# 1. the usual
def f1(depth_metric, K, rgb_image=None):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    v, u = np.nonzero(valid)
    z = depth_metric[valid]
    x = (u - K[0, 2]) * z / K[0, 0]
    y = (v - K[1, 2]) * z / K[1, 1]
    points = np.stack([x, y, z], axis=-1)
    colors = None if rgb_image is None else rgb_image[valid] / 255
    return points, colors


# 2. inverse of K, columns first (another order)
def f2(depth_metric, K, rgb_image=None):
    H, W = depth_metric.shape
    u, v = np.meshgrid(np.arange(W), np.arange(H), indexing="ij")
    u, v = u.ravel(), v.ravel()
    z = depth_metric[v, u].astype(float)
    keep = (z > 0.01) & (z < 10)
    u, v, z = u[keep], v[keep], z[keep]
    P = (np.linalg.inv(K) @ np.vstack([u, v, np.ones(len(u))]) * z).T
    if rgb_image is None:
        return P, None
    return P, rgb_image[v, u].astype(np.float64) / 255.0


# 3. C programmer
def f3(depth_metric, K, rgb_image=None):
    H, W = depth_metric.shape
    fx, fy, cx, cy = float(K[0][0]), float(K[1][1]), float(K[0][2]), float(K[1][2])
    pts, cols = [], []
    for v in range(H):
        for u in range(W):
            z = float(depth_metric[v, u])
            if not (z > 0.01 and z < 10.0):
                continue
            pts.append(((u - cx) / fx * z, (v - cy) / fy * z, z))
            if rgb_image is not None:
                r, g, b = rgb_image[v, u]
                cols.append((int(r) / 255.0, int(g) / 255.0, int(b) / 255.0))
    points = np.array(pts, dtype=float).reshape(-1, 3)
    if rgb_image is None:
        return points, None
    return points, np.array(cols, dtype=float).reshape(-1, 3)


# 4. float32
def f4(depth_metric, K, rgb_image=None):
    with np.errstate(invalid="ignore"):
        good = (depth_metric > 0.01) & (depth_metric < 10.0)
    D = depth_metric.astype(np.float32)
    k = np.asarray(K, np.float32)
    H, W = D.shape
    xs = (np.arange(W, dtype=np.float32) - k[0, 2]) / k[0, 0]
    ys = (np.arange(H, dtype=np.float32) - k[1, 2]) / k[1, 1]
    cloud = np.empty((H, W, 3), np.float32)
    with np.errstate(invalid="ignore"):
        np.multiply(xs[None, :], D, out=cloud[..., 0])
        np.multiply(ys[:, None], D, out=cloud[..., 1])
    cloud[..., 2] = D
    colors = None
    if rgb_image is not None:
        colors = rgb_image[good].astype(np.float32) * np.float32(1 / 255)
    return cloud[good], colors


# 5. undistortPoints gives the rays
def f5(depth_metric, K, rgb_image=None):
    with np.errstate(invalid="ignore"):
        pixels = np.argwhere((depth_metric > 0.01) & (depth_metric < 10))[:, ::-1]
    z = depth_metric[pixels[:, 1], pixels[:, 0]].astype(np.float64)
    if len(z):
        rays = cv2.undistortPoints(pixels.astype(np.float64).reshape(-1, 1, 2),
                                   np.asarray(K, np.float64), None).reshape(-1, 2)
    else:
        rays = np.zeros((0, 2))
    points = np.column_stack([rays * z[:, None], z])
    if rgb_image is None:
        return points, None
    return points, np.divide(rgb_image[pixels[:, 1], pixels[:, 0]], 255)


# 6. class with solve, colors in float32; the cloud comes back to front
@dataclass
class _BackProjector:
    K: np.ndarray
    near: float = 0.01
    far: float = 10.0

    def __post_init__(self):
        self.K = np.array(self.K, dtype=float)
        if self.K.shape != (3, 3):
            raise ValueError("K must be 3 x 3")

    def mask(self, depth):
        finite = np.isfinite(depth)
        inside = np.zeros(depth.shape, bool)
        inside[finite] = (depth[finite] > self.near) & (depth[finite] < self.far)
        return inside

    def __call__(self, depth, rgb: Optional[np.ndarray]):
        if rgb is not None and rgb.shape[:2] != depth.shape:
            raise ValueError("picture and depth differ in size")
        index = np.flatnonzero(self.mask(depth))[::-1]
        v, u = np.divmod(index, depth.shape[1])
        z = depth.reshape(-1)[index]
        homogeneous = np.stack([u * z, v * z, z]).astype(float)
        points = np.linalg.solve(self.K, homogeneous).T
        colors = None if rgb is None else (rgb.reshape(-1, 3)[index] / np.float32(255))
        return np.ascontiguousarray(points), colors


def f6(depth_metric, K, rgb_image=None):
    return _BackProjector(K)(np.asarray(depth_metric), rgb_image)


# 7. one line each
def f7(depth_metric, K, rgb_image=None):
    m = (depth_metric > .01) & (depth_metric < 10)
    return (np.c_[np.argwhere(m)[:, ::-1], np.ones(m.sum())] @ np.linalg.inv(K).T * depth_metric[m][:, None], rgb_image[m] / 255. if rgb_image is not None else None)


# 8. a generator into fromiter, colors through a table
def f8(depth_metric, K, rgb_image=None):
    table = np.linspace(0, 1, 256)
    rows = [(v, u) for v, u in np.ndindex(depth_metric.shape) if 0.01 < depth_metric[v, u] < 10]
    K = np.array(K, float)

    def numbers():
        for v, u in rows:
            z = float(depth_metric[v, u])
            yield z * (u - K[0, 2]) / K[0, 0]
            yield z * (v - K[1, 2]) / K[1, 1]
            yield z

    points = np.fromiter(numbers(), dtype=np.float64, count=3 * len(rows)).reshape(len(rows), 3)
    colors = None
    if rgb_image is not None:
        colors = np.array([table[rgb_image[v, u]] for v, u in rows]).reshape(len(rows), 3)
    return points, colors


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
