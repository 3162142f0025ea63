"""Right answers to level_cloud, as strangers wrote them."""
import math
import random

import cv2
import numpy as np


def _fit(points):
    """Plane through points by least squares, n . p + d = 0 with d > 0."""
    center = points.mean(axis=0)
    normal = np.linalg.svd(points - center, full_matrices=False)[2][2]
    d = -normal @ center
    return (normal, d) if d > 0 else (-normal, -d)


def _turn(n):
    """Smallest rotation from n to (0, 0, 1), also where n points straight down."""
    axis = np.array([n[1], -n[0], 0.0])  # n x (0, 0, 1)
    s, c = np.hypot(n[0], n[1]), n[2]
    if s < 1e-12:
        return np.eye(3) if c > 0 else np.diag([1.0, -1.0, -1.0])
    a = axis / s
    A = np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    return np.eye(3) + s * A + (1 - c) * A @ A


def ransac_and_svd(points):
    """Vectorized RANSAC on a sample of the cloud, then least squares on all points near the plane until nothing changes."""
    rng = np.random.default_rng(0)
    sample = points if len(points) <= 3000 else points[rng.choice(len(points), 3000, replace=False)]
    best, best_count = None, -1
    for _ in range(1500):
        a, b, c = sample[rng.integers(0, len(sample), 3)]
        n = np.cross(b - a, c - a)
        length = np.linalg.norm(n)
        if length < 1e-9:
            continue
        n = n / length
        count = np.count_nonzero(np.abs((sample - a) @ n) < 0.008)
        if count > best_count:
            best, best_count = (n, -n @ a), count
    n, d = best
    inside = np.abs(points @ n + d) < 0.012
    for _ in range(30):
        n, d = _fit(points[inside])
        again = np.abs(points @ n + d) < 0.012
        if np.array_equal(again, inside):
            break
        inside = again
    leveled = points @ _turn(n).T + [0, 0, d]
    return np.array([*n, d]), leveled


def pure_python_ransac(points, seed=7, rounds=1200):
    """random.Random for the triples, normals by hand; eigenvectors of the covariance instead of an SVD."""
    chance = random.Random(seed)
    cloud = np.asarray(points, dtype=np.float64)
    votes = cloud[chance.sample(range(len(cloud)), min(len(cloud), 2000))]
    leader = (-1, None, None)
    for _ in range(rounds):
        (x0, y0, z0), (x1, y1, z1), (x2, y2, z2) = (votes[chance.randrange(len(votes))].tolist() for _ in range(3))
        ux, uy, uz, vx, vy, vz = x1 - x0, y1 - y0, z1 - z0, x2 - x0, y2 - y0, z2 - z0
        n = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
        size = math.sqrt(n[0] ** 2 + n[1] ** 2 + n[2] ** 2)
        if size < 1e-8:
            continue
        n = [k / size for k in n]
        d = -(n[0] * x0 + n[1] * y0 + n[2] * z0)
        count = int((np.abs(votes.dot(n) + d) <= 0.01).sum())
        if count > leader[0]:
            leader = (count, n, d)
    _, n, d = leader
    for limit in (0.02, 0.015, 0.012, 0.012, 0.012):
        table = cloud[np.abs(cloud.dot(n) + d) <= limit]
        middle = table.mean(axis=0)
        n = np.linalg.eigh(np.cov((table - middle).T))[1][:, 0]
        d = -float(n @ middle)
    if d < 0:
        n, d = -n, -d
    # Rodrigues' formula, point by point
    R = _turn(n)
    leveled = np.array([[sum(R[i, k] * p[k] for k in range(3)) + (d if i == 2 else 0.0) for i in range(3)]
                        for p in cloud.tolist()]).reshape(-1, 3)
    return np.append(n, d), leveled


def all_planes_at_once(points):
    """RandomState, all hypotheses in one array product, soft (MSAC) score; cv2.Rodrigues for R."""
    rng = np.random.RandomState(12345)
    some = points[rng.permutation(len(points))[:1500]]
    triples = some[rng.randint(0, len(some), (3000, 3))]
    normals = np.cross(triples[:, 1] - triples[:, 0], triples[:, 2] - triples[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    use = lengths > 1e-9
    normals = normals[use] / lengths[use, None]
    offsets = -np.einsum("ij,ij->i", normals, triples[use, 0])
    scores = np.empty(len(normals))
    for k in range(0, len(normals), 300):
        off = np.abs(normals[k:k + 300] @ some.T + offsets[k:k + 300, None])
        scores[k:k + 300] = np.minimum(off / 0.01, 1.0).sum(axis=1)
    n, d = normals[scores.argmin()], offsets[scores.argmin()]
    for _ in range(12):
        table = points[np.abs(points @ n + d) < 0.014]
        n, d = _fit(table)
    axis = np.cross(n, [0.0, 0.0, 1.0])
    sine = np.linalg.norm(axis)
    angle = np.arctan2(sine, n[2])
    axis = axis / sine if sine > 1e-12 else np.array([1.0, 0.0, 0.0])
    R, _ = cv2.Rodrigues(axis * angle)
    return np.hstack([n, d]), (R @ points.T).T + np.array([0.0, 0.0, d])


class _Plane:
    def __init__(self, normal, offset):
        self.normal, self.offset = np.asarray(normal, dtype=np.float64), float(offset)

    @classmethod
    def through(cls, a, b, c):
        n = np.cross(b - a, c - a)
        size = np.sqrt(n @ n)
        return None if size < 1e-10 else cls(n / size, -(n / size) @ a)

    @classmethod
    def fitted(cls, points):
        mean = np.mean(points, axis=0)
        scatter = (points - mean).T @ (points - mean)
        values, vectors = np.linalg.eigh(scatter)
        n = vectors[:, np.argmin(values)]
        return cls(n, -(n @ mean))

    def near(self, points, limit):
        return np.abs(points @ self.normal + self.offset) < limit

    def facing_origin(self):
        return self if self.offset > 0 else _Plane(-self.normal, -self.offset)


def with_local_refits(points, seed=2024):
    """A plane class; every new leader is refitted at once (LO-RANSAC) and counted on the whole cloud; stops early when more tries are pointless."""
    rng = np.random.default_rng(seed)
    leader, leader_count, tries, needed = None, 0, 0, 4000.0
    sub = points[rng.integers(0, len(points), min(len(points), 1500))]
    while tries < min(4000.0, max(300.0, needed)):
        tries += 1
        plane = _Plane.through(*points[rng.choice(len(points), 3, replace=False)] if len(points) < 5000
                               else points[rng.integers(0, len(points), 3)])
        if plane is None or leader is not None and plane.near(sub, 0.01).sum() < 0.5 * leader.near(sub, 0.01).sum():
            continue
        for _ in range(3):
            near = plane.near(points, 0.012)
            if near.sum() < 3:
                break
            plane = _Plane.fitted(points[near])
        count = int(plane.near(points, 0.01).sum())
        if count > leader_count:
            leader, leader_count = plane, count
            needed = math.log(1e-9) / math.log(max(1e-12, 1 - min(1 - 1e-9, (count / len(points)) ** 3)))
    plane = leader
    for _ in range(10):
        plane = _Plane.fitted(points[plane.near(points, 0.014)])
    plane = plane.facing_origin()
    a, b, c = plane.normal
    # closed form; (1 - c) / s^2 equals 1 / (1 + c) but is safe near c = -1
    s2 = a * a + b * b
    if s2 < 1e-20:
        R = np.diag([1.0, math.copysign(1.0, c), math.copysign(1.0, c)])
    else:
        k = (1 - c) / s2 if c < 0 else 1 / (1 + c)
        R = np.array([[1 - k * a * a, -k * a * b, -a], [-k * a * b, 1 - k * b * b, -b], [a, b, c]])
    leveled = np.einsum("ij,nj->ni", R, points)
    leveled[:, 2] += plane.offset
    return np.array([a, b, c, plane.offset]), leveled


def frames_of_the_turn(points):
    """R from two orthonormal frames (axis, direction, normal) instead of Rodrigues' formula; the ten best hypotheses are refitted on the whole cloud."""
    generator = np.random.Generator(np.random.PCG64(99))
    n_points = len(points)
    sub = points[generator.permutation(n_points)[:2500]]
    counts, planes = [], []
    for _ in range(1200):
        tri = sub[generator.choice(len(sub), 3, replace=False, shuffle=False)]
        w = np.cross(tri[0] - tri[2], tri[1] - tri[2])
        if w @ w < 1e-16:
            continue
        w /= np.sqrt(w @ w)
        planes.append((w, -w @ tri.mean(axis=0)))
        counts.append(np.count_nonzero(np.abs(sub @ planes[-1][0] + planes[-1][1]) < 0.01))
    finalists = sorted(range(len(counts)), key=lambda k: -counts[k])[:10]
    best = None
    for k in finalists:
        w, d = planes[k]
        for _ in range(15):
            near = np.abs(points @ w + d) < 0.013
            w, d = _fit(points[near])
        near = np.abs(points @ w + d) < 0.01
        if best is None or near.sum() > best[0]:
            best = (near.sum(), w, d)
    _, n, d = best
    z = np.array([0.0, 0.0, 1.0])
    axis = np.cross(n, z)
    if np.linalg.norm(axis) < 1e-12:
        axis = np.array([0.0, 1.0, 0.0])
    axis /= np.linalg.norm(axis)
    before = np.column_stack([axis, np.cross(n, axis), n])
    after = np.column_stack([axis, np.cross(z, axis), z])
    R = after @ before.T
    return np.concatenate([n, [d]]), points @ R.T + d * z


def quaternion_turn(points):
    """Small RANSAC with seeded Python random, iterated total least squares with shrinking limits, rotation by a quaternion."""
    rng = random.Random("table")
    cloud = np.array(points, dtype=np.float64)
    idx = np.array([rng.randrange(len(cloud)) for _ in range(min(2000, 4 * len(cloud)))])
    sub = cloud[idx]
    top, n, d = -1, None, None
    for _ in range(2000):
        i, j, k = rng.sample(range(len(sub)), 3)
        w = np.cross(sub[j] - sub[i], sub[k] - sub[i])
        size = np.sqrt(np.dot(w, w))
        if size < 1e-9:
            continue
        h = float(np.dot(w, sub[i]) / size)
        hits = int(np.sum(np.abs(sub @ (w / size) - h) < 0.009))
        if hits > top:
            top, n, d = hits, w / size, -h
    for limit in (0.018, 0.014, 0.012, 0.012, 0.012, 0.012):
        n, d = _fit(cloud[np.abs(cloud @ n + d) < limit])
    # half-angle quaternion (w, x, y, 0) of the turn from n to z; the axis is (b, -a, 0)
    half = 0.5 * math.atan2(math.hypot(n[0], n[1]), n[2])
    length = math.hypot(n[0], n[1])
    ax, ay = (n[1] / length, -n[0] / length) if length > 1e-12 else (1.0, 0.0)
    q0, qv = math.cos(half), np.array([ax, ay, 0.0]) * math.sin(half)
    t = 2 * np.cross(qv, cloud)
    leveled = cloud + q0 * t + np.cross(qv, t)
    leveled[:, 2] += d
    return np.array([n[0], n[1], n[2], d]), leveled


def without_chance(points):
    """No random numbers: triples at fixed strides through the cloud, scored and refitted like RANSAC."""
    n_points = len(points)
    sub = points[np.linspace(0, n_points - 1, min(n_points, 2000)).astype(int)]
    m, candidates = len(sub), []
    for k in range(3000):
        i, j, l = (k * 7919 + 13) % m, (k * 104729 + 7 * (k // 11) + 1) % m, (k * 15485863 + 31 * (k // 5) + 2) % m
        w = np.cross(sub[j] - sub[i], sub[l] - sub[i])
        size = np.linalg.norm(w)
        if size > 1e-9:
            candidates.append((w / size, -(w / size) @ sub[i]))
    N = np.array([c[0] for c in candidates])
    D = np.array([c[1] for c in candidates])
    counts = np.concatenate([(np.abs(N[k:k + 250] @ sub.T + D[k:k + 250, None]) < 0.01).sum(axis=1)
                             for k in range(0, len(N), 250)])
    result = None
    for k in np.argsort(-counts, kind="stable")[:5]:
        n, d = N[k], D[k]
        for _ in range(10):
            n, d = _fit(points[np.abs(points @ n + d) < 0.014])
        count = int(np.count_nonzero(np.abs(points @ n + d) < 0.01))
        if result is None or count > result[0]:
            result = (count, n, d)
    _, n, d = result
    return np.r_[n, d], points @ _turn(n).T + np.array([0, 0, d])


ANSWERS = [ransac_and_svd, pure_python_ransac, all_planes_at_once, with_local_refits,
           frames_of_the_turn, quaternion_turn, without_chance]
