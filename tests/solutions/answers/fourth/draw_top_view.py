"""Right answers to draw_top_view, as strangers wrote them."""
import math
from dataclasses import dataclass

import numpy as np


# 1. sort by height, let later ones win
def f1(points_world, colors, low, high, pixels_per_meter):
    H, W = np.round((high - low) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    order = np.argsort(points_world[:, 2], kind="stable")
    rows = np.floor((high[0] - points_world[order, 0]) * pixels_per_meter).astype(int)
    cols = np.floor((high[1] - points_world[order, 1]) * pixels_per_meter).astype(int)
    ok = (rows >= 0) & (rows < H) & (cols >= 0) & (cols < W)
    picture[rows[ok], cols[ok]] = (255 * colors[order][ok]).astype(np.uint8)
    return picture


# 2. loops and a height map
def f2(points_world, colors, low, high, pixels_per_meter):
    height = int(round(float(high[0] - low[0]) * pixels_per_meter))
    width = int(round(float(high[1] - low[1]) * pixels_per_meter))
    picture = np.zeros((height, width, 3), dtype=np.uint8)
    highest = {}
    for i in range(len(points_world)):
        x, y, z = points_world[i]
        row = math.floor((high[0] - x) * pixels_per_meter)
        col = math.floor((high[1] - y) * pixels_per_meter)
        if row < 0 or row >= height or col < 0 or col >= width:
            continue
        if (row, col) not in highest or z > highest[row, col]:
            highest[row, col] = z
            picture[row, col] = [int(round(255 * c)) for c in colors[i]]
    return picture


# 3. lexsort and unique
def f3(points_world, colors, low, high, pixels_per_meter):
    shape = np.rint((np.asarray(high, float) - low) * pixels_per_meter).astype(int)
    rc = np.floor((high - points_world[:, :2]) * pixels_per_meter)
    keep = ((rc >= 0) & (rc < shape)).all(axis=1)
    rc, z, c = rc[keep].astype(int), points_world[keep, 2], colors[keep]
    flat = rc[:, 0] * shape[1] + rc[:, 1]
    order = np.lexsort((-z, flat))
    cells, first = np.unique(flat[order], return_index=True)
    out = np.zeros((shape[0] * shape[1], 3), np.uint8)
    out[cells] = np.rint(c[order][first] * 255)
    return out.reshape(*shape, 3)


# 4. np.maximum.at: a z-buffer, as on a graphics card
def f4(points_world, colors, low, high, pixels_per_meter):
    x, y, z = points_world.T
    H, W = (int(n + 0.5) for n in (high - low) * pixels_per_meter)
    i = np.floor((high[0] - x) * pixels_per_meter).astype(np.int64)
    j = np.floor((high[1] - y) * pixels_per_meter).astype(np.int64)
    on = (0 <= i) & (i < H) & (0 <= j) & (j < W)
    i, j, z, rgb = i[on], j[on], z[on], colors[on]
    zbuf = np.full((H, W), -np.inf)
    np.maximum.at(zbuf, (i, j), z)
    top = z == zbuf[i, j]
    image = np.zeros((H, W, 3))
    image[i[top], j[top]] = rgb[top]
    return np.clip(image * 255 + 0.5, 0, 255).astype(np.uint8)


# 5. group by, pandas style
def f5(points_world, colors, low, high, pixels_per_meter):
    rows, cols = [int(round(float(k))) for k in (high - low) * pixels_per_meter]
    groups = {}
    for p, c in zip(points_world, colors):
        cell = tuple(np.floor((high - p[:2]) * pixels_per_meter).astype(int).tolist())
        groups.setdefault(cell, []).append((float(p[2]), c))
    picture = np.zeros((rows, cols, 3), np.uint8)
    for (r, k), members in groups.items():
        if 0 <= r < rows and 0 <= k < cols:
            picture[r, k] = np.round(255 * max(members, key=lambda m: m[0])[1])
    return picture


# 6. class; floor with // 1
@dataclass(frozen=True)
class TopMap:
    low: np.ndarray
    high: np.ndarray
    scale: int

    def __post_init__(self):
        if not np.all(np.asarray(self.high) > np.asarray(self.low)):
            raise ValueError("high must be above low")

    @property
    def shape(self):
        return tuple(int(n) for n in np.round((self.high - self.low) * self.scale))

    def cell(self, p):
        return tuple(int((self.high[k] - p[k]) * self.scale // 1) for k in (0, 1))

    def has(self, cell):
        return all(0 <= c < n for c, n in zip(cell, self.shape))


def f6(points_world, colors, low, high, pixels_per_meter):
    m = TopMap(low, high, pixels_per_meter)
    image = np.zeros((*m.shape, 3), np.uint8)
    for i in sorted(range(len(points_world)), key=lambda i: points_world[i, 2]):
        cell = m.cell(points_world[i])
        if m.has(cell):
            image[cell] = np.uint8(colors[i] * 255)
    return image


# 7. from the top down; first come wins; ceil
def f7(points_world, colors, low, high, pixels_per_meter):
    h, w = np.round((high - low) * pixels_per_meter).astype(int)
    img = np.zeros((h, w, 3), np.uint8)
    taken = np.zeros((h, w), bool)
    shade = np.ceil(colors * 255).astype(np.uint8)
    for k in np.argsort(-points_world[:, 2]):
        r, c = np.floor((high - points_world[k, :2]) * pixels_per_meter)
        if 0 <= r < h and 0 <= c < w and not taken[int(r), int(c)]:
            taken[int(r), int(c)] = True
            img[int(r), int(c)] = shade[k]
    return img


ANSWERS = [f1, f2, f3, f4, f5, f6, f7]
