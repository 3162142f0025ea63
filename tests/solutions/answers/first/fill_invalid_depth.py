"""Right answers to fill_invalid_depth, as strangers wrote them."""
import cv2
import numpy as np


def with_dilate(depth_metric):
    """cv2.dilate with 3x3 ones: invalid pixels hold 0, so the largest neighbor is the farthest."""
    depth = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, 0).astype(np.float32)
    while (depth == 0).any():
        grown = cv2.dilate(depth, np.ones((3, 3), np.uint8))
        depth = np.where(depth == 0, grown, depth)
    return depth


def with_padding(depth_metric):
    """np.pad and the maximum of nine shifted pictures per round."""
    out = np.array(depth_metric, dtype=np.float32)
    valid = (out > 0.01) & (out < 10)
    out[~valid] = -np.inf
    H, W = out.shape
    while not valid.all():
        padded = np.pad(out, 1, constant_values=-np.inf)
        best = np.max([padded[i:i + H, j:j + W] for i in range(3) for j in range(3)], axis=0)
        out = np.where(valid, out, best)
        valid = out > 0
    return out.astype(np.float32)


def wave_front(depth_metric):
    """Pure Python: a list of filled pixels per round, only their neighbors are looked at next."""
    H, W = depth_metric.shape
    grid = [[float(z) if 0.01 < float(z) < 10 else None for z in row] for row in depth_metric]

    def around(r, c):
        for i in (r - 1, r, r + 1):
            for j in (c - 1, c, c + 1):
                if (i, j) != (r, c) and 0 <= i < H and 0 <= j < W:
                    yield i, j

    front = [(r, c) for r in range(H) for c in range(W) if grid[r][c] is not None]
    while front:
        candidates = {}
        for r, c in front:
            for i, j in around(r, c):
                if grid[i][j] is None:
                    candidates[i, j] = max(candidates.get((i, j), 0.0), grid[r][c])
        for (i, j), z in candidates.items():
            grid[i][j] = z
        front = list(candidates)
    result = np.array(depth_metric, dtype=np.float32)
    for r in range(H):
        for c in range(W):
            result[r, c] = grid[r][c]
    return result


def sliding_windows(depth_metric):
    """sliding_window_view over a frame of NaN, looked at in the holes only; np.fmax as the maximum that skips NaN."""
    valid = np.isfinite(depth_metric)
    valid[valid] = (depth_metric[valid] > 0.01) & (depth_metric[valid] < 10)
    frame = np.full((depth_metric.shape[0] + 2, depth_metric.shape[1] + 2), np.nan, np.float32)
    inner = frame[1:-1, 1:-1]
    inner[valid] = depth_metric[valid]
    windows = np.lib.stride_tricks.sliding_window_view(frame, (3, 3))
    while np.isnan(inner).any():
        holes = np.isnan(inner)
        inner[holes] = np.fmax.reduce(windows[holes].reshape(-1, 9), axis=1)
    return inner.copy()


def only_the_holes(depth_metric):
    """Index arithmetic on the list of invalid pixels; each round gathers their eight neighbors."""
    H, W = depth_metric.shape
    d = np.zeros((H + 2, W + 2), dtype=np.float64)
    ok = np.logical_and(np.greater(depth_metric, 0.01), np.less(depth_metric, 10.0))
    d[1:-1, 1:-1][ok] = depth_metric[ok]
    rows, columns = np.nonzero(~ok)
    rows, columns = rows + 1, columns + 1
    steps = [(-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)]
    while rows.size:
        around = np.stack([d[rows + i, columns + j] for i, j in steps])
        best = around.max(axis=0)
        new = best > 0
        d[rows[new], columns[new]] = best[new]
        rows, columns = rows[~new], columns[~new]
    return d[1:-1, 1:-1].astype(np.float32)


class _Filler:
    def __init__(self, depth):
        self.depth = np.copy(depth).astype(np.float32)
        self.bad = ~((self.depth > 0.01) & (self.depth < 10.0))
        self.depth[self.bad] = 0.0

    def round(self):
        wide = cv2.copyMakeBorder(self.depth, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0.0)
        line = np.maximum(np.maximum(wide[:-2], wide[1:-1]), wide[2:])
        square = np.maximum(np.maximum(line[:, :-2], line[:, 1:-1]), line[:, 2:])
        self.depth[self.bad] = square[self.bad]
        self.bad &= square <= 0.0

    def run(self, max_rounds):
        for _ in range(max_rounds):
            if not self.bad.any():
                break
            self.round()
        return self.depth


def with_a_class(depth_metric, max_rounds=None):
    """A class; the 3x3 maximum in two passes, columns then rows; bounded number of rounds."""
    if max_rounds is None:
        max_rounds = sum(depth_metric.shape)
    return _Filler(depth_metric).run(max_rounds)


def by_rings(depth_metric):
    """First the round of every pixel (steps to the next valid one), then ring by ring from inside the loop over pixels."""
    z = np.asarray(depth_metric, dtype=np.float32)
    valid = (z > np.float32(0.01)) & (z < np.float32(10))
    ring = np.where(valid, 0, -1)
    k, known = 0, valid.copy()
    while not known.all():
        k += 1
        wider = cv2.dilate(known.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        ring[wider & ~known] = k
        known = wider
    out = z.copy()
    for n in range(1, k + 1):
        for r, c in np.argwhere(ring == n):
            r0, c0 = max(r - 1, 0), max(c - 1, 0)
            part, rings = out[r0:r + 2, c0:c + 2], ring[r0:r + 2, c0:c + 2]
            out[r, c] = part[rings < n].max()
    return out


ANSWERS = [with_dilate, with_padding, wave_front, sliding_windows, only_the_holes, with_a_class, by_rings]
