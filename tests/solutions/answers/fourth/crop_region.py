"""Right answers to crop_region, as strangers wrote them."""
import cv2
import numpy as np


# 1. transpose of the rotation
def f1(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[((p >= low) & (p <= high)).all(axis=1)]


# 2. inverse, homogeneous
def f2(points_world, T_world_robot, low, high):
    T = np.linalg.inv(T_world_robot)
    P = T @ np.vstack([points_world.T, np.ones(len(points_world))])
    P = P[:3].T
    keep = np.all(P >= low, axis=1) & np.all(P <= high, axis=1)
    return P[keep]


# 3. solve
def f3(points_world, T_world_robot, low, high):
    ones = np.ones((points_world.shape[0], 1))
    p = np.linalg.solve(T_world_robot, np.hstack((points_world, ones)).T)[:3].T
    inside = np.logical_and.reduce([p[:, k] >= low[k] for k in range(3)] +
                                   [p[:, k] <= high[k] for k in range(3)])
    return np.compress(inside, p, axis=0)


# 4. loops
def f4(points_world, T_world_robot, low, high):
    R = T_world_robot[:3, :3].tolist()
    t = T_world_robot[:3, 3].tolist()
    kept = []
    for point in points_world.tolist():
        d = [point[i] - t[i] for i in range(3)]
        q = [R[0][j] * d[0] + R[1][j] * d[1] + R[2][j] * d[2] for j in range(3)]
        if all(low[j] <= q[j] <= high[j] for j in range(3)):
            kept.append(q)
    return np.array(kept, dtype=float).reshape(-1, 3)


# 5. einsum, box as center and half size is risky at the limits: clip instead, reversed order
def f5(points_world, T_world_robot, low, high):
    p = np.einsum("ji,nj->ni", T_world_robot[:3, :3], points_world - T_world_robot[:3, 3])
    inside = (np.clip(p, low, high) == p).all(axis=1)
    return p[inside][::-1]


# 6. class
class Frame:
    def __init__(self, T):
        T = np.asarray(T, float)
        if T.shape != (4, 4) or not np.allclose(T[3], [0, 0, 0, 1]):
            raise ValueError("not a pose")
        self.R, self.t = T[:3, :3], T[:3, 3]

    def inverse(self):
        T = np.eye(4)
        T[:3, :3] = self.R.T
        T[:3, 3] = -self.R.T @ self.t
        return Frame(T)

    def map(self, p):
        return p @ self.R.T + self.t


class Box:
    def __init__(self, low, high):
        self.low, self.high = np.asarray(low), np.asarray(high)

    def __contains__(self, p):
        return bool((self.low <= p).all() and (p <= self.high).all())


def f6(points_world, T_world_robot, low, high):
    box = Box(low, high)
    local = Frame(T_world_robot).inverse().map(points_world)
    chosen = [p for p in local if p in box]
    return np.array(chosen) if chosen else np.empty((0, 3))


# 7. filter axis by axis, like a query on a table
def f7(points_world, T_world_robot, low, high):
    p = (points_world - T_world_robot[:3, 3]) @ T_world_robot[:3, :3]
    for axis in range(3):
        p = p[p[:, axis] >= low[axis]]
        p = p[p[:, axis] <= high[axis]]
    return p


ANSWERS = [f1, f2, f3, f4, f5, f6, f7]
