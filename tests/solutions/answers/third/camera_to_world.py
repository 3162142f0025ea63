"""Right answers to camera_to_world, as strangers wrote them."""
import cv2
import mujoco
import numpy as np


# 1. in one line
def world_oneliner(points, cam_xpos, cam_xmat):
    return points @ (cam_xmat.reshape(3, 3) @ np.diag([1, -1, -1])).T + cam_xpos


# 2. flip the coordinates, not the matrix
def world_flip_points(points, cam_xpos, cam_xmat):
    flipped = np.array(points, dtype=np.float64)      # a copy: points stay
    flipped[:, 1:] *= -1
    return np.einsum("ij,nj->ni", np.reshape(cam_xmat, (3, 3)), flipped) + cam_xpos


# 3. beginner
def world_beginner(points, cam_xpos, cam_xmat):
    m = np.array(cam_xmat).flatten()
    result = np.zeros((len(points), 3))
    for i in range(len(points)):
        x = float(points[i][0])
        y = -float(points[i][1])
        z = -float(points[i][2])
        result[i][0] = m[0] * x + m[1] * y + m[2] * z + cam_xpos[0]
        result[i][1] = m[3] * x + m[4] * y + m[5] * z + cam_xpos[1]
        result[i][2] = m[6] * x + m[7] * y + m[8] * z + cam_xpos[2]
    return result


# 4. mathematician: homogeneous 4x4
def world_homogeneous(points, cam_xpos, cam_xmat):
    T_world_mj = np.eye(4)
    T_world_mj[:3, :3] = np.asarray(cam_xmat).reshape(3, 3)
    T_world_mj[:3, 3] = cam_xpos
    T_mj_cv = np.diag([1.0, -1.0, -1.0, 1.0])
    P = np.hstack([points, np.ones((len(points), 1))])
    return (T_world_mj @ T_mj_cv @ P.T)[:3].T


# 5. OpenCV
def world_opencv(points, cam_xpos, cam_xmat):
    if len(points) == 0:
        return np.zeros((0, 3))
    half_turn, _ = cv2.Rodrigues(np.array([np.pi, 0.0, 0.0]))
    M = np.column_stack([np.reshape(cam_xmat, (3, 3)) @ half_turn, cam_xpos])
    return cv2.transform(np.asarray(points, np.float64).reshape(-1, 1, 3), M).reshape(-1, 3)


# 6. MuJoCo's own functions, one point after the other
def world_mujoco(points, cam_xpos, cam_xmat):
    out = np.zeros((len(points), 3))
    mat = np.array(cam_xmat, np.float64).reshape(3, 3)
    for point, result in zip(points, out):
        local = np.array([point[0], -point[1], -point[2]], dtype=np.float64)
        mujoco.mju_mulMatVec(result, mat, local)
        result += cam_xpos
    return out


# 7. float32
def world_float32(points, cam_xpos, cam_xmat):
    p = points.astype(np.float32)
    R = np.asarray(cam_xmat).reshape(3, 3).astype(np.float32) * np.float32([1, -1, -1])
    return np.dot(p, R.T) + np.float32(cam_xpos)


# 8. the camera's axes as vectors: right, down, forward
def world_axes(points, cam_xpos, cam_xmat):
    right, up, back = np.asarray(cam_xmat, float).reshape(3, 3).T
    down, forward = -up, -back
    x, y, z = points[:, :1], points[:, 1:2], points[:, 2:]
    return cam_xpos + x * right + y * down + z * forward


# 9. Java
class RigidTransform:
    def __init__(self, rotation, translation):
        if rotation.shape != (3, 3) or translation.shape != (3,):
            raise ValueError("bad shapes")
        if not np.allclose(rotation @ rotation.T, np.eye(3), atol=1e-4):
            raise ValueError("not a rotation")
        self.rotation = rotation.copy()
        self.translation = translation.copy()

    def __call__(self, point):
        return [sum(r * c for r, c in zip(row, point)) + t
                for row, t in zip(self.rotation.tolist(), self.translation.tolist())]


def world_java(points, cam_xpos, cam_xmat):
    R = np.array(cam_xmat, dtype=float).reshape(3, 3)
    R[:, 1], R[:, 2] = -R[:, 1], -R[:, 2]
    transform = RigidTransform(R, np.asarray(cam_xpos, float))
    return np.array([transform(p) for p in points.tolist()], dtype=float).reshape(-1, 3)


ANSWERS = [world_oneliner, world_flip_points, world_beginner, world_homogeneous, world_opencv,
           world_mujoco, world_float32, world_axes, world_java]
