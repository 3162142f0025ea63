"""Right answers to depth_to_pointcloud, as strangers wrote them."""
from typing import Iterator, Optional, Tuple

import cv2
import numpy as np


# 1. mgrid and a mask
def f1(depth_metric, K, rgb_image=None):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    v, u = np.nonzero(valid)
    z = depth_metric[valid]
    points = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=-1)
    colors = None if rgb_image is None else rgb_image[valid] / 255
    return points, colors


# 2. loops
def f2(depth_metric, K, rgb_image=None):
    points = []
    colors = []
    for v in range(depth_metric.shape[0]):
        for u in range(depth_metric.shape[1]):
            z = float(depth_metric[v, u])
            if z <= 0.01 or z >= 10 or z != z:
                continue
            points.append([(u - K[0, 2]) / K[0, 0] * z, (v - K[1, 2]) / K[1, 1] * z, z])
            if rgb_image is not None:
                colors.append([int(c) / 255 for c in rgb_image[v, u]])
    points = np.array(points, dtype=float).reshape(-1, 3)
    if rgb_image is None:
        return points, None
    return points, np.array(colors, dtype=float).reshape(-1, 3)


# 3. K inverse times homogeneous pixels
def f3(depth_metric, K, rgb_image=None):
    H, W = depth_metric.shape
    uv1 = np.indices((H, W))[::-1].reshape(2, -1)
    uv1 = np.vstack([uv1, np.ones(H * W)])
    z = np.asarray(depth_metric, float).reshape(-1)
    with np.errstate(invalid="ignore"):
        keep = (z > 0.01) & (z < 10.0)
    points = (np.linalg.inv(K) @ uv1[:, keep] * z[keep]).T
    if rgb_image is not None:
        return points, rgb_image.reshape(-1, 3)[keep].astype(float) / 255.0
    return points, None


# 4. float32 throughout, column by column order
def f4(depth_metric, K, rgb_image=None):
    d = depth_metric.astype(np.float32).T
    k = K.astype(np.float32)
    u, v = np.meshgrid(np.arange(d.shape[0], dtype=np.float32),
                       np.arange(d.shape[1], dtype=np.float32), indexing="ij")
    ok = np.logical_and(d > np.float32(0.01), d < np.float32(10))
    cloud = np.dstack([(u - k[0, 2]) / k[0, 0] * d, (v - k[1, 2]) / k[1, 1] * d, d])[ok]
    if rgb_image is None:
        return cloud, None
    return cloud, rgb_image.transpose(1, 0, 2)[ok].astype(np.float32) / np.float32(255)


# 5. game developer: rgbd -> Q matrix of reprojectImageTo3D
def f5(depth_metric, K, rgb_image=None):
    z = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.nan)
    ray = cv2.reprojectImageTo3D(
        np.ones(z.shape, np.float32),
        np.array([[1 / K[0, 0], 0, 0, -K[0, 2] / K[0, 0]],
                  [0, 1 / K[1, 1], 0, -K[1, 2] / K[1, 1]],
                  [0, 0, 0, 1.0], [0, 0, 0, 1.0]]))
    keep = ~np.isnan(z)
    pts = (ray.astype(np.float64) * z[:, :, None].astype(np.float64))[keep]
    return pts, (None if rgb_image is None else np.divide(rgb_image[keep], 255.0))


# 6. undistortPoints gives the rays
def f6(depth_metric, K, rgb_image=None):
    pixels = np.argwhere((depth_metric > 0.01) & (depth_metric < 10))
    if len(pixels) == 0:
        return np.empty((0, 3)), None if rgb_image is None else np.empty((0, 3))
    z = depth_metric[pixels[:, 0], pixels[:, 1]].astype(np.float64)
    uv = pixels[:, None, ::-1].astype(np.float64)
    xy = cv2.undistortPoints(uv, np.asarray(K, np.float64), None).reshape(-1, 2)
    points = np.c_[xy * z[:, None], z]
    colors = None
    if rgb_image is not None:
        colors = np.array([rgb_image[v, u] for v, u in pixels]) / 255.0
    return points, colors


# 7. class with validation
class PinholeCamera:
    def __init__(self, K):
        K = np.asarray(K, dtype=np.float64)
        if K.shape != (3, 3):
            raise ValueError("K must be (3, 3)")
        self.fx, self.fy, self.cx, self.cy = K[0, 0], K[1, 1], K[0, 2], K[1, 2]

    def back_project(self, u, v, z):
        return np.column_stack([z * (u - self.cx) / self.fx, z * (v - self.cy) / self.fy, z])


class PointCloud:
    Z_MIN, Z_MAX = 0.01, 10.0

    def __init__(self, depth, K, rgb=None):
        if rgb is not None and rgb.shape[:2] != depth.shape:
            raise ValueError("sizes differ")
        self.mask = ~np.isnan(depth) & (depth > self.Z_MIN) & (depth < self.Z_MAX)
        v, u = np.where(self.mask)
        self.points = PinholeCamera(K).back_project(u, v, np.asarray(depth, float)[v, u])
        self.colors = rgb[v, u].astype(np.float32) / 255 if rgb is not None else None


def f7(depth_metric: np.ndarray, K: np.ndarray, rgb_image: Optional[np.ndarray] = None
       ) -> Tuple[np.ndarray, Optional[np.ndarray]]:
    cloud = PointCloud(depth_metric, K, rgb_image)
    return cloud.points, cloud.colors


# 8. pandas-like: a table of rows, shuffled on purpose by sorting on depth
def f8(depth_metric, K, rgb_image=None):
    h, w = depth_metric.shape
    u = np.tile(np.arange(w), h).astype(float)
    v = np.repeat(np.arange(h), w).astype(float)
    table = np.column_stack([u, v, np.ravel(depth_metric).astype(float)])
    if rgb_image is not None:
        table = np.column_stack([table, rgb_image.reshape(-1, 3)])
    table = table[np.abs(table[:, 2] - 5.005) < 4.995]
    table = table[(table[:, 2] > 0.01) & (table[:, 2] < 10)]
    table = table[table[:, 2].argsort()]
    xyz = np.linalg.solve(K, np.column_stack([table[:, :2], np.ones(len(table))]).T * table[:, 2]).T
    return xyz, table[:, 3:] / 255 if rgb_image is not None else None


# 9. generator and fromiter
def _walk(depth, K) -> Iterator[Tuple[float, float, float, int]]:
    fx, fy, cx, cy = map(float, (K[0, 0], K[1, 1], K[0, 2], K[1, 2]))
    for i, z in enumerate(depth.flat):
        if 0.01 < z < 10:
            v, u = divmod(i, depth.shape[1])
            yield (u - cx) * float(z) / fx, (v - cy) * float(z) / fy, float(z), i


def f9(depth_metric, K, rgb_image=None):
    t = np.fromiter(_walk(depth_metric, K), dtype=[("p", float, 3), ("i", int)]) if False else \
        np.array(list(_walk(depth_metric, K))).reshape(-1, 4)
    colors = None
    if rgb_image is not None:
        colors = rgb_image.reshape(-1, 3)[t[:, 3].astype(int)] * (1 / 255)
    return t[:, :3].copy(), colors


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8, f9]
