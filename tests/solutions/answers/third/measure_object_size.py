"""Right answers to measure_object_size, as strangers wrote them."""
import statistics

import cv2
import numpy as np


# 1. the usual one
def size_numpy(mask, depth_metric, K):
    v, u = np.nonzero((mask > 0) & (depth_metric > 0.01) & (depth_metric < 10))
    z = depth_metric[v, u].astype(np.float64)
    keep = np.abs(z - np.median(z)) <= 0.05
    u, v, z = u[keep], v[keep], z[keep]
    x = (u - K[0, 2]) * z / K[0, 0]
    y = (v - K[1, 2]) * z / K[1, 1]
    return float(x.max() - x.min()), float(y.max() - y.min())


# 2. beginner
def size_beginner(mask, depth_metric, K):
    depths = []
    for row in range(mask.shape[0]):
        for column in range(mask.shape[1]):
            if mask[row, column] == 255:
                d = float(depth_metric[row, column])
                if d > 0.01 and d < 10:
                    depths.append(d)
    depths.sort()
    n = len(depths)
    if n % 2 == 1:
        median = depths[n // 2]
    else:
        median = (depths[n // 2 - 1] + depths[n // 2]) / 2
    min_x = min_y = 1e9
    max_x = max_y = -1e9
    for row in range(mask.shape[0]):
        for column in range(mask.shape[1]):
            d = float(depth_metric[row, column])
            if mask[row, column] == 255 and d > 0.01 and d < 10 and abs(d - median) <= 0.05:
                x = (column - K[0, 2]) / K[0, 0] * d
                y = (row - K[1, 2]) / K[1, 1] * d
                min_x = min(min_x, x)
                max_x = max(max_x, x)
                min_y = min(min_y, y)
                max_y = max(max_y, y)
    return max_x - min_x, max_y - min_y


# 3. mathematician
def size_inverse(mask, depth_metric, K):
    D = np.where(mask != 0, depth_metric, np.nan).astype(float)
    D[~((D > 0.01) & (D < 10))] = np.nan
    D[~(np.abs(D - np.nanmedian(D)) <= 0.05)] = np.nan
    i, j = np.where(np.isfinite(D))
    P = np.linalg.inv(K) @ (np.vstack([j, i, np.ones_like(i)]) * D[i, j])
    return tuple(np.ptp(P[:2], axis=1))


# 4. masked arrays, list back
def size_masked(mask, depth_metric, K):
    z = np.ma.array(depth_metric.astype(np.float64), mask=mask == 0)
    z = np.ma.masked_invalid(z)
    z = np.ma.masked_where((z.filled(0) <= 0.01) | (z.filled(0) >= 10), z)
    z = np.ma.masked_where(np.abs(z.filled(99) - float(np.ma.median(z))) > 0.05, z)
    rows, cols = np.ogrid[:mask.shape[0], :mask.shape[1]]
    x = z * (cols - K[0, 2]) / K[0, 0]
    y = z * (rows - K[1, 2]) / K[1, 1]
    return [x.max() - x.min(), y.max() - y.min()]


# 5. OpenCV
def size_opencv(mask, depth_metric, K):
    d = depth_metric.copy()
    d[~np.isfinite(d)] = 0
    ok = (mask == 255) & (d > 0.01) & (d < 10)
    middle = statistics.median(d[ok].tolist())
    ok &= np.abs(d.astype(np.float64) - middle) <= 0.05
    pixels = cv2.findNonZero(ok.astype(np.uint8)).reshape(-1, 2).astype(np.float64)
    rays = cv2.undistortPoints(pixels.reshape(-1, 1, 2), K, None).reshape(-1, 2)
    u, v = pixels.astype(int).T
    points = rays * d[v, u][:, None]
    low_x, high_x = cv2.minMaxLoc(np.ascontiguousarray(points[:, 0]))[:2]
    low_y, high_y = cv2.minMaxLoc(np.ascontiguousarray(points[:, 1]))[:2]
    return high_x - low_x, high_y - low_y


# 6. Java
class ObjectMeter:
    def __init__(self, K, tolerance=0.05, near=0.01, far=10.0):
        self._K, self._tolerance, self._near, self._far = K, tolerance, near, far

    def _pixels(self, mask, depth):
        return [(u, v, float(depth[v, u])) for v, u in np.argwhere(mask)
                if self._near < float(depth[v, u]) < self._far]

    def measure(self, mask, depth):
        pixels = self._pixels(mask, depth)
        if not pixels:
            raise ValueError("no valid pixel in the mask")
        middle = statistics.median(z for _, _, z in pixels)
        kept = [p for p in pixels if abs(p[2] - middle) <= self._tolerance]
        extent = []
        for axis in (0, 1):
            values = sorted((p[axis] - self._K[axis, 2]) * p[2] / self._K[axis, axis] for p in kept)
            extent.append(float(values[-1] - values[0]))
        return tuple(extent)


def size_java(mask, depth_metric, K):
    return ObjectMeter(K).measure(mask, depth_metric)


# 7. Matlab: whole-image X and Y, then logical indexing
def size_matlab(mask, depth_metric, K):
    U, V = np.meshgrid(np.arange(mask.shape[1]), np.arange(mask.shape[0]))
    Z = np.array(depth_metric, dtype=np.float64)
    Z[np.isnan(Z) | np.isinf(Z)] = 0
    M = (mask == 255) & (Z > 0.01) & (Z < 10)
    s = np.sort(Z[M])
    m = (s[(s.size - 1) // 2] + s[s.size // 2]) / 2
    M = M & (Z >= m - 0.05) & (Z <= m + 0.05)
    X = (U - K[0, 2]) * Z / K[0, 0]
    Y = (V - K[1, 2]) * Z / K[1, 1]
    return np.max(X[M]) - np.min(X[M]), np.max(Y[M]) - np.min(Y[M])


ANSWERS = [size_numpy, size_beginner, size_inverse, size_masked, size_opencv, size_java,
           size_matlab]
