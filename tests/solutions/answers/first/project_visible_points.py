"""Right answers to project_visible_points, as strangers wrote them."""
import math

import cv2
import numpy as np


def vectorized(points_world, T_world_cam, K, depth_metric):
    """R^T (p - t), np.rint (halves to even), indices only where the pixel is in the picture."""
    R, t = T_world_cam[:3, :3], T_world_cam[:3, 3]
    p = (points_world - t) @ R
    z = p[:, 2]
    front = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[front, 0] = K[0, 0] * p[front, 0] / z[front] + K[0, 2]
    pixels[front, 1] = K[1, 1] * p[front, 1] / z[front] + K[1, 2]
    visible = np.zeros(len(p), dtype=bool)
    H, W = depth_metric.shape
    i = np.flatnonzero(front)
    uv = np.rint(pixels[i])
    ok = (uv[:, 0] >= 0) & (uv[:, 0] < W) & (uv[:, 1] >= 0) & (uv[:, 1] < H)
    i, uv = i[ok], uv[ok].astype(int)
    d = depth_metric[uv[:, 1], uv[:, 0]].astype(np.float64)
    hides = (d > 0.01) & (d < 10) & (z[i] - d > 0.02)
    visible[i] = ~hides
    return pixels, visible


def plain_loops(points_world, T_world_cam, K, depth_metric):
    """Point by point in Python, round() (halves to even)."""
    H, W = depth_metric.shape
    pixels, visible = [], []
    for p in points_world:
        d = [float(p[k] - T_world_cam[k, 3]) for k in range(3)]
        x, y, z = (sum(float(T_world_cam[k, j]) * d[k] for k in range(3)) for j in range(3))
        if z <= 0.01:
            pixels.append((math.nan, math.nan))
            visible.append(False)
            continue
        u = float(K[0, 0]) * x / z + float(K[0, 2])
        v = float(K[1, 1]) * y / z + float(K[1, 2])
        pixels.append((u, v))
        column, row = round(u), round(v)
        if not (0 <= column < W and 0 <= row < H):
            visible.append(False)
            continue
        seen = float(depth_metric[row, column])
        visible.append(not (0.01 < seen < 10) or z <= seen + 0.02)
    return np.array(pixels, dtype=np.float64).reshape(-1, 2), np.array(visible, dtype=bool)


def halves_up(points_world, T_world_cam, K, depth_metric):
    """Inverse pose, K as a matrix, floor(x + 1/2); the depth picture is cleaned to infinity first."""
    T = np.linalg.inv(T_world_cam)
    p = T[:3, :3] @ points_world.T + T[:3, 3:]
    z = np.where(p[2] > 0.01, p[2], np.nan)
    uvw = K @ (p / z)
    pixels = uvw[:2].T.copy()
    picture = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.inf).astype(np.float64)
    H, W = picture.shape
    column, row = np.floor(pixels + 0.5).T
    inside = (column >= 0) & (column <= W - 1) & (row >= 0) & (row <= H - 1)
    limit = np.full(len(pixels), -np.inf)
    limit[inside] = picture[row[inside].astype(int), column[inside].astype(int)] + 0.02
    return pixels, inside & (np.nan_to_num(z) <= limit)


def halves_down(points_world, T_world_cam, K, depth_metric):
    """ceil(x - 1/2) and a frame of "sees nothing" around the picture instead of a border test."""
    d = points_world - T_world_cam[:3, 3]
    x, y, z = d @ T_world_cam[:3, 0], d @ T_world_cam[:3, 1], d @ T_world_cam[:3, 2]
    with np.errstate(divide="ignore", invalid="ignore"):
        u = np.where(z > 0.01, K[0, 0] * (x / z) + K[0, 2], np.nan)
        v = np.where(z > 0.01, K[1, 1] * (y / z) + K[1, 2], np.nan)
    H, W = depth_metric.shape
    limit = np.full((H + 2, W + 2), -1.0)
    center = depth_metric.astype(np.float64)
    limit[1:-1, 1:-1] = np.where((center > 0.01) & (center < 10), center + 0.02, np.inf)
    column = np.clip(np.nan_to_num(np.ceil(u - 0.5), nan=-1.0), -1, W).astype(int) + 1
    row = np.clip(np.nan_to_num(np.ceil(v - 0.5), nan=-1.0), -1, H).astype(int) + 1
    visible = (z > 0.01) & (z <= limit[row, column])
    return np.column_stack([u, v]), visible


def with_opencv(points_world, T_world_cam, K, depth_metric):
    """cv2.projectPoints for the points in front, halves away from zero."""
    cam = (points_world - T_world_cam[:3, 3]).dot(T_world_cam[:3, :3])
    N = len(cam)
    pixels, visible = np.full((N, 2), np.nan, dtype=np.float64), np.zeros(N, dtype=bool)
    front = np.nonzero(cam[:, 2] > 0.01)[0]
    if len(front) == 0:
        return pixels, visible
    projected, _ = cv2.projectPoints(np.ascontiguousarray(cam[front]), np.zeros(3), np.zeros(3),
                                     np.asarray(K, dtype=np.float64), None)
    pixels[front] = projected.reshape(-1, 2)
    rounded = np.trunc(pixels[front] + np.copysign(0.5, pixels[front]))
    for k, (u, v) in zip(front, rounded):
        if 0 <= u <= depth_metric.shape[1] - 1 and 0 <= v <= depth_metric.shape[0] - 1:
            there = np.float64(depth_metric[int(v), int(u)])
            visible[k] = not (0.01 < there < 10) or cam[k, 2] - there <= 0.02
    return pixels, visible


class _View:
    def __init__(self, pose, K, depth):
        self.world_to_cam = np.eye(4)
        self.world_to_cam[:3, :3] = pose[:3, :3].T
        self.world_to_cam[:3, 3] = -pose[:3, :3].T @ pose[:3, 3]
        self.P = K @ self.world_to_cam[:3]
        self.depth = depth

    def project(self, point):
        a, b, w = self.P @ np.append(point, 1.0)
        return (a / w, b / w, w) if w > 0.01 else (np.nan, np.nan, w)

    def blocks(self, u, v, z, slack):
        d = float(self.depth[v, u])
        return 0.01 < d < 10 and z > d + slack

    def sees(self, u, v, z, slack):
        if math.isnan(u):
            return False
        H, W = self.depth.shape
        u, v = math.floor(u + 0.5), math.floor(v + 0.5)
        return u in range(W) and v in range(H) and not self.blocks(u, v, z, slack)


def with_a_class(points_world, T_world_cam, K, depth_metric, slack=0.02):
    """A class with one 3x4 projection matrix, homogeneous points, slack as optional argument."""
    view = _View(T_world_cam, K, depth_metric)
    uvz = [view.project(p) for p in points_world]
    visible = [view.sees(u, v, z, slack) for u, v, z in uvz]
    return np.array([q[:2] for q in uvz], dtype=np.float64).reshape(-1, 2), np.array(visible, dtype=bool)


def column_by_column(points_world, T_world_cam, K, depth_metric):
    """np.linalg.solve for the pose, masks combined step by step, np.around."""
    h = np.hstack([points_world, np.ones((len(points_world), 1))])
    x, y, z, _ = np.linalg.solve(T_world_cam, h.T) if len(h) else np.zeros((4, 0))
    behind = ~(z > 0.01)
    safe = np.where(behind, 1.0, z)
    pixels = np.stack([x / safe * K[0, 0] + K[0, 2], y / safe * K[1, 1] + K[1, 2]], axis=1)
    place = np.around(pixels)
    H, W = depth_metric.shape
    outside = behind | np.any((place < 0) | (place > [W - 1, H - 1]), axis=1)
    place[outside] = 0
    seen = depth_metric[place[:, 1].astype(int), place[:, 0].astype(int)].astype(np.float64)
    hidden = (seen > 0.01) & (seen < 10) & (seen + 0.02 < z)
    pixels[behind] = np.nan
    return pixels, ~outside & ~hidden


ANSWERS = [vectorized, plain_loops, halves_up, halves_down, with_opencv, with_a_class, column_by_column]
