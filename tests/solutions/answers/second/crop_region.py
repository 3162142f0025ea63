"""Right answers to crop_region, as strangers wrote them."""
from dataclasses import dataclass

import cv2
import numpy as np


# 1. rotation transposed
def f1(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[np.all((p >= low) & (p <= high), axis=1)]


# 2. inverse, homogeneous
def f2(points_world, T_world_robot, low, high):
    h = np.hstack([points_world, np.ones((len(points_world), 1))])
    p = (np.linalg.inv(T_world_robot) @ h.T).T[:, :3]
    inside = (p >= low).all(1) & (p <= high).all(1)
    return p[inside]


# 3. C programmer, from the last to the first
def f3(points_world, T_world_robot, low, high):
    out = []
    for i in range(len(points_world) - 1, -1, -1):
        d = [points_world[i][k] - T_world_robot[k][3] for k in range(3)]
        q = [0.0, 0.0, 0.0]
        keep = True
        for r in range(3):
            for k in range(3):
                q[r] += T_world_robot[k][r] * d[k]
            if q[r] < low[r] or q[r] > high[r]:
                keep = False
        if keep:
            out.append(q)
    return np.array(out, dtype=float).reshape(-1, 3)


# 4. solve, sorted by height
def f4(points_world, T_world_robot, low, high):
    p = np.linalg.solve(T_world_robot[:3, :3], (points_world - T_world_robot[:3, 3]).T).T
    p = p[~np.any((p < low) | (p > high), axis=1)]
    return p[np.argsort(p[:, 2])]


# 5. einsum; float32 leaves the function, the decision is made in float64
def f5(points_world, T_world_robot, low, high):
    p = np.einsum("kr,nk->nr", T_world_robot[:3, :3], points_world - T_world_robot[:3, 3])
    clipped = np.clip(p, low, high)
    return p[np.equal(p, clipped).all(axis=1)].astype(np.float32)


# 6. over-engineered
@dataclass(frozen=True)
class _Box:
    low: np.ndarray
    high: np.ndarray

    def __post_init__(self):
        if np.any(np.asarray(self.low) > np.asarray(self.high)):
            raise ValueError("low must not exceed high")

    def contains(self, p):
        return np.logical_and.reduce([(lo <= c) & (c <= hi)
                                      for c, lo, hi in zip(p.T, self.low, self.high)])


class _Frame:
    def __init__(self, T):
        self.T = np.array(T, dtype=float)

    def to_local(self, points):
        R = self.T[:3, :3].T
        return points @ R.T - (R @ self.T[:3, 3])


def f6(points_world: np.ndarray, T_world_robot: np.ndarray, low, high) -> np.ndarray:
    local = _Frame(T_world_robot).to_local(points_world)
    return local[_Box(low, high).contains(local)].copy()


# 7. short, with a hair of tolerance for the rounding of the motion
def f7(points_world, T_world_robot, low, high, eps=1e-9):
    p = np.c_[points_world, np.ones(len(points_world))] @ np.linalg.inv(T_world_robot)[:3].T
    return p[(np.abs(p - (low + high) / 2) <= (high - low) / 2 + eps).all(1)]


# 8. perspectiveTransform, list comprehension
def f8(points_world, T_world_robot, low, high):
    if not len(points_world):
        return np.empty((0, 3))
    T = np.eye(4)
    T[:3, :3] = T_world_robot[:3, :3].T
    T[:3, 3] = -T[:3, :3] @ T_world_robot[:3, 3]
    moved = cv2.perspectiveTransform(np.asarray(points_world, float).reshape(1, -1, 3), T)[0]
    kept = [p for p in moved if all(a <= b <= c for a, b, c in zip(low, p, high))]
    return np.vstack(kept) if kept else np.empty((0, 3))


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
