"""Right answers to level_cloud, as strangers wrote them."""
import math
import random

import cv2
import numpy as np


def _fit_svd(p):
    center = p.mean(axis=0)
    n = np.linalg.svd(p - center, full_matrices=False)[2][-1]
    return n, -n @ center


def _toward_camera(n, d):
    return (n, d) if d > 0 else (-n, -d)


def _align_rodrigues(n):
    """Rotation about n x e_z: I + [v] + [v]^2 / (1 + c)."""
    v = np.cross(n, [0.0, 0.0, 1.0])
    V = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    if n[2] < -1 + 1e-12:                    # opposite: every axis in the plane will do
        return np.diag([1.0, -1.0, -1.0])
    return np.eye(3) + V + V @ V / (1 + n[2])


# 1. NumPy RANSAC, then SVD until nothing changes
def level_ransac(points, rounds=1500, seed=0):
    rng = np.random.default_rng(seed)
    sample = points if len(points) <= 3000 else points[rng.choice(len(points), 3000, replace=False)]
    best, most = None, -1
    for _ in range(rounds):
        a, b, c = sample[rng.choice(len(sample), 3, replace=False)]
        n = np.cross(b - a, c - a)
        length = np.linalg.norm(n)
        if length < 1e-12:
            continue
        n = n / length
        count = np.count_nonzero(np.abs((sample - a) @ n) < 0.005)
        if count > most:
            best, most = (n, -n @ a), count
    n, d = best
    inside = np.abs(points @ n + d) < 0.010
    for _ in range(20):
        n, d = _fit_svd(points[inside])
        again = np.abs(points @ n + d) < 0.015
        if np.array_equal(again, inside):
            break
        inside = again
    n, d = _toward_camera(n, d)
    return np.append(n, d), points @ _align_rodrigues(n).T + [0, 0, d]


# 2. all trials at once, eigenvectors of the covariance, quaternion for the turn
def level_batched(points):
    rng = np.random.RandomState(42)
    few = points[rng.permutation(len(points))[:2000]]
    tri = few[rng.randint(0, len(few), size=(2000, 3))]
    normals = np.cross(tri[:, 1] - tri[:, 0], tri[:, 2] - tri[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    good = lengths > 1e-10
    normals, origin = normals[good] / lengths[good, None], tri[good, 0]
    offsets = -np.einsum("ij,ij->i", normals, origin)
    counts = np.array([np.sum(np.abs(few @ n + o) <= 0.004) for n, o in zip(normals, offsets)])
    n, d = normals[counts.argmax()], offsets[counts.argmax()]
    for tolerance in (0.008, 0.012, 0.015, 0.015, 0.015):
        table = points[np.abs(points @ n + d) <= tolerance]
        mean = table.mean(axis=0)
        _, vectors = np.linalg.eigh(np.cov(table.T, bias=True))
        n = vectors[:, 0]
        d = -float(mean @ n)
    if d < 0:
        n, d = -n, -d
    # the quaternion (1 + cos, axis) is the smallest turn
    q = np.array([1 + n[2], n[1], -n[0], 0.0])
    if np.linalg.norm(q) < 1e-9:
        q = np.array([0.0, 1.0, 0.0, 0.0])
    w, x, y, z = q / np.linalg.norm(q)
    R = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    leveled = np.einsum("ij,nj->ni", R, points)
    leveled[:, 2] += d
    return np.array([*n, d]), leveled


# 3. Python's random, cv2.PCACompute, cv2.Rodrigues
def level_opencv(points):
    generator = random.Random(1)
    subset = generator.sample(range(len(points)), min(len(points), 1500))
    cloud = points[subset]
    best_count = 0
    for _ in range(1500):
        i, j, k = generator.sample(range(len(cloud)), 3)
        normal = np.cross(cloud[j] - cloud[i], cloud[k] - cloud[i])
        size = math.sqrt(normal.dot(normal))
        if size == 0:
            continue
        normal /= size
        distance = np.abs((cloud - cloud[i]).dot(normal))
        count = int((distance < 0.006).sum())
        if count > best_count:
            best_count, best_normal, best_point = count, normal, cloud[i]
    normal, point = best_normal, best_point
    for _ in range(6):
        near = np.abs((points - point).dot(normal)) < 0.015
        mean, vectors, _ = cv2.PCACompute2(np.ascontiguousarray(points[near]), mean=None)
        normal, point = vectors[2], mean[0]
    d = -normal.dot(point)
    if d < 0:
        normal, d = -normal, -d
    axis = np.cross(normal, (0, 0, 1))
    sine = np.linalg.norm(axis)
    angle = math.atan2(sine, normal[2])
    rvec = axis / sine * angle if sine > 1e-12 else np.array([angle, 0.0, 0.0])
    R = cv2.Rodrigues(rvec)[0]
    return np.hstack([normal, [d]]), (R @ points.T).T + np.array([0.0, 0.0, d])


# 4. mathematician: two reflections make the rotation; plane as null vector
def level_reflections(points):
    rng = np.random.default_rng(2024)
    pool = points[rng.integers(0, len(points), 2500)]
    homogeneous = np.c_[pool, np.ones(len(pool))]

    def trials():
        for _ in range(1500):
            a, b, c = pool[rng.integers(0, len(pool), 3)]
            m = np.cross(b - a, c - a)
            s = np.linalg.norm(m)
            if s > 1e-9:
                yield np.append(m, -m @ a) / s

    plane = max(trials(), key=lambda q: np.count_nonzero(np.abs(homogeneous @ q) < 0.005))
    all_h = np.c_[points, np.ones(len(points))]
    old = None
    while True:
        members = np.abs(all_h @ plane) < 0.014
        if old is not None and (members == old).all():
            break
        old = members
        t = points[members]
        g = t.sum(axis=0) / len(t)
        scatter = (t - g).T @ (t - g)
        values, vectors = np.linalg.eigh(scatter)
        plane = np.append(vectors[:, 0], -vectors[:, 0] @ g)
    if plane[3] < 0:
        plane = -plane
    n = plane[:3]
    # reflect at the plane normal to n, then at the one normal to n + e: n becomes e
    e = np.array([0.0, 0.0, 1.0])
    h = n + e
    if np.linalg.norm(h) < 1e-9:
        R = np.diag([-1.0, 1.0, -1.0])
    else:
        h /= np.linalg.norm(h)
        R = (np.eye(3) - 2 * np.outer(h, h)) @ (np.eye(3) - 2 * np.outer(n, n))
    return plane, np.dot(points, R.T) + plane[3] * e


# 5. Java
class Plane:
    def __init__(self, normal, offset):
        self.normal, self.offset = normal, offset

    @classmethod
    def through(cls, a, b, c):
        normal = np.cross(b - a, c - a)
        length = float(np.linalg.norm(normal))
        if length < 1e-10:
            raise ValueError("the three points lie on a line")
        return cls(normal / length, float(-(normal / length) @ a))

    @classmethod
    def fitted_to(cls, cloud):
        center = np.mean(cloud, axis=0)
        u, s, vt = np.linalg.svd(np.cov(cloud, rowvar=False))
        return cls(vt[2], float(-vt[2] @ center))

    def distances(self, cloud):
        return np.abs(cloud @ self.normal + self.offset)

    def facing_origin(self):
        return self if self.offset > 0 else Plane(-self.normal, -self.offset)

    def basis(self):
        """Rows: where x, y and z of the leveled frame point."""
        nx, ny, nz = self.normal
        if nz < -0.999999999:
            return np.array([[1.0, 0, 0], [0, -1.0, 0], [0, 0, -1.0]])
        k = 1 / (1 + nz)
        return np.array([[1 - k * nx * nx, -k * nx * ny, -nx],
                         [-k * nx * ny, 1 - k * ny * ny, -ny],
                         [nx, ny, nz]])


class Ransac:
    def __init__(self, seed=7, trials=2000, tolerance=0.005):
        self._random = np.random.default_rng(seed)
        self._trials, self._tolerance = trials, tolerance

    def search(self, cloud):
        winner, votes = None, -1
        for _ in range(self._trials):
            try:
                plane = Plane.through(*cloud[self._random.integers(len(cloud), size=3)])
            except ValueError:
                continue
            agree = int(np.count_nonzero(plane.distances(cloud) < self._tolerance))
            if agree > votes:
                winner, votes = plane, agree
        return winner


def level_java(points):
    step = max(1, len(points) // 2000)
    plane = Ransac().search(points[::step])
    for _ in range(8):
        plane = Plane.fitted_to(points[plane.distances(points) < 0.015])
    plane = plane.facing_origin()
    leveled = points @ plane.basis().T
    leveled += np.array([0, 0, plane.offset])
    return np.array([plane.normal[0], plane.normal[1], plane.normal[2], plane.offset]), leveled


# 6. beginner, loops where they are affordable
def level_beginner(points):
    random.seed(12345)
    small = []
    for _ in range(600):
        small.append(points[random.randrange(len(points))])
    small = np.array(small)
    best_count = -1
    best_n = None
    best_d = None
    for trial in range(1500):
        p1 = small[random.randrange(600)]
        p2 = small[random.randrange(600)]
        p3 = small[random.randrange(600)]
        ax, ay, az = p2 - p1
        bx, by, bz = p3 - p1
        nx = ay * bz - az * by
        ny = az * bx - ax * bz
        nz = ax * by - ay * bx
        length = (nx ** 2 + ny ** 2 + nz ** 2) ** 0.5
        if length < 1e-6:
            continue
        n = np.array([nx / length, ny / length, nz / length])
        d = -(n[0] * p1[0] + n[1] * p1[1] + n[2] * p1[2])
        distance = abs(small[:, 0] * n[0] + small[:, 1] * n[1] + small[:, 2] * n[2] + d)
        count = (distance < 0.006).sum()
        if count > best_count:
            best_count = count
            best_n = n
            best_d = d
    n = best_n
    d = best_d
    for repeat in range(10):
        distance = abs(points[:, 0] * n[0] + points[:, 1] * n[1] + points[:, 2] * n[2] + d)
        table = points[distance < 0.015]
        middle = np.mean(table, 0)
        centered = table - middle
        matrix = np.zeros((3, 3))
        for i in range(3):
            for j in range(3):
                matrix[i, j] = np.sum(centered[:, i] * centered[:, j])
        values, vectors = np.linalg.eig(matrix)
        n = np.real(vectors[:, np.argmin(np.real(values))])
        d = -np.dot(n, middle)
    if d < 0:
        n = -n
        d = -d
    # rotate about the axis by the angle
    axis = np.cross(n, np.array([0, 0, 1]))
    s = np.linalg.norm(axis)
    c = n[2]
    leveled = np.zeros(points.shape)
    if s < 1e-12:
        axis = np.array([1.0, 0.0, 0.0])
    else:
        axis = axis / s
    turned = (points * c + np.cross(axis, points) * s
              + np.outer(points.dot(axis), axis) * (1 - c))
    leveled[:, 0] = turned[:, 0]
    leveled[:, 1] = turned[:, 1]
    leveled[:, 2] = turned[:, 2] + d
    return np.array([n[0], n[1], n[2], d]), leveled


ANSWERS = [level_ransac, level_batched, level_opencv, level_reflections, level_java,
           level_beginner]
