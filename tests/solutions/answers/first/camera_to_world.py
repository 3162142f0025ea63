"""Right answers to camera_to_world, as strangers wrote them."""
import math

import cv2
import mujoco
import numpy as np


def matrix_product(points, cam_xpos, cam_xmat):
    """NumPy one-liner after the checks: points @ (R diag(1,-1,-1)).T + t."""
    p = np.asarray(points)
    t = np.asarray(cam_xpos, dtype=np.float64)
    R = np.asarray(cam_xmat, dtype=np.float64)
    if p.dtype.kind not in "iuf":
        raise TypeError("points must be real numbers")
    if p.ndim != 2 or p.shape[1] != 3:
        raise ValueError("points must have shape (N, 3)")
    if t.shape != (3,):
        raise ValueError("cam_xpos must be 3 numbers")
    if R.shape not in ((9,), (3, 3)):
        raise ValueError("cam_xmat must be 9 numbers or 3x3")
    R = R.reshape(3, 3)
    if not np.allclose(R @ R.T, np.eye(3), atol=1e-6) or np.linalg.det(R) < 0:
        raise ValueError("cam_xmat is no rotation")
    return p.astype(np.float64) @ (R @ np.diag([1.0, -1.0, -1.0])).T + t


def plain_loops(points, cam_xpos, cam_xmat):
    """Nested Python lists and loops; rotation test with dot and cross products."""
    t = [float(a) for a in np.array(cam_xpos, dtype=float).ravel()]
    r = [float(a) for a in np.array(cam_xmat, dtype=float).ravel()]
    if len(t) != 3:
        raise ValueError("three numbers please")
    if len(r) != 9:
        raise ValueError("nine numbers please")
    if np.shape(points)[1:] != (3,) or np.ndim(points) != 2:
        raise ValueError("N rows of three numbers please")
    rows = [r[0:3], r[3:6], r[6:9]]
    for i in range(3):
        for j in range(3):
            dot = sum(rows[i][k] * rows[j][k] for k in range(3))
            if not abs(dot - (1.0 if i == j else 0.0)) < 1e-5:
                raise ValueError("not a rotation")
    a, b, c = rows
    cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    if sum(cross[k] * c[k] for k in range(3)) < 0:
        raise ValueError("a reflection is not a rotation")
    out = []
    for point in points:
        x, y, z = (float(q) for q in point)
        mj = (x, -y, -z)
        out.append([sum(rows[i][k] * mj[k] for k in range(3)) + t[i] for i in range(3)])
    return np.array(out, dtype=np.float64).reshape(-1, 3)


def homogeneous(points, cam_xpos, cam_xmat):
    """Builds the 4x4 pose T_world_cam and multiplies homogeneous points."""
    pts = np.array(points, dtype=np.float64)
    if pts.ndim != 2 or pts.shape[-1] != 3:
        raise ValueError(f"points have shape {pts.shape}")
    xmat = np.array(cam_xmat, dtype=np.float64)
    if xmat.size != 9 or xmat.shape not in [(9,), (3, 3)]:
        raise ValueError(f"cam_xmat has shape {xmat.shape}")
    xmat = xmat.reshape(3, 3)
    singular = np.linalg.svd(xmat, compute_uv=False) if np.isfinite(xmat).all() else np.zeros(3)
    if np.abs(singular - 1).max() > 1e-6 or np.linalg.det(xmat) <= 0:
        raise ValueError("cam_xmat is no rotation")
    xpos = np.array(cam_xpos, dtype=np.float64)
    if xpos.shape != (3,):
        raise ValueError(f"cam_xpos has shape {xpos.shape}")
    T = np.eye(4)
    T[:3, :3] = xmat * [1.0, -1.0, -1.0]
    T[:3, 3] = xpos
    h = np.hstack([pts, np.ones((len(pts), 1))])
    return (T @ h.T)[:3].T.copy()


def by_axes(points, cam_xpos, cam_xmat):
    """Adds up the camera's axes in the world: x * right - y * up - z * back."""
    R = np.asarray(cam_xmat, dtype=float)
    if R.shape == (9,):
        R = R.reshape(3, 3)
    if R.shape != (3, 3):
        raise ValueError("cam_xmat: bad shape")
    right, up, back = R.T
    ok = all(abs(float(np.dot(v, v)) - 1) < 1e-5 for v in (right, up, back))
    if not ok or not np.allclose(np.cross(right, up), back, rtol=0, atol=1e-5):
        raise ValueError("cam_xmat is no rotation")
    origin = np.asarray(cam_xpos, dtype=float)
    if origin.size != 3:
        raise ValueError("cam_xpos: bad shape")
    p = np.asarray(points, dtype=float)
    if p.ndim != 2 or p.shape[1] != 3:
        raise ValueError("points: bad shape")
    x, y, z = p[:, 0:1], p[:, 1:2], p[:, 2:3]
    return origin.reshape(1, 3) + x * right - y * up - z * back


def in_place_on_a_copy(points, cam_xpos, cam_xmat):
    """Flips two columns of a copy in place, then einsum; the input stays as it was."""
    p = np.array(points, dtype=np.float64, copy=True)
    if p.ndim != 2 or p.shape[1] != 3:
        raise ValueError("points must be (N, 3)")
    R = np.array(cam_xmat, dtype=np.float64)
    if R.shape != (9,) and R.shape != (3, 3):
        raise ValueError("cam_xmat must hold 9 numbers")
    R = R.reshape(3, 3)
    if not np.isfinite(R).all() or not np.linalg.det(R) > 0.5:
        raise ValueError("cam_xmat must be a rotation")
    if not np.allclose(np.linalg.inv(R), R.T, rtol=0, atol=1e-6):
        raise ValueError("cam_xmat must be a rotation")
    t = np.array(cam_xpos, dtype=np.float64)
    if t.shape != (3,):
        raise ValueError("cam_xpos must hold 3 numbers")
    p[:, 1:] *= -1
    q = np.einsum("ij,nj->ni", R, p)
    q += t
    return q


class _Camera:
    def __init__(self, xpos, xmat, tolerance):
        self.t = np.asarray(xpos, dtype=np.float64)
        self.R = np.asarray(xmat, dtype=np.float64)
        if self.t.shape != (3,):
            raise ValueError("cam_xpos: 3 numbers expected")
        if self.R.shape not in {(9,), (3, 3)}:
            raise ValueError("cam_xmat: 9 numbers expected")
        self.R = self.R.reshape(3, 3)
        gram = self.R.T.dot(self.R) - np.identity(3)
        if not np.max(np.abs(gram)) <= tolerance or not np.linalg.det(self.R) > 0:
            raise ValueError("cam_xmat: no rotation")

    def to_world(self, block):
        flipped = np.stack([block[:, 0], -block[:, 1].astype(np.float64), -block[:, 2].astype(np.float64)])
        return (self.R @ flipped).T + self.t


def with_a_class_and_chunks(points, cam_xpos, cam_xmat, chunk=1000, tolerance=1e-6):
    """Over-engineered: a camera class, work in chunks, extra options with defaults."""
    camera = _Camera(cam_xpos, cam_xmat, tolerance)
    p = np.asarray(points)
    if p.dtype.kind not in "biuf":
        raise TypeError("points must be real")
    if p.ndim != 2 or p.shape[1] != 3:
        raise ValueError("points must be (N, 3)")
    out = np.empty(p.shape, dtype=np.float64)
    for start in range(0, len(p), chunk):
        out[start:start + chunk] = camera.to_world(p[start:start + chunk])
    return out


def with_opencv(points, cam_xpos, cam_xmat):
    """cv2.transform with a 3x4 matrix; the empty cloud is handled apart."""
    p = np.ascontiguousarray(points, dtype=np.float64)
    t = np.asarray(cam_xpos, dtype=np.float64)
    R = np.asarray(cam_xmat, dtype=np.float64)
    if p.ndim != 2 or p.shape[1] != 3 or t.shape != (3,) or R.shape not in ((9,), (3, 3)):
        raise ValueError("a shape does not fit")
    R = R.reshape(3, 3)
    if not np.linalg.norm(R @ R.T - np.eye(3)) < 1e-5 or cv2.determinant(R.copy()) < 0:
        raise ValueError("no rotation")
    if len(p) == 0:
        return np.zeros((0, 3))
    M = np.column_stack([R[:, 0], -R[:, 1], -R[:, 2], t])
    return cv2.transform(p[:, None, :], M).reshape(-1, 3)


def with_mujoco(points, cam_xpos, cam_xmat):
    """mju_mulMatVec per point, list comprehension, math.isclose in the checks."""
    R = np.array(cam_xmat, dtype=np.float64)
    t = np.array(cam_xpos, dtype=np.float64)
    p = np.array(points, dtype=np.float64)
    if R.shape not in ((9,), (3, 3)) or t.shape != (3,) or p.ndim != 2 or p.shape[1] != 3:
        raise ValueError("a shape does not fit")
    R = R.reshape(9)
    m = R.reshape(3, 3)
    orthonormal = all(math.isclose(float(m[i] @ m[j]), float(i == j), abs_tol=1e-5)
                      for i in range(3) for j in range(3))
    if not orthonormal or float(np.linalg.det(m)) < 0:
        raise ValueError("no rotation")

    def turn(q):
        res = np.zeros(3)
        mujoco.mju_mulMatVec(res, m, np.array([q[0], -q[1], -q[2]]))
        return res + t

    return np.array([turn(q) for q in p], dtype=np.float64).reshape(len(p), 3)


ANSWERS = [matrix_product, plain_loops, homogeneous, by_axes, in_place_on_a_copy,
           with_a_class_and_chunks, with_opencv, with_mujoco]
