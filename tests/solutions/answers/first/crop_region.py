"""Right answers to crop_region, as strangers wrote them."""
import numpy as np


def rotation_and_mask(points_world, T_world_robot, low, high):
    """R^T (p - t), then one boolean mask; order of the input."""
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[((p >= low) & (p <= high)).all(axis=1)]


def inverse_matrix(points_world, T_world_robot, low, high):
    """np.linalg.inv of the whole pose and homogeneous coordinates."""
    T = np.linalg.inv(T_world_robot)
    h = np.c_[points_world, np.ones(len(points_world))]
    p = (h @ T.T)[:, :3]
    keep = np.ones(len(p), dtype=bool)
    for axis in range(3):
        keep &= (low[axis] <= p[:, axis]) & (p[:, axis] <= high[axis])
    return p[keep].copy()


def plain_loops(points_world, T_world_robot, low, high):
    """Python loops and lists, array only at the end (also for zero points)."""
    kept = []
    for p in points_world:
        d = [p[i] - T_world_robot[i][3] for i in range(3)]
        q = []
        for j in range(3):
            q.append(sum(T_world_robot[i][j] * d[i] for i in range(3)))
        if all(low[j] <= q[j] <= high[j] for j in range(3)):
            kept.append(q)
    return np.array(kept, dtype=np.float64).reshape(len(kept), 3)


def sorted_by_height(points_world, T_world_robot, low, high):
    """Uses the free order: returns the points sorted by z, then y, then x."""
    p = (points_world - T_world_robot[:3, 3]).dot(T_world_robot[:3, :3])
    inside = np.logical_not(np.any((p < low) | (p > high) | np.isnan(p), axis=1))
    p = p[inside]
    return p[np.lexsort((p[:, 0], p[:, 1], p[:, 2]))]


def backwards_with_solve(points_world, T_world_robot, low, high):
    """np.linalg.solve instead of a transpose; last point first."""
    R, t = T_world_robot[0:3, 0:3], T_world_robot[0:3, 3:4]
    p = np.linalg.solve(R, points_world.T - t).T
    rows = np.flatnonzero(np.prod((p >= low) * (p <= high), axis=1))
    return np.take(p, rows[::-1], axis=0)


def divide_and_conquer(points_world, T_world_robot, low, high, leaf=64):
    """Recursion over halves of the cloud; the second half comes first."""
    n = len(points_world)
    if n > leaf:
        a = divide_and_conquer(points_world[:n // 2], T_world_robot, low, high, leaf)
        b = divide_and_conquer(points_world[n // 2:], T_world_robot, low, high, leaf)
        return np.concatenate([b, a])
    p = np.einsum("ij,ni->nj", T_world_robot[:3, :3], points_world - T_world_robot[:3, 3])
    return p[(np.clip(p, low, high) == p).all(axis=1)].reshape(-1, 3)


class _Box:
    def __init__(self, low, high):
        self.center = [(a, b) for a, b in zip(low, high)]

    def __contains__(self, point):
        return not [1 for q, (a, b) in zip(point, self.center) if not a <= q <= b]


def with_a_box_class(points_world, T_world_robot, low, high):
    """A box class with `in`, np.compress; axis by axis products instead of a matrix product."""
    d = np.asarray(points_world, dtype=np.float64) - np.asarray(T_world_robot)[:3, 3]
    robot = np.stack([(d * np.asarray(T_world_robot)[:3, k]).sum(axis=1) for k in range(3)], axis=1)
    box = _Box(low, high)
    return np.compress(np.array([p in box for p in robot], dtype=bool), robot, axis=0).reshape(-1, 3)


def one_axis_at_a_time(points_world, T_world_robot, low, high):
    """Thins the cloud axis by axis, so each test sees fewer points."""
    rest = np.array(points_world, dtype=np.float64).reshape(-1, 3) - T_world_robot[:3, 3]
    for axis in range(3):
        value = rest @ T_world_robot[:3, axis]
        rest = rest[np.where((value >= low[axis]) & (value <= high[axis]))[0]]
    return np.ascontiguousarray(rest @ T_world_robot[:3, :3])


ANSWERS = [rotation_and_mask, inverse_matrix, plain_loops, sorted_by_height,
           backwards_with_solve, divide_and_conquer, with_a_box_class, one_axis_at_a_time]
