"""Right answers to level_cloud, as strangers wrote them."""
import math
import random

import cv2
import numpy as np


def _ransac(points, rng, tries, tol):
    best, count = None, -1
    for _ in range(tries):
        a, b, c = points[rng.choice(len(points), 3, replace=False)]
        n = np.cross(b - a, c - a)
        size = np.linalg.norm(n)
        if size < 1e-9:
            continue
        inside = np.abs((points - a) @ (n / size)) < tol
        if inside.sum() > count:
            best, count = inside, inside.sum()
    return best


def _refit(points, inside, tol=0.015, rounds=10):
    for _ in range(rounds):
        center = points[inside].mean(axis=0)
        n = np.linalg.svd(points[inside] - center, full_matrices=False)[2][2]
        again = np.abs((points - center) @ n) < tol
        if (again == inside).all():
            break
        inside = again
    d = -n @ center
    return (n, d) if d > 0 else (-n, -d)


# 1. RANSAC + SVD + Rodrigues' formula as matrix
def f1(points):
    n, d = _refit(points, _ransac(points, np.random.default_rng(0), 500, 0.005))
    z = np.array([0.0, 0.0, 1.0])
    v, c = np.cross(n, z), n[2]
    if c < -1 + 1e-12:
        R = np.diag([1.0, -1.0, -1.0])
    else:
        V = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
        R = np.eye(3) + V + V @ V / (1 + c)
    return np.r_[n, d], points @ R.T + [0, 0, d]


# 2. all hypotheses at once, eigh, cv2.Rodrigues
def f2(points):
    rng = np.random.RandomState(42)
    idx = np.array([rng.permutation(len(points))[:3] for _ in range(400)])
    a, b, c = points[idx[:, 0]], points[idx[:, 1]], points[idx[:, 2]]
    N = np.cross(b - a, c - a)
    L = np.linalg.norm(N, axis=1)
    N, a = N[L > 1e-9] / L[L > 1e-9, None], a[L > 1e-9]
    off = np.abs(points @ N.T - np.einsum("ij,ij->i", N, a))
    mask = off[:, (off < 0.004).sum(axis=0).argmax()] < 0.010
    for _ in range(5):
        q = points[mask]
        w, V = np.linalg.eigh(np.cov(q.T))
        n = V[:, 0]
        d = -n.dot(q.mean(0))
        mask = abs(points @ n + d) < 0.012
    if d < 0:
        n, d = -n, -d
    axis = np.cross(n, [0, 0, 1])
    s = np.linalg.norm(axis)
    angle = math.atan2(s, n[2])
    rvec = axis / s * angle if s > 1e-12 else np.array([angle, 0, 0])
    R, _ = cv2.Rodrigues(rvec)
    return np.append(n, d), (R @ points.T).T + np.array([0, 0, d])


# 3. random module, plain Python sampling, homogeneous transformation
def f3(points):
    rnd = random.Random(7)
    best = []
    for _ in range(300):
        i, j, k = rnd.sample(range(len(points)), 3)
        n = np.cross(points[j] - points[i], points[k] - points[i])
        length = math.sqrt(n @ n)
        if length == 0:
            continue
        n = n / length
        agree = np.flatnonzero(np.abs((points - points[i]) @ n) <= 0.006)
        if len(agree) > len(best):
            best = agree
    mask = np.zeros(len(points), bool)
    mask[best] = True
    n, d = _refit(points, mask, tol=0.01)
    T = np.eye(4)
    x, y, z = n
    h = 1 / (1 + z) if z > -1 else 0
    T[:3, :3] = [[1 - h * x * x, -h * x * y, -x], [-h * x * y, 1 - h * y * y, -y], [x, y, z]]
    T[2, 3] = d
    P = np.c_[points, np.ones(len(points))] @ T.T
    return np.array([x, y, z, d]), P[:, :3]


# 4. class, quaternion
class TableFinder:
    def __init__(self, tolerance=0.005, tries=600, seed=1):
        self.tolerance, self.tries = tolerance, tries
        self.rng = np.random.default_rng(seed)

    def fit(self, points):
        if points.ndim != 2 or points.shape[1] != 3 or len(points) < 3:
            raise ValueError("need (N, 3) points, N >= 3")
        mask = _ransac(points, self.rng, self.tries, self.tolerance)
        for _ in range(4):
            q = points[mask]
            self.center = q.mean(axis=0)
            A = (q - self.center).T @ (q - self.center)
            self.n = np.linalg.eigh(A)[1][:, 0]
            mask = np.abs((points - self.center) @ self.n) < 0.02
        if self.n @ self.center > 0:
            self.n = -self.n
        self.d = -float(self.n @ self.center)
        return self

    def rotate(self, p):
        w = 1 + self.n[2]
        q = np.array([w, *np.cross(self.n, [0, 0, 1])])
        if w < 1e-12:
            q = np.array([0, 1.0, 0, 0])
        q /= np.linalg.norm(q)
        t = 2 * np.cross(q[1:], p)
        return p + q[0] * t + np.cross(q[1:], t)


def f4(points):
    f = TableFinder().fit(points)
    out = f.rotate(points)
    out[:, 2] += f.d
    return np.array([*f.n, f.d]), out


# 5. Householder-like: two reflections make the smallest rotation
def f5(points):
    n, d = _refit(points, _ransac(points, np.random.default_rng(2024), 400, 0.004), tol=0.015, rounds=20)
    e = np.array([0.0, 0.0, 1.0])
    half = n + e
    if np.linalg.norm(half) < 1e-9:
        R = np.diag([1.0, -1.0, -1.0])
    else:
        half = half / np.linalg.norm(half)
        flip = lambda a: np.eye(3) - 2 * np.outer(a, a)
        R = flip(half) @ flip(n)
    return np.concatenate([n, [d]]), np.einsum("ij,nj->ni", R, points) + d * e


# 6. axis-angle formula on the points, fit via lstsq in the table's own axes and once more via svd
def f6(points):
    rng = np.random.default_rng(123)
    inside = _ransac(points, rng, 500, 0.005)
    for _ in range(3):
        c = points[inside].mean(0)
        U, S, Vt = np.linalg.svd(np.cov((points[inside] - c).T))
        n = U[:, -1]
        inside = abs((points - c) @ n) < 0.0125
    c = points[inside].mean(0)
    n = np.linalg.svd((points[inside] - c).T @ (points[inside] - c))[0][:, 2]
    n = n * -np.sign(n @ c)
    d = float(-(n @ c))
    k = np.cross(n, [0.0, 0.0, 1.0])
    sin, cos = np.linalg.norm(k), n[2]
    k = k / sin if sin > 1e-12 else np.array([1.0, 0, 0])
    turned = points * cos + np.cross(k, points) * sin + np.outer(points @ k, k) * (1 - cos)
    return np.hstack([n, d]), turned + np.array([0, 0, d])


ANSWERS = [f1, f2, f3, f4, f5, f6]
