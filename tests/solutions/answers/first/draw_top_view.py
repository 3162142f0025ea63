"""Right answers to draw_top_view, as strangers wrote them."""
import math

import numpy as np


def _size(low, high, ppm):
    return (int(round(float((high[0] - low[0]) * ppm))), int(round(float((high[1] - low[1]) * ppm))))


def painter(points_world, colors, low, high, pixels_per_meter):
    """Sort by height, low ones first, and let the last assignment win."""
    H, W = _size(low, high, pixels_per_meter)
    row = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter)
    col = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter)
    inside = (row >= 0) & (row < H) & (col >= 0) & (col < W)
    order = np.argsort(points_world[inside, 2], kind="stable")
    r = row[inside].astype(int)[order]
    c = col[inside].astype(int)[order]
    image = np.zeros((H, W, 3), np.uint8)
    image[r, c] = np.rint(255 * colors[inside][order]).astype(np.uint8)
    return image


def plain_loops(points_world, colors, low, high, pixels_per_meter):
    """One loop with a height map; of equal heights the first one stays; halves go up."""
    H, W = _size(low, high, pixels_per_meter)
    image = np.zeros((H, W, 3), dtype=np.uint8)
    top = [[-math.inf] * W for _ in range(H)]
    for p, c in zip(points_world, colors):
        row = math.floor((high[0] - p[0]) * pixels_per_meter)
        col = math.floor((high[1] - p[1]) * pixels_per_meter)
        if 0 <= row < H and 0 <= col < W and p[2] > top[row][col]:
            top[row][col] = p[2]
            image[row, col] = [int(math.floor(255 * k + 0.5)) for k in c]
    return image


def last_of_equals(points_world, colors, low, high, pixels_per_meter):
    """Dictionary of the best point per pixel; of equal heights the last wins; halves to even."""
    H, W = _size(low, high, pixels_per_meter)
    best = {}
    for i in range(len(points_world)):
        x, y, z = (float(a) for a in points_world[i])
        key = (math.floor((float(high[0]) - x) * pixels_per_meter),
               math.floor((float(high[1]) - y) * pixels_per_meter))
        if key not in best or z >= points_world[best[key], 2]:
            best[key] = i
    image = np.zeros((H, W, 3), dtype=np.uint8)
    for (row, col), i in best.items():
        if row in range(H) and col in range(W):
            image[row, col] = [round(255 * float(k)) for k in colors[i]]
    return image


def maximum_at(points_world, colors, low, high, pixels_per_meter):
    """np.maximum.at makes the height map, then the points that equal it are drawn."""
    rows = int(np.rint((high[0] - low[0]) * pixels_per_meter))
    columns = int(np.rint((high[1] - low[1]) * pixels_per_meter))
    ij = np.floor((np.asarray(high) - points_world[:, :2]) * pixels_per_meter)
    ok = ((ij >= 0) & (ij < [rows, columns])).all(axis=1)
    i, j = ij[ok].astype(np.intp).T
    z = points_world[ok, 2]
    top = np.full((rows, columns), -np.inf)
    np.maximum.at(top, (i, j), z)
    seen = z == top[i, j]
    image = np.zeros((rows, columns, 3), np.uint8)
    image[i[seen], j[seen]] = (colors[ok][seen] * 255.0).round().astype(np.uint8)
    return image


def unique_of_flat_numbers(points_world, colors, low, high, pixels_per_meter):
    """lexsort by pixel and height, np.unique picks the first of each pixel."""
    H, W = (int(np.floor((high[k] - low[k]) * pixels_per_meter + 0.5)) for k in (0, 1))
    a = np.floor((high[0] - points_world[:, 0]) * pixels_per_meter)
    b = np.floor((high[1] - points_world[:, 1]) * pixels_per_meter)
    use = np.flatnonzero((a > -1) & (b > -1) & (a < H) & (b < W))
    flat = a[use].astype(np.int64) * W + b[use].astype(np.int64)
    order = np.lexsort((-points_world[use, 2], flat))
    pixel, first = np.unique(flat[order], return_index=True)
    canvas = np.zeros((H * W, 3), dtype=np.uint8)
    canvas[pixel] = np.floor(255 * colors[use[order[first]]] + 0.5).astype(np.uint8)
    return canvas.reshape(H, W, 3)


class _Map:
    def __init__(self, low, high, scale):
        self.high, self.scale = [float(h) for h in high], scale
        self.shape = tuple(int(round((float(h) - float(l)) * scale)) for l, h in zip(low, high))
        self.pixels = [[(0, 0, 0)] * self.shape[1] for _ in range(self.shape[0])]
        self.heights = {}

    def add(self, point, color):
        place = tuple(math.floor((h - float(q)) * self.scale) for h, q in zip(self.high, point))
        if not all(0 <= k < n for k, n in zip(place, self.shape)):
            return
        if place in self.heights and self.heights[place] > point[2]:
            return
        self.heights[place] = point[2]
        self.pixels[place[0]][place[1]] = tuple(int(round(255.0 * float(k))) for k in color)

    def draw(self):
        return np.array(self.pixels, dtype=np.uint8).reshape(self.shape + (3,))


def with_a_class(points_world, colors, low, high, pixels_per_meter):
    """A map class with nested lists of tuples, an array only at the end."""
    top_view = _Map(low, high, pixels_per_meter)
    for point, color in zip(points_world, colors):
        top_view.add(point, color)
    return top_view.draw()


def float32_colors(points_world, colors, low, high, pixels_per_meter):
    """Colors rounded in float32 up front, places in float64; heights from the top down, first wins."""
    H, W = _size(low, high, pixels_per_meter)
    bytes_ = np.clip(np.around(np.float32(255) * colors.astype(np.float32)), 0, 255).astype(np.uint8)
    place = np.floor((high - points_world[:, :2]) * pixels_per_meter)
    image = np.zeros((H, W, 3), np.uint8)
    taken = np.zeros((H, W), bool)
    for k in np.argsort(-points_world[:, 2]):
        r, c = place[k]
        if 0 <= r < H and 0 <= c < W and not taken[int(r), int(c)]:
            taken[int(r), int(c)] = True
            image[int(r), int(c)] = bytes_[k]
    return image


def limits_also_in_meters(points_world, colors, low, high, pixels_per_meter):
    """Reads "outside the map" in meters too: beyond low or high is out even where the rounding of the size leaves room."""
    H, W = _size(low, high, pixels_per_meter)
    image = np.zeros((H, W, 3), np.uint8)
    xy = points_world[:, :2]
    keep = np.all((xy >= low) & (xy <= high), axis=1)
    rc = np.floor((high - xy) * pixels_per_meter)
    keep &= (rc[:, 0] < H) & (rc[:, 1] < W)
    p, c, rc = points_world[keep], colors[keep], rc[keep].astype(int)
    for k in np.argsort(p[:, 2], kind="mergesort"):
        image[rc[k, 0], rc[k, 1]] = np.round(c[k] * 255)
    return image


ANSWERS = [painter, plain_loops, last_of_equals, maximum_at, unique_of_flat_numbers,
           with_a_class, float32_colors, limits_also_in_meters]
