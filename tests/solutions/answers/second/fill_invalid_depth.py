"""Right answers to fill_invalid_depth, as strangers wrote them."""
from collections import deque
from dataclasses import dataclass

import cv2
import numpy as np


# 1. dilate
def f1(depth_metric):
    with np.errstate(invalid="ignore"):
        valid = (depth_metric > 0.01) & (depth_metric < 10)
    filled = np.where(valid, depth_metric, 0).astype(np.float32)
    while not (filled > 0).all():
        grown = cv2.dilate(filled, np.ones((3, 3), np.uint8))
        filled = np.where(filled > 0, filled, grown)
    return filled


# 2. C programmer
def f2(depth_metric):
    H, W = depth_metric.shape
    d = depth_metric.copy()
    ok = np.zeros((H, W), bool)
    for y in range(H):
        for x in range(W):
            ok[y, x] = 0.01 < d[y, x] < 10
    left = int((~ok).sum())
    while left:
        changes = []
        for y in range(H):
            for x in range(W):
                if ok[y, x]:
                    continue
                best = -1.0
                for j in range(max(0, y - 1), min(H, y + 2)):
                    for i in range(max(0, x - 1), min(W, x + 2)):
                        if ok[j, i] and d[j, i] > best:
                            best = d[j, i]
                if best > 0:
                    changes.append((y, x, best))
        for y, x, best in changes:
            d[y, x] = best
            ok[y, x] = True
        left -= len(changes)
    return d


# 3. padded slices, float64, -inf for unknown
def f3(depth_metric):
    d = depth_metric.astype(np.float64)
    with np.errstate(invalid="ignore"):
        d[~((d > 0.01) & (d < 10))] = -np.inf
    H, W = d.shape
    while np.isneginf(d).any():
        p = np.pad(d, 1, constant_values=-np.inf)
        around = np.max([p[j:j + H, i:i + W] for j in range(3) for i in range(3)], axis=0)
        d = np.where(np.isneginf(d), around, d)
    return d


# 4. queue, level by level
def f4(depth_metric):
    H, W = depth_metric.shape
    out = np.array(depth_metric, dtype=np.float64)
    with np.errstate(invalid="ignore"):
        rank = np.where((depth_metric > 0.01) & (depth_metric < 10), 0, -1)
    around = [(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1) if a or b]

    def neighbors(y, x):
        for a, b in around:
            if 0 <= y + a < H and 0 <= x + b < W:
                yield y + a, x + b

    queue = deque(zip(*map(np.ndarray.tolist, np.nonzero(rank == 0))))
    while queue:
        y, x = queue.popleft()
        for q in neighbors(y, x):
            if rank[q] == -1:
                rank[q] = rank[y, x] + 1
                queue.append(q)
                out[q] = -1
            if rank[q] == rank[y, x] + 1:
                out[q] = max(out[q], out[y, x])
    return out


# 5. sliding windows and NaN
def f5(depth_metric):
    d = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.nan)
    while np.isnan(d).any():
        win = np.lib.stride_tricks.sliding_window_view(np.pad(d, 1, constant_values=np.nan), (3, 3))
        d = np.where(np.isnan(d), np.fmax.reduce(win, axis=(2, 3)), d)
    return d


# 6. class, only the frontier is computed
@dataclass
class _Filler:
    near: float = 0.01
    far: float = 10.0
    connectivity: int = 8

    def __call__(self, depth):
        known = np.isfinite(depth) & (depth > self.near) & (depth < self.far)
        if not known.any():
            raise ValueError("at least one pixel must be valid")
        z = np.where(known, depth, np.float32(0))
        kernel = np.ones((3, 3), np.uint8)
        while True:
            rim = cv2.dilate(known.astype(np.uint8), kernel).astype(bool) & ~known
            if not rim.any():
                return z
            z = z.copy()
            z[rim] = self._farthest(z)[rim]
            known |= rim

    @staticmethod
    def _farthest(z):
        rows = np.maximum(z, np.maximum(np.roll(np.pad(z, 1), 1, 0), np.roll(np.pad(z, 1), -1, 0))[1:-1, 1:-1])
        p = np.pad(rows, ((0, 0), (1, 1)))
        return np.maximum(np.maximum(p[:, :-2], p[:, 2:]), rows)


def f6(depth_metric: np.ndarray) -> np.ndarray:
    return _Filler()(np.asarray(depth_metric))


# 7. chessboard distance says the round, then one pass per round
def f7(depth_metric):
    with np.errstate(invalid="ignore"):
        hole = ~((depth_metric > 0.01) & (depth_metric < 10))
    rounds = np.rint(cv2.distanceTransform(hole.astype(np.uint8), cv2.DIST_C, 3)).astype(int)
    out = np.where(hole, 0, depth_metric).astype(np.float32)
    for r in range(1, rounds.max() + 1):
        turn = rounds == r
        out[turn] = cv2.dilate(np.where(rounds < r, out, 0), np.ones((3, 3)))[turn]
    return out


# 8. recursion and one line per round
def f8(depth_metric):
    go = lambda d: d if d.all() else go(np.where(d, d, cv2.dilate(d, np.ones((3, 3), np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0)))
    import sys
    if max(depth_metric.shape) > sys.getrecursionlimit() // 3:
        return f1(depth_metric)
    return go(np.where((depth_metric > .01) & (depth_metric < 10), depth_metric, 0).astype(np.float64))


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
