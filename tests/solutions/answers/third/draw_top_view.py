"""Right answers to draw_top_view, as strangers wrote them."""
import math

import cv2
import numpy as np


# 1. sort by height, the last write wins
def top_sorted(points_world, colors, low, high, pixels_per_meter):
    H, W = np.rint((np.asarray(high, float) - low) * pixels_per_meter).astype(int)
    picture = np.zeros((H, W, 3), np.uint8)
    rows = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter).astype(int)
    cols = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter).astype(int)
    keep = (rows >= 0) & (rows < H) & (cols >= 0) & (cols < W)
    rows, cols = rows[keep], cols[keep]
    order = np.argsort(points_world[keep, 2], kind="stable")
    picture[rows[order], cols[order]] = np.rint(255 * colors[keep][order])
    return picture


# 2. beginner, z-buffer with loops
def top_beginner(points_world, colors, low, high, pixels_per_meter):
    number_of_rows = int(round(float(high[0] - low[0]) * pixels_per_meter))
    number_of_columns = int(round(float(high[1] - low[1]) * pixels_per_meter))
    picture = np.zeros((number_of_rows, number_of_columns, 3), dtype=np.uint8)
    highest = np.full((number_of_rows, number_of_columns), -math.inf)
    for i in range(len(points_world)):
        x = points_world[i][0]
        y = points_world[i][1]
        z = points_world[i][2]
        row = math.floor((high[0] - x) * pixels_per_meter)
        column = math.floor((high[1] - y) * pixels_per_meter)
        if row < 0 or row >= number_of_rows:
            continue
        if column < 0 or column >= number_of_columns:
            continue
        if z > highest[row, column]:
            highest[row, column] = z
            for c in range(3):
                picture[row, column, c] = int(colors[i][c] * 255)
    return picture


# 3. Java habits: a map from cell to the highest point
class _Cell:
    def __init__(self):
        self.z = float("-inf")
        self.color = (0, 0, 0)

    def offer(self, z, color):
        if z >= self.z:
            self.z, self.color = z, color


def top_java(points_world, colors, low, high, pixels_per_meter):
    if len(points_world) != len(colors):
        raise ValueError("one color per point")
    height = round(float((high[0] - low[0]) * pixels_per_meter))
    width = round(float((high[1] - low[1]) * pixels_per_meter))
    cells = {}
    for (x, y, z), color in zip(points_world.tolist(), colors.tolist()):
        key = (math.floor((float(high[0]) - x) * pixels_per_meter),
               math.floor((float(high[1]) - y) * pixels_per_meter))
        cells.setdefault(key, _Cell()).offer(z, color)
    picture = np.zeros((height, width, 3), dtype=np.uint8)
    for (row, column), cell in cells.items():
        if 0 <= row < height and 0 <= column < width:
            picture[row, column] = [min(255, int(255 * c + 0.5)) for c in cell.color]
    return picture


# 4. lexsort and unique: the first of each cell is the highest
def top_lexsort(points_world, colors, low, high, pixels_per_meter):
    low, high = np.asarray(low, np.float64), np.asarray(high, np.float64)
    shape = np.round((high - low) * pixels_per_meter).astype(np.int64)
    rc = np.floor((high - points_world[:, :2]) * pixels_per_meter).astype(np.int64)
    inside = np.all((rc >= 0) & (rc < shape), axis=1)
    flat = np.ravel_multi_index(tuple(rc[inside].T), tuple(shape))
    order = np.lexsort((-points_world[inside, 2], flat))
    cell, first = np.unique(flat[order], return_index=True)
    canvas = np.zeros((shape[0] * shape[1], 3), np.uint8)
    canvas[cell] = (colors[inside][order][first] * 255).astype(np.uint8)
    return canvas.reshape(shape[0], shape[1], 3)


# 5. maximum.at, then write those that reach the maximum
def top_maximum_at(points_world, colors, low, high, pixels_per_meter):
    H = int(np.round((high[0] - low[0]) * pixels_per_meter))
    W = int(np.round((high[1] - low[1]) * pixels_per_meter))
    x, y, z = points_world.T
    r = np.floor((high[0] - x) * pixels_per_meter)
    c = np.floor((high[1] - y) * pixels_per_meter)
    ok = np.logical_and.reduce([r > -1, r < H, c > -1, c < W])
    r, c = r[ok].astype(np.intp), c[ok].astype(np.intp)
    z, paint = z[ok], colors[ok]
    top = np.full((H, W), -np.inf)
    np.maximum.at(top, (r, c), z)
    wins = z == top[r, c]
    image = np.zeros((H, W, 3))
    image[r[wins], c[wins]] = paint[wins]
    return np.uint8(np.round(255 * image))


# 6. the painter: from low to high, one generator, set pixels via a memory view
def top_painter(points_world, colors, low, high, pixels_per_meter):
    height, width = (int(np.floor((b - a) * pixels_per_meter + 0.5))
                     for a, b in zip(low, high))
    image = np.zeros((height, width, 3), np.uint8)
    if image.size == 0:
        return image
    view = memoryview(image)

    def pixels():
        for i in sorted(range(len(points_world)), key=lambda i: points_world[i, 2]):
            yield (i, math.floor((high[0] - points_world[i, 0]) * pixels_per_meter),
                   math.floor((high[1] - points_world[i, 1]) * pixels_per_meter))

    for i, r, c in pixels():
        if r in range(height) and c in range(width):
            for k in range(3):
                view[r, c, k] = round(float(255 * colors[i, k]))
    return image


# 7. R habits: split points by cell (tapply), OpenCV for bytes
def top_grouped(points_world, colors, low, high, pixels_per_meter):
    H, W = (int(np.rint(s)) for s in (np.array(high) - np.array(low)) * pixels_per_meter)
    rgb = np.zeros((H, W, 3), np.float64)
    cells = np.floor((np.array(high) - points_world[:, :2]) * pixels_per_meter)
    groups, which = np.unique(cells, axis=0, return_inverse=True)
    which = which.reshape(-1)
    for g, (r, c) in enumerate(groups):
        if not (0 <= r < H and 0 <= c < W):
            continue
        members = np.flatnonzero(which == g)
        best = members[np.argmax(points_world[members, 2])]
        rgb[int(r), int(c)] = colors[best]
    if rgb.size == 0:
        return rgb.astype(np.uint8)
    return cv2.convertScaleAbs(rgb, alpha=255.0)


ANSWERS = [top_sorted, top_beginner, top_java, top_lexsort, top_maximum_at,
           top_painter, top_grouped]
