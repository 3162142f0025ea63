"""Right answers to find_all_objects, as strangers wrote them."""
from collections import deque
from dataclasses import dataclass, astuple

import cv2
import numpy as np


def _mask(hsv, low, high):
    low, high = np.asarray(low), np.asarray(high)
    ok = (hsv >= low) & (hsv <= high)
    if low[0] > high[0]:
        ok[..., 0] = (hsv[..., 0] >= low[0]) | (hsv[..., 0] <= high[0])
    return ok.all(axis=-1)


# 1. connectedComponentsWithStats
def f1(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    objects = []
    for name, low, high in color_ranges:
        m = _mask(hsv, low, high).astype(np.uint8)
        n, _, stats, _ = cv2.connectedComponentsWithStats(m, connectivity=8)
        for left, top, w, h, area in stats[1:]:
            if area >= min_area:
                objects.append((name, int(area), (int(left), int(top), int(w), int(h))))
    objects.sort(key=lambda o: -o[1])
    return [o[0] for o in objects], [o[1] for o in objects], [o[2] for o in objects]


# 2. breadth first by hand
def f2(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(int)
    height, width = hsv.shape[:2]
    found = []
    for name, (h0, s0, v0), (h1, s1, v1) in color_ranges:
        todo = set()
        for y in range(height):
            for x in range(width):
                h, s, v = hsv[y, x]
                hue = (h0 <= h <= h1) if h0 <= h1 else (h >= h0 or h <= h1)
                if hue and s0 <= s <= s1 and v0 <= v <= v1:
                    todo.add((x, y))
        while todo:
            queue = deque([todo.pop()])
            xs, ys = [], []
            while queue:
                x, y = queue.popleft()
                xs.append(x)
                ys.append(y)
                for dx in (-1, 0, 1):
                    for dy in (-1, 0, 1):
                        q = (x + dx, y + dy)
                        if q in todo:
                            todo.remove(q)
                            queue.append(q)
            if len(xs) < min_area:
                continue
            box = (min(xs), min(ys), max(xs) - min(xs) + 1, max(ys) - min(ys) + 1)
            found.append((len(xs), name, box))
    found = sorted(found, key=lambda f: f[0], reverse=True)
    names, areas, boxes = [], [], []
    for area, name, box in found:
        names.append(name)
        areas.append(area)
        boxes.append(box)
    return names, areas, boxes


# 3. contours, boundingRect, filled drawing; no holes, so the filled contour is the object
def f3(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image[..., ::-1].copy(), cv2.COLOR_BGR2HSV)
    rows = []
    for name, low, high in color_ranges:
        if low[0] > high[0]:
            m = cv2.inRange(hsv, np.array(low), np.array((255, *high[1:]))) | \
                cv2.inRange(hsv, np.array((0, *low[1:])), np.array(high))
        else:
            m = cv2.inRange(hsv, np.array(low), np.array(high))
        for c in cv2.findContours(m, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]:
            x, y, w, h = box = tuple(cv2.boundingRect(c))
            canvas = np.zeros((h, w), np.uint8)
            cv2.drawContours(canvas, [c], -1, 1, cv2.FILLED, offset=(-x, -y))
            area = cv2.countNonZero(canvas)
            if area >= min_area:
                rows.append((area, name, box))
    rows.sort(key=lambda r: r[0], reverse=True)
    areas, names, boxes = map(list, zip(*rows)) if rows else ([], [], [])
    return names, areas, boxes


# 4. labels, bincount, argsort; NumPy integers in the lists, boxes as lists
def f4(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    names, areas, boxes = [], [], []
    for name, low, high in color_ranges:
        n, lab = cv2.connectedComponents(np.uint8(_mask(hsv, low, high)) * 255, connectivity=8)
        counts = np.bincount(lab.ravel(), minlength=n)
        for i in np.flatnonzero(counts[1:] >= min_area) + 1:
            v, u = np.nonzero(lab == i)
            names.append(name)
            areas.append(counts[i])
            boxes.append([u.min(), v.min(), np.ptp(u) + 1, np.ptp(v) + 1])
    order = np.argsort(areas, kind="stable")[::-1]
    return [names[i] for i in order], [areas[i] for i in order], [boxes[i] for i in order]


# 5. floodFill
def f5(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    out = []
    for name, low, high in color_ranges:
        m = np.where(_mask(hsv, low, high), 255, 0).astype(np.uint8)
        while m.any():
            y, x = divmod(int(m.argmax()), m.shape[1])
            area, m, _, rect = cv2.floodFill(m, None, (x, y), 0, 0, 0, 8)
            out.append((int(area), name, tuple(int(k) for k in rect)))
    out = sorted((o for o in out if o[0] >= min_area), key=lambda o: o[0])[::-1]
    return [n for _, n, _ in out], [a for a, _, _ in out], [b for _, _, b in out]


# 6. dataclass and union-find over runs of a row
@dataclass
class Thing:
    name: str
    area: int
    box: tuple


class Runs:
    def __init__(self, mask):
        self.runs = []
        for y, row in enumerate(mask):
            edges = np.flatnonzero(np.diff(np.r_[0, row.astype(np.int8), 0]))
            self.runs += [(y, int(a), int(b)) for a, b in zip(edges[::2], edges[1::2])]
        self.parent = list(range(len(self.runs)))
        by_row = {}
        for i, (y, a, b) in enumerate(self.runs):
            by_row.setdefault(y, []).append(i)
            for j in by_row.get(y - 1, []):
                _, c, d = self.runs[j]
                if c <= b and a <= d:  # they touch, also at a corner
                    self.parent[self.root(i)] = self.root(j)

    def root(self, i):
        while self.parent[i] != i:
            i = self.parent[i]
        return i

    def groups(self):
        groups = {}
        for i, run in enumerate(self.runs):
            groups.setdefault(self.root(i), []).append(run)
        return groups.values()


def f6(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    things = []
    for name, low, high in color_ranges:
        for group in Runs(_mask(hsv, low, high)).groups():
            ys, starts, ends = map(np.array, zip(*group))
            left, top = int(starts.min()), int(ys.min())
            things.append(Thing(name, int((ends - starts).sum()),
                                (left, top, int(ends.max()) - left, int(ys.max()) - top + 1)))
    things = [t for t in things if not t.area < min_area]
    things.sort(key=lambda t: t.area, reverse=True)
    return [t.name for t in things], [t.area for t in things], [t.box for t in things]


ANSWERS = [f1, f2, f3, f4, f5, f6]
