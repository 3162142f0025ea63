"""Right answers to project_visible_points, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1
def f1(points_world, T_world_cam, K, depth_metric):
    H, W = depth_metric.shape
    R, t = T_world_cam[:3, :3], T_world_cam[:3, 3]
    p = (points_world - t) @ R
    z = p[:, 2]
    front = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[front, 0] = K[0, 0] * p[front, 0] / z[front] + K[0, 2]
    pixels[front, 1] = K[1, 1] * p[front, 1] / z[front] + K[1, 2]
    visible = np.zeros(len(p), dtype=bool)
    for i in np.flatnonzero(front):
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < W and 0 <= v < H:
            d = depth_metric[v, u]
            valid = d > 0.01 and d < 10
            visible[i] = not valid or z[i] <= d + 0.02
    return pixels, visible


# 2. homogeneous, vectorized, floor(x + 0.5)
def f2(points_world, T_world_cam, K, depth_metric):
    T = np.linalg.inv(T_world_cam)
    P = (T @ np.hstack([points_world, np.ones((len(points_world), 1))]).T)[:3]
    z = P[2]
    with np.errstate(divide="ignore", invalid="ignore"):
        uvw = K @ P
        uv = (uvw[:2] / uvw[2]).T
    uv = np.where(z[:, None] > 0.01, uv, np.nan)
    ij = np.floor(np.nan_to_num(uv, nan=-9.0) + 0.5)
    h, w = depth_metric.shape
    inside = (ij[:, 0] >= 0) & (ij[:, 0] <= w - 1) & (ij[:, 1] >= 0) & (ij[:, 1] <= h - 1)
    ij = np.where(inside[:, None], ij, 0).astype(int)
    surface = depth_metric[ij[:, 1], ij[:, 0]].astype(float)
    known = (surface > 0.01) & (surface < 10)
    hidden = known & (z - surface > 0.02)
    return uv, inside & ~hidden & (z > 0.01)


# 3. pure Python
def f3(points_world, T_world_cam, K, depth_metric):
    height, width = depth_metric.shape
    pixels, visible = [], []
    for p in points_world:
        d = [p[i] - T_world_cam[i, 3] for i in range(3)]
        x, y, z = [sum(T_world_cam[i, j] * d[i] for i in range(3)) for j in range(3)]
        if z <= 0.01:
            pixels.append((math.nan, math.nan))
            visible.append(False)
            continue
        u = K[0, 0] * x / z + K[0, 2]
        v = K[1, 1] * y / z + K[1, 2]
        pixels.append((u, v))
        col, row = round(u), round(v)
        if col < 0 or row < 0 or col >= width or row >= height:
            visible.append(False)
            continue
        measured = float(depth_metric[row, col])
        if 0.01 < measured < 10:
            visible.append(bool(z <= measured + 0.02))
        else:
            visible.append(True)
    return np.array(pixels, float).reshape(-1, 2), np.array(visible, bool)


# 4. cv2.projectPoints with rvec and tvec
def f4(points_world, T_world_cam, K, depth_metric):
    n = len(points_world)
    uv, visible = np.full((n, 2), np.nan), np.zeros(n, np.bool_)
    R = T_world_cam[:3, :3].T.copy()
    t = -R @ T_world_cam[:3, 3]
    depth = points_world @ R[2] + t[2]
    idx = np.flatnonzero(depth > 0.01)
    if idx.size == 0:
        return uv, visible
    rvec, _ = cv2.Rodrigues(R)
    found, _ = cv2.projectPoints(np.ascontiguousarray(points_world[idx])[:, None], rvec, t, K.copy(), None)
    uv[idx] = found.reshape(-1, 2)
    rc = np.round(uv[idx])[:, ::-1]
    ok = ((rc >= 0) & (rc < depth_metric.shape)).all(axis=1)
    idx, rc = idx[ok], rc[ok].astype(int)
    d = depth_metric[tuple(rc.T)]
    free = ~((d > 0.01) & (d < 10))
    visible[idx] = free | (depth[idx] <= d + 0.02)
    return uv, visible


# 5. a depth buffer with a frame around it (game developer); invalid means infinitely far
def f5(points_world, T_world_cam, K, depth_metric):
    zbuf = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.inf).astype(float)
    zbuf = np.pad(zbuf, 1, constant_values=-np.inf)
    view = np.linalg.inv(T_world_cam)
    xyz = np.einsum("ij,nj->ni", view[:3, :3], points_world) + view[:3, 3]
    z = np.where(xyz[:, 2] > 0.01, xyz[:, 2], np.nan)
    u = K[0, 0] * (xyz[:, 0] / z) + K[0, 2]
    v = K[1, 1] * (xyz[:, 1] / z) + K[1, 2]
    H, W = depth_metric.shape
    col = np.clip(np.rint(np.where(np.isnan(u), -1, u)), -1, W).astype(int) + 1
    row = np.clip(np.rint(np.where(np.isnan(v), -1, v)), -1, H).astype(int) + 1
    with np.errstate(invalid="ignore"):
        seen = z <= zbuf[row, col] + 0.02
    return np.stack([u, v], axis=1), seen


# 6. class, solve
@dataclass
class DepthCamera:
    T_world_cam: np.ndarray
    K: np.ndarray
    depth: np.ndarray
    tolerance: float = 0.02
    near: float = 0.01
    far: float = 10.0

    def to_camera(self, points):
        P = np.c_[points, np.ones(len(points))]
        return np.linalg.solve(self.T_world_cam, P.T).T[:, :3]

    def project(self, p):
        out = np.full((len(p), 2), np.nan)
        front = p[:, 2] > self.near
        out[front] = (p[front] / p[front, 2:]) @ self.K[:2].T
        return out

    def sees(self, pixel, z):
        if not z > self.near:
            return False
        u, v = (int(math.floor(c + 0.5)) for c in pixel)
        h, w = self.depth.shape
        if not (u in range(w) and v in range(h)):
            return False
        d = float(self.depth[v, u])
        return not (self.near < d < self.far) or z - d <= self.tolerance


def f6(points_world, T_world_cam, K, depth_metric):
    camera = DepthCamera(T_world_cam, K, depth_metric)
    p = camera.to_camera(points_world)
    pixels = camera.project(p)
    return pixels, np.array([camera.sees(q, z) for q, z in zip(pixels, p[:, 2])], dtype=bool)


# 7. cv2.remap with nearest is not exact about ties; masked arrays instead
def f7(points_world, T_world_cam, K, depth_metric):
    M = K @ np.linalg.inv(T_world_cam)[:3]
    h = points_world @ M[:, :3].T + M[:, 3]
    z = h[:, 2]
    uv = np.ma.array(h[:, :2], mask=np.repeat(~(z > 0.01)[:, None], 2, axis=1))
    uv = uv / np.where(z > 0.01, z, 1)[:, None]
    c = np.ma.filled(np.ma.around(uv), -1.0)
    size = np.array(depth_metric.shape)[::-1]
    inside = ((c >= 0) & (c < size)).all(1)
    vis = inside.copy()
    col, row = c[inside].astype(np.intp).T if inside.any() else (np.zeros(0, int),) * 2
    d = depth_metric[row, col].astype(np.float64)
    vis[inside] = ~((d > 0.01) & (d < 10) & (z[inside] > d + 0.02))
    return uv.filled(np.nan), vis


ANSWERS = [f1, f2, f3, f4, f5, f6, f7]
