"""Right answers to find_all_objects, as strangers wrote them."""
import collections

import cv2
import numpy as np


def _range_mask(hsv, low, high):
    """cv2.inRange, twice where the hue wraps."""
    low, high = [int(a) for a in low], [int(a) for a in high]
    if low[0] <= high[0]:
        return cv2.inRange(hsv, np.array(low), np.array(high))
    first = cv2.inRange(hsv, np.array(low), np.array([179] + high[1:]))
    second = cv2.inRange(hsv, np.array([0] + low[1:]), np.array(high))
    return first | second


def with_stats(rgb_image, color_ranges, min_area):
    """cv2.connectedComponentsWithStats per color, one sort at the end."""
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, _, stats, _ = cv2.connectedComponentsWithStats(_range_mask(hsv, low, high), connectivity=8)
        for left, top, w, h, area in stats[1:n].tolist():
            if area >= min_area:
                found.append((area, name, (left, top, w, h)))
    found.sort(key=lambda f: -f[0])
    return [f[1] for f in found], [f[0] for f in found], [f[2] for f in found]


def with_contours(rgb_image, color_ranges, min_area):
    """External contours (objects have no holes), filled and counted; boundingRect for the box."""
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    names, areas, boxes = [], [], []
    for name, low, high in color_ranges:
        mask = _range_mask(hsv, low, high)
        contours = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]
        for contour in contours:
            left, top, w, h = cv2.boundingRect(contour)
            filled = np.zeros((h, w), np.uint8)
            cv2.drawContours(filled, [contour], -1, 255, cv2.FILLED, offset=(-left, -top))
            area = cv2.countNonZero(filled & mask[top:top + h, left:left + w])
            if area >= min_area:
                names.append(name)
                areas.append(int(area))
                boxes.append((int(left), int(top), int(w), int(h)))
    order = sorted(range(len(areas)), key=areas.__getitem__, reverse=True)
    return [names[i] for i in order], [areas[i] for i in order], [boxes[i] for i in order]


def breadth_first(rgb_image, color_ranges, min_area):
    """No OpenCV for the regions: a set of pixels and a queue; NumPy comparisons for the range."""
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    h, s, v = (hsv[..., k].astype(int) for k in range(3))
    result = []
    for name, low, high in color_ranges:
        hue = (h >= low[0]) & (h <= high[0]) if low[0] <= high[0] else (h >= low[0]) | (h <= high[0])
        inside = hue & (s >= low[1]) & (s <= high[1]) & (v >= low[2]) & (v <= high[2])
        rest = set(zip(*(k.tolist() for k in np.nonzero(inside))))
        while rest:
            queue = collections.deque([rest.pop()])
            region = []
            while queue:
                r, c = queue.popleft()
                region.append((r, c))
                for i in (r - 1, r, r + 1):
                    for j in (c - 1, c, c + 1):
                        if (i, j) in rest:
                            rest.remove((i, j))
                            queue.append((i, j))
            if len(region) >= min_area:
                rows, columns = zip(*region)
                box = (min(columns), min(rows), max(columns) - min(columns) + 1, max(rows) - min(rows) + 1)
                result.append((len(region), name, box))
    result.sort(key=lambda item: item[0], reverse=True)
    return [item[1] for item in result], [item[0] for item in result], [item[2] for item in result]


def with_flood_fill(rgb_image, color_ranges, min_area):
    """cv2.floodFill with eight neighbors takes one region after the other out of the mask."""
    hsv = cv2.cvtColor(np.ascontiguousarray(rgb_image), cv2.COLOR_RGB2HSV)
    heap = []
    for name, low, high in color_ranges:
        mask = _range_mask(hsv, low, high)
        for r, c in np.argwhere(mask):
            if mask[r, c] == 0:
                continue
            area, _, _, rect = cv2.floodFill(mask, None, (int(c), int(r)), 0, 0, 0, 8)
            heap.append((int(area), name, tuple(int(k) for k in rect)))
    heap = [entry for entry in heap if not entry[0] < min_area]
    names, areas, boxes = [], [], []
    while heap:
        biggest = max(heap, key=lambda entry: entry[0])
        heap.remove(biggest)
        names.append(biggest[1])
        areas.append(biggest[0])
        boxes.append(biggest[2])
    return names, areas, boxes


def union_of_runs(rgb_image, color_ranges, min_area):
    """Run-length coding and union-find; counts runs, not pixels."""
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    objects = []
    for name, low, high in color_ranges:
        mask = _range_mask(hsv, low, high) > 0
        runs, parent = [], []

        def root(i):
            while parent[i] != i:
                parent[i] = parent[parent[i]]
                i = parent[i]
            return i

        above = []
        for r, line in enumerate(mask):
            edges = np.flatnonzero(np.diff(np.concatenate([[0], line.astype(np.int8), [0]])))
            here = []
            for a, b in zip(edges[0::2].tolist(), edges[1::2].tolist()):  # columns a .. b-1
                k = len(runs)
                runs.append((r, a, b))
                parent.append(k)
                here.append(k)
                for other in above:
                    _, c, d = runs[other]
                    if c <= b and a <= d:  # touching, corners included
                        parent[root(other)] = root(k)
            above = here
        groups = {}
        for k, run in enumerate(runs):
            groups.setdefault(root(k), []).append(run)
        for group in groups.values():
            area = sum(b - a for _, a, b in group)
            if area >= min_area:
                top, bottom = min(g[0] for g in group), max(g[0] for g in group)
                left, right = min(g[1] for g in group), max(g[2] for g in group)
                objects.append((name, area, (left, top, right - left, bottom - top + 1)))
    objects = sorted(objects, key=lambda o: o[1])[::-1]
    return ([n for n, _, _ in objects], [a for _, a, _ in objects], [b for _, _, b in objects])


class _Finder:
    """Over-engineered: tables per channel, validation."""

    def __init__(self, picture):
        if picture.ndim != 3 or picture.shape[2] != 3:
            raise ValueError("not a color picture")
        self.hsv = cv2.cvtColor(np.ascontiguousarray(picture[..., ::-1]), cv2.COLOR_BGR2HSV)

    def select(self, low, high):
        tables = [[low[k] <= i <= high[k] for i in range(256)] for k in range(3)]
        if low[0] > high[0]:
            tables[0] = [i >= low[0] or i <= high[0] for i in range(256)]
        chosen = [np.array(tables[k])[self.hsv[..., k]] for k in range(3)]
        return np.uint8(chosen[0] & chosen[1] & chosen[2])

    def regions(self, low, high):
        count, labels = cv2.connectedComponents(self.select(low, high), connectivity=8)
        sizes = np.bincount(labels.ravel(), minlength=count)
        for k in range(1, count):
            rows, columns = np.nonzero(labels == k) if sizes[k] else ([], [])
            yield int(sizes[k]), (int(columns.min()), int(rows.min()),
                                  int(np.ptp(columns)) + 1, int(np.ptp(rows)) + 1)


def with_a_class(rgb_image, color_ranges, min_area):
    """A class with lookup tables per channel, bincount for the areas, BGR on the way."""
    finder = _Finder(rgb_image)
    entries = [(name, area, box) for name, low, high in color_ranges
               for area, box in finder.regions(low, high) if area >= min_area]
    entries.sort(key=lambda e: e[1], reverse=True)
    names, areas, boxes = ([e[k] for e in entries] for k in range(3))
    return names, areas, boxes


def numpy_scalars_inside(rgb_image, color_ranges, min_area):
    """Hue shifted so that a wrapping range starts at 0; areas and boxes hold NumPy integers."""
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(np.int32)
    names, areas, boxes = [], [], []
    for name, low, high in color_ranges:
        width = (min(high[0], 179) - low[0]) if high[0] >= low[0] else (high[0] - low[0]) % 180
        hue = (hsv[..., 0] - low[0]) % 180 <= width
        rest = np.all((hsv[..., 1:] >= np.array(low[1:])) & (hsv[..., 1:] <= np.array(high[1:])), axis=2)
        _, _, stats, _ = cv2.connectedComponentsWithStats((hue & rest).astype(np.uint8) * 255)
        for row in stats[1:]:
            if row[cv2.CC_STAT_AREA] >= min_area:
                place = sum(a >= row[cv2.CC_STAT_AREA] for a in areas)  # insertion sort
                names.insert(place, name)
                areas.insert(place, row[cv2.CC_STAT_AREA])
                boxes.insert(place, tuple(row[:4]))
    return names, areas, boxes


ANSWERS = [with_stats, with_contours, breadth_first, with_flood_fill, union_of_runs,
           with_a_class, numpy_scalars_inside]
