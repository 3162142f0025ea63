"""Right answers to crop_region, as strangers wrote them."""
import cv2
import numpy as np


# 1. inverse, then a mask
def crop_inv(points_world, T_world_robot, low, high):
    T = np.linalg.inv(T_world_robot)
    p = points_world @ T[:3, :3].T + T[:3, 3]
    return p[((p >= low) & (p <= high)).all(axis=1)]


# 2. transpose of the rotation
def crop_transpose(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return np.compress(np.all((low <= p) & (p <= high), axis=1), p, axis=0)


# 3. beginner
def crop_beginner(points_world, T_world_robot, low, high):
    inside = []
    for point in points_world:
        difference = [point[0] - T_world_robot[0][3],
                      point[1] - T_world_robot[1][3],
                      point[2] - T_world_robot[2][3]]
        p = [0, 0, 0]
        for axis in range(3):
            # the columns of the rotation are the axes of the robot
            p[axis] = (T_world_robot[0][axis] * difference[0]
                       + T_world_robot[1][axis] * difference[1]
                       + T_world_robot[2][axis] * difference[2])
        is_inside = True
        for axis in range(3):
            if p[axis] < low[axis] or p[axis] > high[axis]:
                is_inside = False
        if is_inside:
            inside.append(p)
    if len(inside) == 0:
        return np.zeros((0, 3))
    return np.array(inside)


# 4. mathematician: solve T X = P, do not invert
def crop_solve(points_world, T_world_robot, low, high):
    P = np.c_[points_world, np.ones(len(points_world))].T
    X = np.linalg.solve(T_world_robot, P)[:3]
    with np.errstate(invalid="ignore"):
        box = np.prod((X.T >= low) * (X.T <= high), axis=1) == 1
    return X[:, box].T


# 5. sorting and searchsorted along x first, then y, then z; other order of the points
def crop_sorted(points_world, T_world_robot, low, high):
    p = np.einsum("ji,nj->ni", T_world_robot[:3, :3], points_world - T_world_robot[:3, 3])
    for axis in range(3):
        p = p[np.argsort(p[:, axis])]
        first = np.searchsorted(p[:, axis], low[axis], side="left")
        last = np.searchsorted(p[:, axis], high[axis], side="right")
        p = p[first:last]
    return p


# 6. Java
class Box:
    def __init__(self, low, high):
        if any(a > b for a, b in zip(low, high)):
            raise ValueError("low above high")
        self.low, self.high = tuple(low), tuple(high)

    def __contains__(self, p):
        return all(a <= c <= b for a, c, b in zip(self.low, p, self.high))


class Pose:
    def __init__(self, T):
        assert T.shape == (4, 4)
        self._inverse = np.linalg.inv(T)

    def to_local(self, p):
        return (self._inverse @ np.append(p, 1.0))[:3]


def crop_java(points_world, T_world_robot, low, high):
    pose, box = Pose(T_world_robot), Box(low, high)
    kept = [q for q in map(pose.to_local, points_world) if q in box]
    return np.array(kept, dtype=float).reshape(len(kept), 3)


# 7. OpenCV transform, clip: a point in the box is not changed by clipping
def crop_clip(points_world, T_world_robot, low, high):
    if points_world.shape[0] < 1:
        return np.empty((0, 3))
    M = np.linalg.inv(T_world_robot)[:3]
    p = cv2.transform(np.ascontiguousarray(points_world)[:, None], M)[:, 0]
    keep = (np.clip(p, low, high) == p).sum(axis=1) == 3
    return np.delete(p, np.flatnonzero(~keep), axis=0)[::-1]


ANSWERS = [crop_inv, crop_transpose, crop_beginner, crop_solve, crop_sorted, crop_java,
           crop_clip]
