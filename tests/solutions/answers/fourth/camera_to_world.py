"""Right answers to camera_to_world, as strangers wrote them."""
import cv2
import numpy as np


# 1. book
def f1(points, cam_xpos, cam_xmat):
    R = cam_xmat.reshape(3, 3) @ np.diag([1, -1, -1])
    return points @ R.T + cam_xpos


# 2. flip the points first
def f2(points, cam_xpos, cam_xmat):
    flipped = np.array(points, dtype=float)
    flipped[:, 1:] *= -1
    return np.dot(flipped, np.asarray(cam_xmat).reshape(3, 3).T) + np.asarray(cam_xpos)


# 3. homogeneous
def f3(points, cam_xpos, cam_xmat):
    T = np.eye(4)
    T[:3, :3] = np.reshape(cam_xmat, (3, 3))
    T[:3, 3] = cam_xpos
    T = T @ np.diag([1.0, -1.0, -1.0, 1.0])
    P = np.hstack([points, np.ones((len(points), 1))])
    return (T @ P.T).T[:, :3]


# 4. einsum
def f4(points, cam_xpos, cam_xmat):
    return np.einsum("ij,j,nj->ni", cam_xmat.reshape(3, 3), np.array([1, -1, -1]), points) + cam_xpos[None]


# 5. loops
def f5(points, cam_xpos, cam_xmat):
    m = np.asarray(cam_xmat).ravel()
    result = []
    for x, y, z in points:
        x, y, z = float(x), float(y), float(z)
        y, z = -y, -z
        result.append([m[0] * x + m[1] * y + m[2] * z + cam_xpos[0],
                       m[3] * x + m[4] * y + m[5] * z + cam_xpos[1],
                       m[6] * x + m[7] * y + m[8] * z + cam_xpos[2]])
    return np.array(result, dtype=float).reshape(-1, 3)


# 6. cv2.transform
def f6(points, cam_xpos, cam_xmat):
    if len(points) == 0:
        return np.zeros((0, 3))
    M = np.column_stack([cam_xmat.reshape(3, 3) * [1, -1, -1], cam_xpos])
    return cv2.transform(np.asarray(points, np.float64)[:, None, :], M)[:, 0]


# 7. columns as axes of the camera (game developer: right, up, back)
def f7(points, cam_xpos, cam_xmat):
    right, up, back = cam_xmat.reshape(3, 3).T
    x, y, z = points[:, 0:1], points[:, 1:2], points[:, 2:3]
    return cam_xpos + x * right - y * up - z * back


# 8. class
class Pose:
    def __init__(self, R, t):
        self.R = np.asarray(R, dtype=np.float64).reshape(3, 3)
        self.t = np.asarray(t, dtype=np.float64).reshape(3)
        if not np.allclose(self.R @ self.R.T, np.eye(3), atol=1e-4):
            raise ValueError("not a rotation")

    def __matmul__(self, other):
        return Pose(self.R @ other.R, self.R @ other.t + self.t)

    def apply(self, p):
        return (self.R @ np.asarray(p, dtype=np.float64).T).T + self.t


CV_TO_MUJOCO = Pose(cv2.Rodrigues(np.array([np.pi, 0, 0]))[0], np.zeros(3))


def f8(points, cam_xpos, cam_xmat):
    return (Pose(cam_xmat, cam_xpos) @ CV_TO_MUJOCO).apply(points)


# 9. float32
def f9(points, cam_xpos, cam_xmat):
    R = cam_xmat.reshape(3, 3).astype(np.float32) * np.float32([[1, -1, -1]])
    return points.astype(np.float32) @ R.T + cam_xpos.astype(np.float32)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8, f9]
