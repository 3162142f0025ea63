"""Right answers to project_visible_points, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1. the one who writes NumPy every day
def project_vectorised(points_world, T_world_cam, K, depth_metric):
    T = np.linalg.inv(T_world_cam)
    p = points_world @ T[:3, :3].T + T[:3, 3]
    z = p[:, 2]
    in_front = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[in_front, 0] = K[0, 0] * p[in_front, 0] / z[in_front] + K[0, 2]
    pixels[in_front, 1] = K[1, 1] * p[in_front, 1] / z[in_front] + K[1, 2]
    H, W = depth_metric.shape
    visible = np.zeros(len(p), dtype=bool)
    idx = np.flatnonzero(in_front)
    uv = np.rint(pixels[idx]).astype(np.int64)
    inside = (uv[:, 0] >= 0) & (uv[:, 0] < W) & (uv[:, 1] >= 0) & (uv[:, 1] < H)
    idx, uv = idx[inside], uv[inside]
    d = depth_metric[uv[:, 1], uv[:, 0]].astype(np.float64)
    valid = (d > 0.01) & (d < 10)
    visible[idx] = ~valid | (z[idx] <= d + 0.02)
    return pixels, visible


# 2. the beginner: loops over everything
def project_beginner(points_world, T_world_cam, K, depth_metric):
    number_of_points = points_world.shape[0]
    height = depth_metric.shape[0]
    width = depth_metric.shape[1]
    world_to_cam = np.linalg.inv(T_world_cam)
    pixels = np.zeros((number_of_points, 2))
    visible = np.zeros(number_of_points, dtype=bool)
    for i in range(number_of_points):
        cam = [0.0, 0.0, 0.0]
        for row in range(3):
            total = world_to_cam[row, 3]
            for column in range(3):
                total = total + world_to_cam[row, column] * points_world[i, column]
            cam[row] = total
        x, y, z = cam
        if z <= 0.01:
            pixels[i, 0] = float("nan")
            pixels[i, 1] = float("nan")
            continue
        u = K[0, 0] * x / z + K[0, 2]
        v = K[1, 1] * y / z + K[1, 2]
        pixels[i, 0] = u
        pixels[i, 1] = v
        column = math.floor(u + 0.5)
        row = math.floor(v + 0.5)
        if column < 0 or column > width - 1:
            continue
        if row < 0 or row > height - 1:
            continue
        measured = float(depth_metric[row, column])
        if math.isnan(measured) or measured <= 0.01 or measured >= 10:
            visible[i] = True
        elif z - measured <= 0.02:
            visible[i] = True
        else:
            visible[i] = False
    return pixels, visible


# 3. the mathematician: homogeneous coordinates, one 3x4 matrix
def project_homogeneous(points_world, T_world_cam, K, depth_metric):
    n = len(points_world)
    X = np.vstack([points_world.T, np.ones((1, n))])          # 4 x N
    camera = np.linalg.solve(T_world_cam, X)                   # 4 x N
    P = K @ np.hstack([np.eye(3), np.zeros((3, 1))])           # 3 x 4
    h = P @ camera
    z = camera[2]
    ok = z > 0.01
    with np.errstate(divide="ignore", invalid="ignore"):
        uv = np.where(ok, h[:2] / h[2], np.nan)
    safe = np.where(ok, uv, -99.0)
    j, i = np.floor(safe + 0.5).astype(int)
    H, W = depth_metric.shape
    inside = ok & (0 <= j) & (j <= W - 1) & (0 <= i) & (i <= H - 1)
    d = depth_metric[np.clip(i, 0, H - 1), np.clip(j, 0, W - 1)]
    d = np.asarray(d, float)
    hides = (d > 0.01) & (d < 10.0) & (z - d > 0.02)
    return uv.T, inside & ~hides


# 4. the one who knows OpenCV
def project_opencv(points_world, T_world_cam, K, depth_metric):
    R = T_world_cam[:3, :3].T
    rvec, _ = cv2.Rodrigues(np.ascontiguousarray(R))
    tvec = -R @ T_world_cam[:3, 3]
    z = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, 2]
    pixels = np.empty((len(points_world), 2))
    pixels.fill(np.nan)
    front = z > 0.01
    if front.any():
        pts = np.ascontiguousarray(points_world[front], dtype=np.float64)
        pixels[front] = cv2.projectPoints(pts, rvec, tvec, K, None)[0].reshape(-1, 2)
    # surface: NaN, 0 and far become "infinitely far", which hides nothing
    surface = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.inf)
    surface = surface.astype(np.float64)
    visible = front.copy()
    for k in np.nonzero(front)[0]:
        u, v = round(pixels[k, 0]), round(pixels[k, 1])
        if 0 <= u < surface.shape[1] and 0 <= v < surface.shape[0]:
            visible[k] = z[k] <= surface[v, u] + 0.02
        else:
            visible[k] = False
    return pixels, visible


# 5. Java habits
@dataclass(frozen=True)
class _Projected:
    u: float
    v: float
    visible: bool


class _PinholeProjector:
    """A projector with private state and small methods."""

    MIN_DEPTH, MAX_DEPTH, TOLERANCE = 0.01, 10.0, 0.02

    def __init__(self, pose, K, depth):
        if pose.shape != (4, 4):
            raise ValueError("pose must be 4 x 4")
        if K.shape != (3, 3):
            raise ValueError("K must be 3 x 3")
        self._rotation = pose[:3, :3]
        self._position = pose[:3, 3]
        self._K = K
        self._depth = depth

    def _is_inside(self, column, row):
        height, width = self._depth.shape
        return 0 <= column < width and 0 <= row < height

    def _is_hidden(self, z, column, row):
        measured = float(self._depth[row, column])
        is_valid = self.MIN_DEPTH < measured < self.MAX_DEPTH
        return is_valid and z > measured + self.TOLERANCE

    def project(self, point):
        x, y, z = (float(a) for a in self._rotation.T @ (point - self._position))
        if not z > self.MIN_DEPTH:
            return _Projected(math.nan, math.nan, False)
        u = float(self._K[0, 0]) * (x / z) + float(self._K[0, 2])
        v = float(self._K[1, 1]) * (y / z) + float(self._K[1, 2])
        column, row = int(round(u)), int(round(v))
        seen = self._is_inside(column, row) and not self._is_hidden(z, column, row)
        return _Projected(u, v, seen)


def project_java(points_world, T_world_cam, K, depth_metric):
    projector = _PinholeProjector(T_world_cam, K, depth_metric)
    results = [projector.project(p) for p in points_world]
    pixels = np.array([(r.u, r.v) for r in results], dtype=float).reshape(-1, 2)
    visible = np.array([r.visible for r in results], dtype=bool)
    return pixels, visible


# 6. the R student: masked arrays and ifelse, einsum
def project_masked(points_world, T_world_cam, K, depth_metric):
    offset = points_world - T_world_cam[:3, 3]
    cam = np.einsum("ji,nj->ni", T_world_cam[:3, :3], offset)
    z = np.ma.masked_less_equal(cam[:, 2], 0.01)
    u = K[0, 0] * cam[:, 0] / z + K[0, 2]
    v = K[1, 1] * cam[:, 1] / z + K[1, 2]
    pixels = np.ma.stack([u, v], axis=1).filled(np.nan)
    H, W = depth_metric.shape
    known = np.isfinite(pixels).all(axis=1)
    col = np.rint(np.where(known, pixels[:, 0], -5)).astype(int)
    row = np.rint(np.where(known, pixels[:, 1], -5)).astype(int)
    inside = (col >= 0) & (col < W) & (row >= 0) & (row < H)
    d = np.ma.masked_all(len(cam))
    d[inside] = depth_metric[row[inside], col[inside]]
    d = np.ma.masked_invalid(d)
    d = np.ma.masked_outside(d, np.nextafter(0.01, 1), np.nextafter(10.0, 0))
    limit = d.filled(np.inf) + 0.02
    return pixels, inside & (cam[:, 2] <= limit)


# 7. Matlab habits: everything transposed, linear indices, one padded image
def project_matlab(points_world, T_world_cam, K, depth_metric):
    D = np.pad(depth_metric.astype(np.float64), 1, constant_values=-1)  # ring = outside
    H, W = D.shape
    R, t = T_world_cam[0:3, 0:3], T_world_cam[0:3, 3:4]
    C = np.linalg.inv(R) @ (points_world.T - t)                         # 3 x N
    Z = C[2, :]
    UV = np.nan * np.zeros((2, C.shape[1]))
    f = np.nonzero(Z > 0.01)[0]
    UV[:, f] = (K[0:2, 0:2] @ C[0:2, f]) / Z[f] + K[0:2, 2:3]
    vis = np.zeros(C.shape[1]) > 0
    c = np.minimum(np.maximum(np.floor(UV[0, f] + 0.5) + 1, 0), W - 1)
    r = np.minimum(np.maximum(np.floor(UV[1, f] + 0.5) + 1, 0), H - 1)
    lin = (r * W + c).astype(np.int64)                                  # sub2ind
    inner = (c > 0) & (c < W - 1) & (r > 0) & (r < H - 1)
    d = D.ravel()[lin]
    free = np.logical_not(np.logical_and(d > 0.01, d < 10))
    vis[f] = inner & (free | (Z[f] <= d + 0.02))
    return UV.T, vis


ANSWERS = [project_vectorised, project_beginner, project_homogeneous, project_opencv,
           project_java, project_masked, project_matlab]
