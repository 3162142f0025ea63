"""Right answers to find_all_objects, as strangers wrote them."""
from collections import deque
from dataclasses import dataclass, field

import cv2
import numpy as np


def _in_range(hsv, low, high):
    h, s, v = hsv[..., 0], hsv[..., 1], hsv[..., 2]
    hue = (h >= low[0]) & (h <= high[0]) if low[0] <= high[0] else (h >= low[0]) | (h <= high[0])
    return hue & (s >= low[1]) & (s <= high[1]) & (v >= low[2]) & (v <= high[2])


# 1. connectedComponentsWithStats
def f1(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        if low[0] <= high[0]:
            mask = cv2.inRange(hsv, tuple(low), tuple(high))
        else:
            mask = (cv2.inRange(hsv, tuple(low), (179, high[1], high[2]))
                    | cv2.inRange(hsv, (0, low[1], low[2]), tuple(high)))
        n, _, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
        for i in range(1, n):
            left, top, width, height, area = (int(x) for x in stats[i])
            if area >= min_area:
                found.append((name, area, (left, top, width, height)))
    found.sort(key=lambda item: item[1], reverse=True)
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


# 2. NumPy integers, boxes as lists, argsort
def f2(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    names, areas, boxes = [], [], []
    for name, low, high in color_ranges:
        mask = _in_range(hsv, low, high).astype(np.uint8)
        _, labels = cv2.connectedComponents(mask, connectivity=8)
        sizes = np.bincount(labels.ravel())
        for k in np.flatnonzero(sizes[1:] >= min_area) + 1:
            rows, cols = np.nonzero(labels == k)
            names.append(name)
            areas.append(sizes[k])
            boxes.append([cols.min(), rows.min(), np.ptp(cols) + 1, np.ptp(rows) + 1])
    order = np.argsort(-np.array(areas, dtype=int), kind="stable")
    return [names[i] for i in order], [areas[i] for i in order], [boxes[i] for i in order]


# 3. C programmer: flood with an own stack
def f3(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    H, W = hsv.shape[:2]
    objects = []
    for number, (name, low, high) in enumerate(color_ranges):
        todo = _in_range(hsv, low, high)
        for y in range(H):
            for x in range(W):
                if not todo[y, x]:
                    continue
                todo[y, x] = False
                stack = [(y, x)]
                area, x0, x1, y0, y1 = 0, x, x, y, y
                while stack:
                    j, i = stack.pop()
                    area += 1
                    x0, x1, y0, y1 = min(x0, i), max(x1, i), min(y0, j), max(y1, j)
                    for b in range(max(j - 1, 0), min(j + 2, H)):
                        for a in range(max(i - 1, 0), min(i + 2, W)):
                            if todo[b, a]:
                                todo[b, a] = False
                                stack.append((b, a))
                if area >= min_area:
                    objects.append((-area, number, len(objects), name,
                                    (x0, y0, x1 - x0 + 1, y1 - y0 + 1)))
    objects.sort()
    return [o[3] for o in objects], [-o[0] for o in objects], [o[4] for o in objects]


# 4. contours, filled to count the pixels (no object has holes)
def f4(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    out = []
    for name, low, high in color_ranges:
        mask = np.where(_in_range(hsv, low, high), 255, 0).astype(np.uint8)
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        for i in range(len(contours)):
            canvas = np.zeros_like(mask)
            cv2.drawContours(canvas, contours, i, 255, cv2.FILLED)
            area = cv2.countNonZero(canvas)
            if not area < min_area:
                out.append((area, name, tuple(cv2.boundingRect(contours[i]))))
    out.sort(key=lambda o: -o[0])
    names, areas, boxes = ([o[k] for o in out] for k in (1, 0, 2))
    return names, areas, boxes


# 5. over-engineered, queue
@dataclass
class _Region:
    name: str
    pixels: list = field(default_factory=list)

    @property
    def area(self):
        return len(self.pixels)

    @property
    def box(self):
        rows, cols = zip(*self.pixels)
        return (min(cols), min(rows), max(cols) - min(cols) + 1, max(rows) - min(rows) + 1)


class _Finder:
    def __init__(self, rgb):
        if rgb.dtype != np.uint8 or rgb.ndim != 3 or rgb.shape[2] != 3:
            raise ValueError("need an RGB picture of bytes")
        self.hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)

    def regions(self, name, low, high):
        left = set(zip(*(a.tolist() for a in np.nonzero(_in_range(self.hsv, low, high)))))
        while left:
            seed = left.pop()
            region, queue = _Region(name), deque([seed])
            while queue:
                y, x = queue.popleft()
                region.pixels.append((y, x))
                near = {(y + j, x + i) for j in (-1, 0, 1) for i in (-1, 0, 1)} & left
                left -= near
                queue.extend(near)
            yield region


def f5(rgb_image, color_ranges, min_area):
    finder = _Finder(rgb_image)
    keep = [r for args in color_ranges for r in finder.regions(*args) if r.area >= min_area]
    keep.sort(key=lambda r: r.area)
    keep.reverse()
    return [r.name for r in keep], [r.area for r in keep], [r.box for r in keep]


# 6. short
def f6(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    rows = [(int(s[4]), n, tuple(s[:4].tolist())) for n, a, b in color_ranges
            for s in cv2.connectedComponentsWithStats(np.uint8(_in_range(hsv, a, b)))[2][1:] if s[4] >= min_area]
    rows.sort(key=lambda r: (-r[0], r[1]))
    return [r[1] for r in rows], [r[0] for r in rows], [r[2] for r in rows]


# 7. run-length rows joined by union-find
def f7(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    result = []
    for name, low, high in color_ranges:
        mask = _in_range(hsv, low, high)
        edges = np.diff(np.pad(mask, ((0, 0), (1, 1))).astype(np.int8), axis=1)
        runs = [(int(y), int(a), int(b)) for (y, a), (_, b)
                in zip(np.argwhere(edges == 1), np.argwhere(edges == -1))]   # columns a .. b-1
        parent = list(range(len(runs)))

        def root(i):
            while parent[i] != i:
                parent[i] = parent[parent[i]]
                i = parent[i]
            return i

        by_row = {}
        for i, (y, a, b) in enumerate(runs):
            for j in by_row.get(y - 1, []):
                if runs[j][1] <= b and runs[j][2] >= a:
                    parent[root(i)] = root(j)
            by_row.setdefault(y, []).append(i)
        groups = {}
        for i, run in enumerate(runs):
            groups.setdefault(root(i), []).append(run)
        for group in groups.values():
            y, a, b = zip(*group)
            area = sum(b) - sum(a)
            if area >= min_area:
                result.append([name, area, (min(a), min(y), max(b) - min(a), max(y) - min(y) + 1)])
    result.sort(key=lambda r: r[1], reverse=True)
    return [r[0] for r in result], [r[1] for r in result], [r[2] for r in result]


# 8. labels spread by dilation of the largest number
def f8(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    H, W = hsv.shape[:2]
    seeds = np.arange(1, H * W + 1, dtype=np.float64).reshape(H, W)
    everything = []
    for name, low, high in color_ranges:
        mask = _in_range(hsv, low, high)
        label = np.where(mask, seeds, 0)
        while True:
            grown = np.where(mask, cv2.dilate(label, np.ones((3, 3), np.uint8)), 0)
            if np.array_equal(grown, label):
                break
            label = grown
        values, counts = np.unique(label[mask], return_counts=True)
        for value, count in zip(values, counts):
            if count >= min_area:
                box = cv2.boundingRect((label == value).astype(np.uint8))
                everything.append((int(count), name, tuple(box)))
    everything = sorted(everything, key=lambda t: t[0])[::-1]
    return [t[1] for t in everything], [t[0] for t in everything], [t[2] for t in everything]


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
