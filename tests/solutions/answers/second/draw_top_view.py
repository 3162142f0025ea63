"""Right answers to draw_top_view, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1. sort by height, draw in that order
def f1(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((high - low) * pixels_per_meter).astype(int)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    inside = (row >= 0) & (row < H) & (col >= 0) & (col < W)
    order = np.argsort(points_world[inside, 2], kind="stable")
    picture = np.zeros((H, W, 3), np.uint8)
    picture[row[inside][order], col[inside][order]] = np.round(255 * colors[inside][order])
    return picture


# 2. C programmer with a height buffer
def f2(points_world, colors, low, high, pixels_per_meter):
    H = int(math.floor((high[0] - low[0]) * pixels_per_meter + 0.5))
    W = int(math.floor((high[1] - low[1]) * pixels_per_meter + 0.5))
    buffer = np.full((H, W), -math.inf)
    out = np.zeros((H, W, 3), dtype=np.uint8)
    for i in range(len(points_world)):
        x, y, z = points_world[i]
        r = math.floor((high[0] - x) * pixels_per_meter)
        c = math.floor((high[1] - y) * pixels_per_meter)
        if r < 0 or c < 0 or r >= H or c >= W:
            continue
        if z > buffer[r, c]:
            buffer[r, c] = z
            for k in range(3):
                out[r, c, k] = int(255 * colors[i, k])
    return out


# 3. lexsort by pixel and height, the first of each pixel
def f3(points_world, colors, low, high, pixels_per_meter):
    size = np.round((np.asarray(high, float) - low) * pixels_per_meter).astype(np.int64)
    rc = np.floor((np.asarray(high) - points_world[:, :2]) * pixels_per_meter)
    ok = np.all((rc >= 0) & (rc < size), axis=1)
    flat = rc[ok].astype(np.int64) @ np.array([size[1], 1])
    order = np.lexsort((-points_world[ok, 2], flat))
    pixel, first = np.unique(flat[order], return_index=True)
    canvas = np.zeros((size[0] * size[1], 3), np.uint8)
    canvas[pixel] = np.ceil(255 * colors[ok][order][first])
    return canvas.reshape(size[0], size[1], 3)


# 4. np.maximum.at
def f4(points_world, colors, low, high, pixels_per_meter):
    H, W = (round(float(b - a) * pixels_per_meter) for a, b in zip(low, high))
    r, c = (np.floor((high[k] - points_world[:, k]) * pixels_per_meter) for k in (0, 1))
    keep = np.flatnonzero((0 <= r) & (r < H) & (0 <= c) & (c < W))
    r, c, z = r[keep].astype(int), c[keep].astype(int), points_world[keep, 2]
    top = np.full((H, W), -np.inf)
    np.maximum.at(top, (r, c), z)
    winners = z == top[r, c]
    image = np.zeros((H, W, 3))
    image[r[winners], c[winners]] = colors[keep[winners]]
    return (image * 255 + 0.5).astype(np.uint8)


# 5. over-engineered
@dataclass
class _Map:
    low: np.ndarray
    high: np.ndarray
    scale: int

    def __post_init__(self):
        if np.any(np.asarray(self.high) <= np.asarray(self.low)):
            raise ValueError("high must be above low")
        self.rows, self.cols = (int(np.rint((h - l) * self.scale)) for l, h in zip(self.low, self.high))
        self.cells = {}

    def cell(self, x, y):
        r = math.floor((self.high[0] - x) * self.scale)
        c = math.floor((self.high[1] - y) * self.scale)
        return (r, c) if 0 <= r < self.rows and 0 <= c < self.cols else None

    def add(self, point, color):
        cell = self.cell(point[0], point[1])
        if cell is not None and (cell not in self.cells or point[2] >= self.cells[cell][0]):
            self.cells[cell] = (point[2], color)

    def picture(self):
        out = np.zeros((self.rows, self.cols, 3), np.uint8)
        for cell, (_, color) in self.cells.items():
            out[cell] = np.rint(255 * np.asarray(color))
        return out


def f5(points_world, colors, low, high, pixels_per_meter):
    m = _Map(low, high, pixels_per_meter)
    for p, c in zip(points_world, colors):
        m.add(p, c)
    return m.picture()


# 6. from the highest down, each pixel once
def f6(points_world, colors, low, high, pixels_per_meter):
    shape = tuple(np.around((high - low) * pixels_per_meter).astype(int))
    out = np.zeros((*shape, 3), np.uint8)
    taken = np.zeros(shape, bool)
    for i in np.argsort(points_world[:, 2])[::-1]:
        rc = tuple(int(math.floor(a)) for a in (high - points_world[i, :2]) * pixels_per_meter)
        if min(rc) < 0 or rc[0] >= shape[0] or rc[1] >= shape[1] or taken[rc]:
            continue
        taken[rc] = True
        out[rc] = cv2.convertScaleAbs(np.ascontiguousarray(colors[i]).reshape(1, 3), alpha=255).ravel()
    return out


# 7. short
def f7(points_world, colors, low, high, pixels_per_meter):
    n = ((high - low) * pixels_per_meter + .5).astype(int)
    o = points_world[:, 2].argsort(kind="mergesort")
    ij = np.floor((high - points_world[o, :2]) * pixels_per_meter).astype(int)
    k = ((ij >= 0) & (ij < n)).all(1)
    (a := np.zeros((*n, 3), np.uint8))[tuple(ij[k].T)] = (colors[o][k] * 255).astype(np.uint8)
    return a


# 8. groups by reduceat, colors in float32
def f8(points_world, colors, low, high, pixels_per_meter):
    H, W = [int(s) for s in np.rint(np.multiply(np.subtract(high, low), pixels_per_meter))]
    row, col = np.floor(np.multiply(np.subtract(high, points_world[:, :2]), pixels_per_meter)).astype(int).T
    good = np.isin(row, np.arange(H)) & np.isin(col, np.arange(W))
    out = np.zeros((H, W, 3), np.float32)
    if good.any():
        key = (row * W + col)[good]
        order = np.argsort(key, kind="stable")
        key, z = key[order], points_world[good, 2][order]
        rgb = colors[good][order].astype(np.float32)
        starts = np.flatnonzero(np.r_[True, key[1:] != key[:-1]])
        highest = np.maximum.reduceat(z, starts)
        group = np.cumsum(np.r_[False, key[1:] != key[:-1]])
        best = z == highest[group]
        out.reshape(-1, 3)[key[best]] = rgb[best]
    return np.uint8(np.clip(np.float32(255) * out, 0, 255))


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
