"""Right answers to depth_to_pointcloud, as strangers wrote them."""
import math
from typing import NamedTuple, Optional

import cv2
import numpy as np


# 1. the usual one
def cloud_mgrid(depth_metric, K, rgb_image=None):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    v, u = np.nonzero(valid)
    z = depth_metric[valid]
    points = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return points, None if rgb_image is None else rgb_image[valid] / 255.0


# 2. beginner
def cloud_beginner(depth_metric, K, rgb_image=None):
    fx = K[0][0]
    fy = K[1][1]
    cx = K[0][2]
    cy = K[1][2]
    height, width = depth_metric.shape
    points = []
    colors = []
    for u in range(width):
        for v in range(height):
            z = float(depth_metric[v][u])
            if math.isnan(z) or math.isinf(z):
                continue
            if z <= 0.01 or z >= 10:
                continue
            x = (u - cx) / fx * z
            y = (v - cy) / fy * z
            points.append([x, y, z])
            if rgb_image is not None:
                r, g, b = rgb_image[v][u]
                colors.append([float(r) / 255, float(g) / 255, float(b) / 255])
    points = np.array(points).reshape(-1, 3)
    if rgb_image is None:
        return points, None
    else:
        return points, np.array(colors).reshape(-1, 3)


# 3. mathematician: z K^-1 (u, v, 1)
def cloud_inverse(depth_metric, K, rgb_image=None):
    H, W = depth_metric.shape
    uv1 = np.stack(np.broadcast_arrays(np.arange(W), np.arange(H)[:, None], 1), axis=-1)
    rays = np.einsum("ij,hwj->hwi", np.linalg.inv(K), uv1.astype(float))
    with np.errstate(invalid="ignore"):
        p = rays * depth_metric[..., None]
    keep = (0.01 < depth_metric) & (depth_metric < 10.0)
    colors = None
    if rgb_image is not None:
        colors = np.true_divide(rgb_image, 255)[keep]
    return p[keep], colors


# 4. float32 throughout
def cloud_float32(depth_metric, K, rgb_image=None):
    keep = ((depth_metric > 0.01) & (depth_metric < 10)).ravel()
    d = depth_metric.astype(np.float32).ravel()
    u, v = np.meshgrid(np.arange(depth_metric.shape[1], dtype=np.float32),
                       np.arange(depth_metric.shape[0], dtype=np.float32))
    fx, fy, cx, cy = (np.float32(K[i, j]) for i, j in ((0, 0), (1, 1), (0, 2), (1, 2)))
    z = d[keep]
    out = np.empty((z.size, 3), np.float32)
    out[:, 0] = (u.ravel()[keep] - cx) / fx * z
    out[:, 1] = (v.ravel()[keep] - cy) / fy * z
    out[:, 2] = z
    if rgb_image is None:
        return out, None
    return out, rgb_image.reshape(-1, 3)[keep].astype(np.float32) / np.float32(255)


# 5. OpenCV: inverse depth taken for disparity
def cloud_reproject(depth_metric, K, rgb_image=None):
    depth = np.asarray(depth_metric)
    valid = np.logical_and(np.greater(depth, 0.01), np.less(depth, 10))
    inverse = np.zeros(depth.shape, np.float32)
    inverse[valid] = 1.0 / depth[valid]
    Q = np.array([[1 / K[0, 0], 0, 0, -K[0, 2] / K[0, 0]],
                  [0, 1 / K[1, 1], 0, -K[1, 2] / K[1, 1]],
                  [0, 0, 0, 1.0],
                  [0, 0, 1.0, 0]])
    xyz = cv2.reprojectImageTo3D(inverse, Q)
    colors = None
    if rgb_image is not None:
        colors = cv2.LUT(rgb_image, (np.arange(256) / 255).reshape(1, 256))[valid]
    return xyz[valid], colors


# 6. OpenCV: undistortPoints gives the rays
def cloud_undistort(depth_metric, K, rgb_image=None):
    rows, cols = np.where((depth_metric > 0.01) & (depth_metric < 10))
    if len(rows) == 0:
        empty = np.zeros((0, 3))
        return empty, (None if rgb_image is None else empty.copy())
    pixels = np.column_stack([cols, rows]).astype(np.float64).reshape(-1, 1, 2)
    rays = cv2.undistortPoints(pixels, np.asarray(K, np.float64), None)
    z = depth_metric[rows, cols].astype(np.float64)[:, None]
    points = cv2.convertPointsToHomogeneous(rays).reshape(-1, 3) * z
    if rgb_image is None:
        return points, None
    return points, np.array([rgb_image[r, c] / 255 for r, c in zip(rows, cols)]).reshape(-1, 3)


# 7. Matlab: columns first (column-major), permuted at the end
def cloud_matlab(depth_metric, K, rgb_image=None):
    D = np.asfortranarray(depth_metric).ravel(order="F").astype(float)
    H, W = depth_metric.shape
    lin = np.arange(H * W)
    V, U = lin % H, lin // H                                    # ind2sub
    D[~np.isfinite(D)] = 0
    ok = np.nonzero((D > 0.01) * (D < 10))[0]
    A = np.linalg.solve(np.asarray(K, float), np.vstack([U[ok], V[ok], np.ones(len(ok))]) * D[ok])
    C = None
    if rgb_image is not None:
        C = np.column_stack([rgb_image[:, :, k].ravel(order="F")[ok] for k in range(3)]) / 255
    return A.T, C


# 8. Java: typed, validated, with a record per pixel
class ColoredPoint(NamedTuple):
    x: float
    y: float
    z: float
    color: Optional[tuple]


class PointCloudFactory:
    NEAR = 0.01
    FAR = 10.0

    def __init__(self, K):
        if np.shape(K) != (3, 3):
            raise ValueError(f"K has shape {np.shape(K)}, not (3, 3)")
        self.fx, self.fy, self.cx, self.cy = map(float, (K[0, 0], K[1, 1], K[0, 2], K[1, 2]))

    def points(self, depth, rgb):
        for (v, u), z in np.ndenumerate(depth):
            z = float(z)
            if self.NEAR < z < self.FAR:
                color = None if rgb is None else tuple(int(c) / 255 for c in rgb[v, u])
                yield ColoredPoint(z * (u - self.cx) / self.fx, z * (v - self.cy) / self.fy,
                                   z, color)


def cloud_java(depth_metric, K, rgb_image=None):
    if depth_metric.ndim != 2:
        raise ValueError("a depth image has two dimensions")
    if rgb_image is not None and rgb_image.shape[:2] != depth_metric.shape:
        raise ValueError("color and depth differ in size")
    found = list(PointCloudFactory(K).points(depth_metric, rgb_image))
    points = np.array([p[:3] for p in found], float).reshape(len(found), 3)
    if rgb_image is None:
        return points, None
    return points, np.array([p.color for p in found], float).reshape(len(found), 3)


# 9. R: masked array, compressed column by column
def cloud_masked(depth_metric, K, rgb_image=None):
    z = np.ma.masked_invalid(depth_metric)
    z = np.ma.masked_where((z.filled(0) <= 0.01) | (z.filled(0) >= 10), z)
    v, u = np.indices(z.shape)
    x = (u - K[0, 2]) / K[0, 0] * z
    y = (v - K[1, 2]) / K[1, 1] * z
    points = np.c_[x.compressed(), y.compressed(), z.compressed()]
    if rgb_image is None:
        return points, None
    m = np.ma.getmaskarray(z)
    return points, np.c_[tuple(np.ma.array(c, mask=m).compressed() for c in cv2.split(rgb_image))] / 255


ANSWERS = [cloud_mgrid, cloud_beginner, cloud_inverse, cloud_float32, cloud_reproject,
           cloud_undistort, cloud_matlab, cloud_java, cloud_masked]
