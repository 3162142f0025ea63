"""Right answers to project_visible_points, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1. NumPy
def f1(points_world, T_world_cam, K, depth_metric):
    R, t = T_world_cam[:3, :3], T_world_cam[:3, 3]
    p = (points_world - t) @ R
    z = p[:, 2]
    front = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[front, 0] = K[0, 0] * p[front, 0] / z[front] + K[0, 2]
    pixels[front, 1] = K[1, 1] * p[front, 1] / z[front] + K[1, 2]
    H, W = depth_metric.shape
    uv = np.rint(pixels)
    inside = front & (uv[:, 0] >= 0) & (uv[:, 0] < W) & (uv[:, 1] >= 0) & (uv[:, 1] < H)
    visible = inside.copy()
    u, v = uv[inside].astype(int).T
    measured = depth_metric[v, u].astype(float)
    blocks = (measured > 0.01) & (measured < 10) & (z[inside] > measured + 0.02)
    visible[inside] = ~blocks
    return pixels, visible


# 2. C programmer, half up
def f2(points_world, T_world_cam, K, depth_metric):
    H, W = depth_metric.shape
    N = len(points_world)
    pixels = np.empty((N, 2))
    visible = np.zeros(N, dtype=bool)
    for i in range(N):
        d = [float(points_world[i, k] - T_world_cam[k, 3]) for k in range(3)]
        x, y, z = (sum(float(T_world_cam[k, r]) * d[k] for k in range(3)) for r in range(3))
        if z <= 0.01:
            pixels[i] = math.nan
            continue
        u = x * K[0, 0] / z + K[0, 2]
        v = y * K[1, 1] / z + K[1, 2]
        pixels[i] = u, v
        c, r = math.floor(u + 0.5), math.floor(v + 0.5)
        if c < 0 or c >= W or r < 0 or r >= H:
            continue
        m = float(depth_metric[r, c])
        if 0.01 < m < 10 and z - m > 0.02:
            continue
        visible[i] = True
    return pixels, visible


# 3. homogeneous, inverse, padded depth with a rim that is never seen
def f3(points_world, T_world_cam, K, depth_metric):
    h = np.c_[points_world, np.ones(len(points_world))]
    P = np.c_[K, np.zeros(3)] @ np.linalg.inv(T_world_cam)
    q = np.einsum("ij,nj->ni", P, h)
    w = q[:, 2]
    far_enough = w > 0.01
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        pixels = np.where(far_enough[:, None], q[:, :2] / w[:, None], np.nan)
    H, W = depth_metric.shape
    with np.errstate(invalid="ignore"):
        wall = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.inf).astype(float)
    wall = np.pad(wall, 1, constant_values=-np.inf)
    col, row = np.clip(np.nan_to_num(np.round(pixels), nan=-1), -1, [W, H]).astype(int).T + 1
    return pixels, far_enough & (w <= wall[row, col] + 0.02)


# 4. projectPoints
def f4(points_world, T_world_cam, K, depth_metric):
    N = len(points_world)
    pixels = np.full((N, 2), np.nan)
    visible = np.zeros(N, bool)
    R = np.ascontiguousarray(T_world_cam[:3, :3].T, dtype=np.float64)
    t = -R @ T_world_cam[:3, 3]
    z = points_world @ R[2] + t[2]
    ahead = np.flatnonzero(z > 0.01)
    if len(ahead) == 0:
        return pixels, visible
    camera_points = points_world[ahead] @ R.T + t
    zero = np.zeros(3)
    image_points, _ = cv2.projectPoints(camera_points.reshape(-1, 1, 3), zero, zero,
                                        np.asarray(K, np.float64), None)
    pixels[ahead] = image_points.reshape(-1, 2)
    H, W = depth_metric.shape
    for i in ahead:
        u, v = (round(float(a)) for a in pixels[i])
        if 0 <= u < W and 0 <= v < H:
            m = depth_metric[v, u]
            hides = np.isfinite(m) and 0.01 < m < 10
            visible[i] = not hides or z[i] - float(m) <= 0.02
    return pixels, visible


# 5. over-engineered
@dataclass(frozen=True)
class _View:
    T: np.ndarray
    K: np.ndarray
    depth: np.ndarray
    near: float = 0.01
    far: float = 10.0
    slack: float = 0.02

    def to_camera(self, points):
        return np.linalg.solve(self.T, np.vstack([points.T, np.ones(len(points))]))[:3].T

    def project(self, p):
        out = np.full((len(p), 2), np.nan)
        ok = p[:, 2] > self.near
        h = p[ok] @ self.K.T
        out[ok] = h[:, :2] / h[:, 2:]
        return out

    def in_picture(self, pixels):
        limit = np.array(self.depth.shape[::-1])
        whole = np.floor(pixels + 0.5)
        return whole, np.all((whole >= 0) & (whole < limit), axis=1)

    def sees(self, z, column, row):
        surface = self.depth[row, column].astype(np.float64)
        valid = (surface > self.near) & (surface < self.far)
        return ~valid | (z - surface <= self.slack)


def f5(points_world, T_world_cam, K, depth_metric):
    view = _View(T_world_cam, K, depth_metric)
    p = view.to_camera(points_world)
    pixels = view.project(p)
    whole, inside = view.in_picture(pixels)
    visible = np.zeros(len(p), dtype=np.bool_)
    column, row = whole[inside].astype(np.int64).T
    visible[inside] = view.sees(p[inside, 2], column, row)
    return pixels, visible


# 6. nearest sample by cv2.remap
def f6(points_world, T_world_cam, K, depth_metric):
    p = (points_world - T_world_cam[:3, 3]).dot(T_world_cam[:3, :3])
    z = p[:, 2].copy()
    bad = ~(z > 0.01)
    safe = np.where(bad, 1.0, z)
    uv = p[:, :2] / safe[:, None] * [K[0, 0], K[1, 1]] + [K[0, 2], K[1, 2]]
    uv[bad] = np.nan
    H, W = depth_metric.shape
    r = np.floor(np.nan_to_num(uv, nan=-9) + 0.5)
    inside = ((r >= 0) & (r <= [W - 1, H - 1])).all(axis=1) & ~bad
    limit = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, 1e30).astype(np.float32)
    visible = np.zeros(len(p), bool)
    if inside.any():
        m = r[inside].astype(np.float32).reshape(-1, 1, 2)
        seen = cv2.remap(limit, m, None, cv2.INTER_NEAREST)[:, 0].astype(float)
        visible[inside] = z[inside] - seen <= 0.02
    return uv, visible


# 7. dictionary of pixels, one pass
def f7(points_world, T_world_cam, K, depth_metric):
    M = np.linalg.inv(T_world_cam)
    cam = [M[:3, :3] @ p + M[:3, 3] for p in points_world]
    uv = [(K @ (c / c[2]))[:2] if c[2] > .01 else np.full(2, np.nan) for c in cam]
    surface = {(u, v): float(z) for (v, u), z in np.ndenumerate(depth_metric)}
    seen = [bool(c[2] > .01) and (key := (int(np.rint(a)), int(np.rint(b)))) in surface and not (.01 < surface[key] < 10 and c[2] > surface[key] + .02) for c, (a, b) in zip(cam, uv)]
    return np.array(uv, float).reshape(-1, 2), np.array(seen, bool)


# 8. masked arrays
def f8(points_world, T_world_cam, K, depth_metric):
    Rt = np.linalg.inv(T_world_cam)[:3]
    x, y, z = Rt[:, :3] @ points_world.T + Rt[:, 3:]
    zm = np.ma.masked_less_equal(z, 0.01)
    u = K[0, 0] * (x / zm) + K[0, 1] * (y / zm) + K[0, 2]
    v = K[1, 1] * (y / zm) + K[1, 2]
    pixels = np.ma.stack([u, v], axis=-1).filled(np.nan).reshape(-1, 2)
    H, W = depth_metric.shape
    col, row = np.ma.floor(u + 0.5).filled(-1), np.ma.floor(v + 0.5).filled(-1)
    inside = (col > -1) & (col < W) & (row > -1) & (row < H)
    measured = np.full(len(z), np.nan)
    measured[inside] = depth_metric[row[inside].astype(int), col[inside].astype(int)]
    hidden = (measured > 0.01) & (measured < 10) & (z - measured > 0.02)
    return pixels, inside & ~hidden


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
