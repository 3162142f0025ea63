"""Right answers to find_all_objects, as strangers wrote them."""
from collections import deque
from dataclasses import dataclass

import cv2
import numpy as np


def _mask(hsv, low, high):
    h, s, v = hsv[..., 0], hsv[..., 1], hsv[..., 2]
    if low[0] <= high[0]:
        hue = (h >= low[0]) & (h <= high[0])
    else:
        hue = (h >= low[0]) | (h <= high[0])
    return hue & (s >= low[1]) & (s <= high[1]) & (v >= low[2]) & (v <= high[2])


# 1. connected components with statistics
def objects_stats(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        mask = _mask(hsv, low, high).astype(np.uint8)
        _, _, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
        for left, top, width, height, area in stats[1:].tolist():
            if area >= min_area:
                found.append((area, name, (left, top, width, height)))
    found.sort(key=lambda o: -o[0])
    return [o[1] for o in found], [o[0] for o in found], [o[2] for o in found]


# 2. beginner: flood with a stack
def objects_beginner(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    height, width = hsv.shape[0], hsv.shape[1]
    names = []
    areas = []
    boxes = []
    for color_range in color_ranges:
        name = color_range[0]
        low = color_range[1]
        high = color_range[2]
        todo = np.zeros((height, width), dtype=bool)
        for y in range(height):
            for x in range(width):
                h, s, v = int(hsv[y, x, 0]), int(hsv[y, x, 1]), int(hsv[y, x, 2])
                ok = low[1] <= s <= high[1] and low[2] <= v <= high[2]
                if low[0] > high[0]:
                    ok = ok and (h >= low[0] or h <= high[0])
                else:
                    ok = ok and (low[0] <= h <= high[0])
                todo[y, x] = ok
        for y in range(height):
            for x in range(width):
                if not todo[y, x]:
                    continue
                stack = [(y, x)]
                todo[y, x] = False
                pixels = []
                while stack:
                    a, b = stack.pop()
                    pixels.append((a, b))
                    for da in (-1, 0, 1):
                        for db in (-1, 0, 1):
                            r, c = a + da, b + db
                            if 0 <= r < height and 0 <= c < width and todo[r, c]:
                                todo[r, c] = False
                                stack.append((r, c))
                if len(pixels) < min_area:
                    continue
                rows = [p[0] for p in pixels]
                columns = [p[1] for p in pixels]
                box = (min(columns), min(rows), max(columns) - min(columns) + 1,
                       max(rows) - min(rows) + 1)
                # insert where it belongs: the largest first
                place = 0
                while place < len(areas) and areas[place] >= len(pixels):
                    place += 1
                names.insert(place, name)
                areas.insert(place, len(pixels))
                boxes.insert(place, box)
    return names, areas, boxes


# 3. contours, filled, because no object has holes
def objects_contours(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    rows = []
    for name, low, high in color_ranges:
        parts = [(low, high)]
        if low[0] > high[0]:
            parts = [(low, (179, *high[1:])), ((0, *low[1:]), high)]
        mask = np.zeros(hsv.shape[:2], np.uint8)
        for a, b in parts:
            mask = cv2.bitwise_or(mask, cv2.inRange(hsv, np.array(a), np.array(b)))
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        for k in range(len(contours)):
            filled = cv2.drawContours(np.zeros_like(mask), contours, k, 255, cv2.FILLED)
            area = cv2.countNonZero(filled)
            if area >= min_area:
                rows.append((name, area, tuple(cv2.boundingRect(contours[k]))))
    rows = sorted(rows, key=lambda row: row[1], reverse=True)
    names, areas, boxes = (list(c) for c in zip(*rows)) if rows else ([], [], [])
    return names, areas, boxes


# 4. labels with bincount and minimum.at
def objects_bincount(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(np.ascontiguousarray(rgb_image[..., ::-1]), cv2.COLOR_BGR2HSV)
    everything = []
    for name, low, high in color_ranges:
        n, labels = cv2.connectedComponents(_mask(hsv, low, high).astype(np.uint8) * 255)
        area = np.bincount(labels.ravel(), minlength=n)
        y, x = np.indices(labels.shape)
        lo_x, lo_y = np.full(n, 10**6), np.full(n, 10**6)
        hi_x, hi_y = np.full(n, -1), np.full(n, -1)
        np.minimum.at(lo_x, labels, x)
        np.minimum.at(lo_y, labels, y)
        np.maximum.at(hi_x, labels, x)
        np.maximum.at(hi_y, labels, y)
        for i in range(1, n):
            if not area[i] < min_area:
                everything.append((name, int(area[i]), [int(lo_x[i]), int(lo_y[i]),
                                                        int(hi_x[i] - lo_x[i] + 1),
                                                        int(hi_y[i] - lo_y[i] + 1)]))
    order = np.argsort([-o[1] for o in everything], kind="stable").astype(int)
    return tuple([everything[i][field] for i in order] for field in range(3))


# 5. Java: union-find
@dataclass
class Blob:
    color: str
    area: int = 0
    left: int = 1 << 30
    top: int = 1 << 30
    right: int = -1
    bottom: int = -1

    def add(self, x, y):
        self.area += 1
        self.left, self.right = min(self.left, x), max(self.right, x)
        self.top, self.bottom = min(self.top, y), max(self.bottom, y)

    def box(self):
        return (self.left, self.top, self.right - self.left + 1, self.bottom - self.top + 1)


class UnionFind:
    def __init__(self):
        self.parent = {}

    def find(self, a):
        self.parent.setdefault(a, a)
        while self.parent[a] != a:
            self.parent[a] = self.parent[self.parent[a]]
            a = self.parent[a]
        return a

    def join(self, a, b):
        self.parent[self.find(a)] = self.find(b)


def objects_java(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    blobs = []
    for name, low, high in color_ranges:
        pixels = {(int(x), int(y)) for y, x in np.argwhere(_mask(hsv, low, high))}
        sets = UnionFind()
        for x, y in pixels:
            sets.find((x, y))
            for other in ((x - 1, y), (x - 1, y - 1), (x, y - 1), (x + 1, y - 1)):
                if other in pixels:
                    sets.join((x, y), other)
        groups = {}
        for x, y in pixels:
            groups.setdefault(sets.find((x, y)), Blob(name)).add(x, y)
        blobs.extend(b for b in groups.values() if b.area >= min_area)
    blobs.sort(key=lambda b: b.area, reverse=True)
    return [b.color for b in blobs], [b.area for b in blobs], [b.box() for b in blobs]


# 6. floodFill paints one object after the other
def objects_floodfill(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    objects = []
    for name, low, high in color_ranges:
        mask = np.uint8(255) * _mask(hsv, low, high).astype(np.uint8)
        while True:
            where = np.flatnonzero(mask.ravel() == 255)
            if where.size == 0:
                break
            row, col = divmod(int(where[0]), mask.shape[1])
            area, _, _, rect = cv2.floodFill(mask, None, (col, row), 0, flags=8)
            if area >= min_area:
                objects.append((int(area), len(objects), name, tuple(int(a) for a in rect)))
    objects.sort(reverse=True)
    return ([o[2] for o in objects], [o[0] for o in objects], [o[3] for o in objects])


# 7. queue, R-like data frame as dict of columns
def objects_queue(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(int)
    frame = {"name": [], "area": [], "box": []}
    for name, low, high in color_ranges:
        width = (high[0] - low[0]) % 180 if low[0] > high[0] else high[0] - low[0]
        hue = (hsv[..., 0] - low[0]) % 180 <= width if low[0] > high[0] else (
            (hsv[..., 0] >= low[0]) & (hsv[..., 0] <= high[0]))
        rest = np.all((hsv[..., 1:] >= low[1:]) & (hsv[..., 1:] <= high[1:]), axis=2)
        open_pixels = set(map(tuple, np.argwhere(hue & rest).tolist()))
        while open_pixels:
            queue = deque([open_pixels.pop()])
            region = []
            while queue:
                r, c = queue.popleft()
                region.append((r, c))
                for near in [(r + i, c + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]:
                    if near in open_pixels:
                        open_pixels.remove(near)
                        queue.append(near)
            if len(region) >= min_area:
                region = np.array(region)
                (top, left), (bottom, right) = region.min(0), region.max(0)
                frame["name"].append(name)
                frame["area"].append(len(region))
                frame["box"].append((left, top, right - left + 1, bottom - top + 1))
    order = sorted(range(len(frame["area"])), key=frame["area"].__getitem__)[::-1]
    return tuple([frame[column][i] for i in order] for column in ("name", "area", "box"))


ANSWERS = [objects_stats, objects_beginner, objects_contours, objects_bincount, objects_java,
           objects_floodfill, objects_queue]
