"""Right answers to camera_to_world, as strangers wrote them."""
from dataclasses import dataclass

import cv2
import numpy as np


# 1. the text's formula
def f1(points, cam_xpos, cam_xmat):
    R = np.reshape(cam_xmat, (3, 3)) @ np.diag([1, -1, -1])
    return points @ R.T + cam_xpos


# 2. flip the points first
def f2(points, cam_xpos, cam_xmat):
    flipped = points * np.array([1.0, -1.0, -1.0])
    return flipped.dot(np.asarray(cam_xmat).reshape(3, 3).T) + np.asarray(cam_xpos)


# 3. C programmer
def f3(points, cam_xpos, cam_xmat):
    m = np.ravel(cam_xmat)
    out = np.zeros((len(points), 3))
    for i in range(len(points)):
        x, y, z = float(points[i][0]), -float(points[i][1]), -float(points[i][2])
        for r in range(3):
            out[i, r] = m[3 * r] * x + m[3 * r + 1] * y + m[3 * r + 2] * z + cam_xpos[r]
    return out


# 4. homogeneous einsum
def f4(points, cam_xpos, cam_xmat):
    T = np.eye(4)
    T[:3, :3] = np.array(cam_xmat, float).reshape(3, 3)
    T[:3, 3] = cam_xpos
    T = T @ np.diag([1.0, -1.0, -1.0, 1.0])
    h = np.concatenate([points, np.ones((len(points), 1))], axis=1)
    return np.einsum("ij,nj->ni", T, h)[:, :3]


# 5. float32
def f5(points, cam_xpos, cam_xmat):
    P = np.array(points, dtype=np.float32)
    R = np.array(cam_xmat, dtype=np.float32).reshape(3, 3) * np.array([1, -1, -1], np.float32)
    return np.matmul(P, R.T) + np.array(cam_xpos, dtype=np.float32)


# 6. cv2.transform
def f6(points, cam_xpos, cam_xmat):
    if len(points) == 0:
        return np.zeros((0, 3))
    M = np.zeros((3, 4))
    M[:, :3] = np.asarray(cam_xmat, np.float64).reshape(3, 3)
    M[:, 1:3] *= -1
    M[:, 3] = cam_xpos
    return cv2.transform(np.asarray(points, np.float64).reshape(-1, 1, 3), M).reshape(-1, 3)


# 7. over-engineered
@dataclass(frozen=True)
class _Pose:
    R: np.ndarray
    t: np.ndarray

    @classmethod
    def from_mujoco(cls, xpos, xmat):
        xmat = np.asarray(xmat, dtype=float)
        if xmat.size != 9:
            raise ValueError("a rotation has nine numbers")
        x, y, z = xmat.reshape(3, 3).T      # axes of MuJoCo's camera in the world
        return cls(np.column_stack([x, -y, -z]), np.array(xpos, dtype=float))

    def __matmul__(self, points):
        return (self.R @ np.asarray(points, dtype=float).T).T + self.t


def f7(points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray) -> np.ndarray:
    return _Pose.from_mujoco(cam_xpos, cam_xmat) @ points


# 8. sum of the axes, half a turn about x by Rodrigues
def f8(points, cam_xpos, cam_xmat):
    half_turn = np.rint(cv2.Rodrigues(np.array([np.pi, 0.0, 0.0]))[0])
    X, Y, Z = (np.reshape(cam_xmat, (3, 3)) @ half_turn).T
    return cam_xpos + np.outer(points[:, 0], X) + np.outer(points[:, 1], Y) + np.outer(points[:, 2], Z)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
