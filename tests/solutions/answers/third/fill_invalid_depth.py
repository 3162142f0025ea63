"""Right answers to fill_invalid_depth, as strangers wrote them."""
import math

import cv2
import numpy as np


# 1. dilation is the maximum of the neighbors
def fill_dilate(depth_metric):
    filled = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, 0)
    filled = filled.astype(np.float32)
    kernel = np.ones((3, 3), np.uint8)
    while (filled == 0).any():
        filled = np.where(filled == 0, cv2.dilate(filled, kernel), filled)
    return filled


# 2. beginner
def fill_beginner(depth_metric):
    height, width = depth_metric.shape
    depth = [[float(d) for d in row] for row in depth_metric]

    def is_valid(d):
        return d > 0.01 and d < 10

    while True:
        new_depth = [row[:] for row in depth]
        invalid_left = False
        for v in range(height):
            for u in range(width):
                if is_valid(depth[v][u]):
                    continue
                farthest = 0
                for dv in [-1, 0, 1]:
                    for du in [-1, 0, 1]:
                        if dv == 0 and du == 0:
                            continue
                        if v + dv < 0 or v + dv >= height or u + du < 0 or u + du >= width:
                            continue
                        neighbor = depth[v + dv][u + du]
                        if is_valid(neighbor) and neighbor > farthest:
                            farthest = neighbor
                if farthest > 0:
                    new_depth[v][u] = farthest
                else:
                    invalid_left = True
        depth = new_depth
        if not invalid_left:
            return np.array(depth)


# 3. NaN and nanmax over eight shifted copies
def fill_nanmax(depth_metric):
    d = np.array(depth_metric, dtype=np.float64)
    d[~((d > 0.01) & (d < 10.0))] = -np.inf
    H, W = d.shape
    shifts = [(i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    while np.isneginf(d).any():
        padded = np.pad(d, 1, constant_values=-np.inf)
        best = np.max([padded[i:i + H, j:j + W] for i, j in shifts], axis=0)
        d = np.where(np.isneginf(d), best, d)
    return d


# 4. queue: a front that walks inward, round by round
def fill_front(depth_metric):
    out = depth_metric.astype(float)
    valid = (out > 0.01) & (out < 10)
    H, W = out.shape

    def around(r, c):
        for rr in range(max(r - 1, 0), min(r + 2, H)):
            for cc in range(max(c - 1, 0), min(c + 2, W)):
                if (rr, cc) != (r, c):
                    yield rr, cc

    holes = set(zip(*np.nonzero(~valid)))
    front = {p for p in holes if any(valid[q] for q in around(*p))}
    while front:
        values = {p: max(out[q] for q in around(*p) if valid[q]) for p in front}
        for p, z in values.items():
            out[p] = z
            valid[p] = True
        holes -= front
        front = {q for p in front for q in around(*p) if q in holes}
    return out


# 5. Java
class DepthFiller:
    def __init__(self, depth, near=0.01, far=10.0):
        self._depth = np.where((depth > near) & (depth < far), depth, np.float32(-1))
        if not (self._depth > 0).any():
            raise ValueError("no valid pixel")

    def has_holes(self):
        return bool((self._depth < 0).any())

    def do_round(self):
        before = self._depth.copy()
        for row, column in np.argwhere(before < 0):
            window = before[max(row - 1, 0):row + 2, max(column - 1, 0):column + 2]
            self._depth[row, column] = window.max()      # stays -1 where no neighbor is valid

    def result(self):
        return self._depth


def fill_java(depth_metric):
    filler = DepthFiller(depth_metric)
    while filler.has_holes():
        filler.do_round()
    return filler.result()


# 6. recursion, masked arrays and sliding windows
def fill_recursive(depth_metric):
    z = np.ma.masked_invalid(depth_metric)
    z = np.ma.masked_where((z.filled(0) <= 0.01) | (z.filled(0) >= 10), z)
    holes = np.ma.getmaskarray(z)
    if not holes.any():
        return np.array(depth_metric)
    padded = np.pad(z.filled(-math.inf), 1, constant_values=-math.inf)
    windows = np.lib.stride_tricks.sliding_window_view(padded, (3, 3))
    values = z.filled(np.nan)
    best = windows.max(axis=(2, 3))[holes]
    values[holes] = np.where(np.isfinite(best), best, np.nan)
    return fill_recursive(values)


# 7. Matlab: distances give the round; each round only looks at the ring before
def fill_rings(depth_metric):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    if valid.all():
        return depth_metric.astype(np.float64)
    ring = np.rint(cv2.distanceTransform((~valid).astype(np.uint8), cv2.DIST_C, 3)).astype(int)
    D = np.where(valid, depth_metric, 0.0).astype(np.float64)
    for k in range(1, ring.max() + 1):
        rows, cols = np.nonzero(ring == k)
        farthest = np.zeros(rows.size)
        for i in (-1, 0, 1):
            for j in (-1, 0, 1):
                r, c = rows + i, cols + j
                ok = (r >= 0) & (r < D.shape[0]) & (c >= 0) & (c < D.shape[1])
                farthest[ok] = np.maximum(farthest[ok], D[r[ok], c[ok]])
        D[rows, cols] = farthest
    return D


ANSWERS = [fill_dilate, fill_beginner, fill_nanmax, fill_front, fill_java, fill_recursive,
           fill_rings]
