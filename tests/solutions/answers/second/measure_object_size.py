"""Right answers to measure_object_size, as strangers wrote them."""
import statistics
from dataclasses import dataclass

import cv2
import numpy as np


# 1. NumPy
def f1(mask, depth_metric, K):
    use = (mask > 0) & (depth_metric > 0.01) & (depth_metric < 10)
    middle = np.median(depth_metric[use].astype(float))
    use &= np.abs(depth_metric.astype(float) - middle) <= 0.05
    v, u = np.nonzero(use)
    z = depth_metric[use].astype(float)
    x = (u - K[0, 2]) / K[0, 0] * z
    y = (v - K[1, 2]) / K[1, 1] * z
    return float(x.max() - x.min()), float(y.max() - y.min())


# 2. C programmer
def f2(mask, depth_metric, K):
    H, W = mask.shape
    values = []
    for v in range(H):
        for u in range(W):
            if mask[v, u] == 255 and 0.01 < depth_metric[v, u] < 10:
                values.append(float(depth_metric[v, u]))
    values.sort()
    n = len(values)
    middle = values[n // 2] if n % 2 == 1 else 0.5 * (values[n // 2 - 1] + values[n // 2])
    x0 = y0 = float("inf")
    x1 = y1 = -float("inf")
    for v in range(H):
        for u in range(W):
            if mask[v, u] != 255:
                continue
            z = float(depth_metric[v, u])
            if not 0.01 < z < 10 or abs(z - middle) > 0.05:
                continue
            x = (u - K[0, 2]) * z / K[0, 0]
            y = (v - K[1, 2]) * z / K[1, 1]
            x0, x1, y0, y1 = min(x0, x), max(x1, x), min(y0, y), max(y1, y)
    return x1 - x0, y1 - y0


# 3. K inverse, ptp, an array of two NumPy numbers comes back as a tuple
def f3(mask, depth_metric, K):
    v, u = np.where((mask != 0) & np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10))
    z = depth_metric[v, u].astype(np.float64)
    near = np.abs(z - np.median(z)) <= 0.05
    P = np.linalg.inv(K) @ np.array([u[near], v[near], np.ones(near.sum())]) * z[near]
    width, height, _ = np.ptp(P, axis=1)
    return width, height


# 4. float32
def f4(mask, depth_metric, K):
    D = np.asarray(depth_metric, np.float32)
    k = np.asarray(K, np.float32)
    ok = (mask > 127) & (D > np.float32(0.01)) & (D < np.float32(10))
    m = np.median(D[ok])
    ok = ok & (np.abs(D - m) <= np.float32(0.05))
    yy, xx = np.indices(D.shape, dtype=np.float32)
    X = ((xx - k[0, 2]) / k[0, 0] * np.where(ok, D, 0))[ok]
    Y = ((yy - k[1, 2]) / k[1, 1] * np.where(ok, D, 0))[ok]
    return float(X.max() - X.min()), float(Y.max() - Y.min())


# 5. masked arrays
def f5(mask, depth_metric, K):
    z = np.ma.masked_invalid(np.array(depth_metric, dtype=float))
    z = np.ma.masked_where((mask == 0) | (z.filled(0) <= 0.01) | (z.filled(0) >= 10), z)
    z = np.ma.masked_where((abs(z - np.ma.median(z)) > 0.05).filled(True), z)
    x = (np.arange(z.shape[1])[None, :] - K[0, 2]) / K[0, 0] * z
    y = (np.arange(z.shape[0])[:, None] - K[1, 2]) / K[1, 1] * z
    return float(x.max() - x.min()), float(y.max() - y.min())


# 6. over-engineered
@dataclass(frozen=True)
class _SizeMeter:
    K: np.ndarray
    band: float = 0.05
    limits: tuple = (0.01, 10.0)

    def measure(self, mask, depth):
        if mask.shape != depth.shape:
            raise ValueError("mask and depth differ in shape")
        samples = [(u, v, z) for (v, u), z in np.ndenumerate(depth.astype(float))
                   if mask[v, u] and self.limits[0] < z < self.limits[1]]
        if not samples:
            raise ValueError("no valid pixel in the mask")
        middle = statistics.median(s[2] for s in samples)
        side = [self._point(*s) for s in samples if abs(s[2] - middle) <= self.band]
        xs, ys = zip(*side)
        return max(xs) - min(xs), max(ys) - min(ys)

    def _point(self, u, v, z):
        fx, cx = self.K[0, 0], self.K[0, 2]
        fy, cy = self.K[1, 1], self.K[1, 2]
        return float((u - cx) * z / fx), float((v - cy) * z / fy)


def f6(mask: np.ndarray, depth_metric: np.ndarray, K: np.ndarray):
    return _SizeMeter(K).measure(mask, depth_metric)


# 7. OpenCV: countNonZero, undistortPoints, minMaxLoc
def f7(mask, depth_metric, K):
    clean = np.nan_to_num(depth_metric.astype(np.float64), nan=0.0, posinf=0.0, neginf=0.0)
    keep = cv2.bitwise_and(((clean > 0.01) & (clean < 10)).astype(np.uint8) * 255, mask)
    middle = float(np.percentile(clean[keep > 0], 50))
    keep[np.abs(clean - middle) > 0.05] = 0
    pixels = cv2.findNonZero(keep).reshape(-1, 1, 2)
    rays = cv2.undistortPoints(pixels.astype(np.float64), np.asarray(K, float), None).reshape(-1, 2)
    z = clean[pixels[:, 0, 1], pixels[:, 0, 0]]
    sizes = []
    for axis in (0, 1):
        low, high, _, _ = cv2.minMaxLoc(np.ascontiguousarray(rays[:, axis] * z).reshape(-1, 1))
        sizes.append(high - low)
    return tuple(sizes)


# 8. few lines
def f8(mask, depth_metric, K):
    v, u = np.nonzero(mask * ((depth_metric > .01) & (depth_metric < 10)))
    z = depth_metric[v, u].astype(float)
    u, v, z = np.array([u, v, z])[:, abs(z - np.median(z)) <= .05]
    return [float(np.ptp(a * z)) for a in ((u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1])]


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
