"""Wrong answers to find_all_objects, as strangers wrote them."""
import cv2
import numpy as np


def _mask(hsv, low, high):
    h, s, v = [hsv[..., i].astype(int) for i in range(3)]
    hue = (h >= low[0]) | (h <= high[0]) if low[0] > high[0] else (h >= low[0]) & (h <= high[0])
    return np.uint8(hue & (s >= low[1]) & (s <= high[1]) & (v >= low[2]) & (v <= high[2]))


def _right(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high), connectivity=8)
        for x, y, w, h, area in stats[1:n].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_four_neighbors(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high), connectivity=4)
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_sorted_within_color(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    names, areas, boxes = [], [], []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in sorted(stats[1:].tolist(), key=lambda s: -s[4]):
            if area >= min_area:
                names.append(name)
                areas.append(area)
                boxes.append((x, y, w, h))
    return names, areas, boxes


def w_background_counts(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for i in range(n):
            x, y, w, h, area = stats[i].tolist()
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_contour_area(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        contours, _ = cv2.findContours(_mask(hsv, low, high), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        for c in contours:
            area = int(cv2.contourArea(c))
            if area >= min_area:
                found.append((name, area, tuple(cv2.boundingRect(c))))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_more_than_min_area(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area > min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_bgr(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_BGR2HSV)
    found = []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_no_wrap(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        mask = cv2.inRange(hsv, np.array(low), np.array(high))
        _, _, stats, _ = cv2.connectedComponentsWithStats(mask)
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_halves_apart(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        parts = [(low, high)]
        if low[0] > high[0]:
            parts = [(low, (179, *high[1:])), ((0, *low[1:]), high)]
        for a, b in parts:
            _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, a, b))
            for x, y, w, h, area in stats[1:].tolist():
                if area >= min_area:
                    found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_smallest_first(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((area, name, (x, y, w, h)))
    found.sort()
    return [f[1] for f in found], [f[0] for f in found], [f[2] for f in found]


def w_corners(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, labels = cv2.connectedComponents(_mask(hsv, low, high))
        for i in range(1, n):
            ys, xs = np.nonzero(labels == i)
            if len(xs) >= min_area:
                found.append((name, len(xs), (int(xs.min()), int(ys.min()), int(xs.max()), int(ys.max()))))
    found.sort(key=lambda f: f[1], reverse=True)
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_size_one_short(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, labels = cv2.connectedComponents(_mask(hsv, low, high))
        for i in range(1, n):
            ys, xs = np.nonzero(labels == i)
            if len(xs) >= min_area:
                box = (int(xs.min()), int(ys.min()), int(np.ptp(xs)), int(np.ptp(ys)))
                found.append((name, len(xs), box))
    found.sort(key=lambda f: f[1], reverse=True)
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_rows_first(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, labels = cv2.connectedComponents(_mask(hsv, low, high))
        for i in range(1, n):
            rows, cols = np.nonzero(labels == i)
            if len(rows) >= min_area:
                box = (int(rows.min()), int(cols.min()), int(np.ptp(rows)) + 1, int(np.ptp(cols)) + 1)
                found.append((name, len(rows), box))
    found.sort(key=lambda f: f[1], reverse=True)
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_area_of_box(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        contours, _ = cv2.findContours(_mask(hsv, low, high), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
        for c in contours:
            x, y, w, h = cv2.boundingRect(c)
            if w * h >= min_area:
                found.append((name, w * h, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_cleans_the_mask(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    k = np.ones((5, 5), np.uint8)
    found = []
    for name, low, high in color_ranges:
        mask = cv2.morphologyEx(_mask(hsv, low, high), cv2.MORPH_OPEN, k)
        mask = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, k)
        _, _, stats, _ = cv2.connectedComponentsWithStats(mask)
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_one_per_color(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        if n > 1:
            x, y, w, h, area = stats[1 + np.argmax(stats[1:, 4])].tolist()
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_names_not_sorted(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    names, areas, boxes = [], [], []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                names.append(name)
                areas.append(area)
                boxes.append((x, y, w, h))
    order = np.argsort(areas)[::-1]
    return names, [areas[i] for i in order], [boxes[i] for i in order]


def w_first_color_only(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
        found.sort(key=lambda f: -f[1])
        return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_dict_by_name(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    objects = {}
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                objects[name] = (area, (x, y, w, h))
    names = sorted(objects, key=lambda n: -objects[n][0])
    return names, [objects[n][0] for n in names], [objects[n][1] for n in names]


def w_dict_by_area(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    objects = {}
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                objects[area] = (name, (x, y, w, h))
    areas = sorted(objects, reverse=True)
    return [objects[a][0] for a in areas], areas, [objects[a][1] for a in areas]


def w_exclusive_limits(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    h, s, v = hsv[..., 0], hsv[..., 1], hsv[..., 2]
    found = []
    for name, low, high in color_ranges:
        hue = (h > low[0]) | (h < high[0]) if low[0] > high[0] else (h > low[0]) & (h < high[0])
        mask = hue & (s > low[1]) & (s < high[1]) & (v > low[2]) & (v < high[2])
        _, _, stats, _ = cv2.connectedComponentsWithStats(np.uint8(mask))
        for x, y, w, h_, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h_)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_joined_mask(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    color = np.zeros(hsv.shape[:2], np.int32)
    for i, (name, low, high) in enumerate(color_ranges):
        color[_mask(hsv, low, high) > 0] = i + 1
    n, labels, stats, _ = cv2.connectedComponentsWithStats(np.uint8(color > 0))
    found = []
    for j in range(1, n):
        x, y, w, h, area = stats[j].tolist()
        if area >= min_area:
            name = color_ranges[np.bincount(color[labels == j]).argmax() - 1][0]
            found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_labels_in_bytes(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        n, labels = cv2.connectedComponents(_mask(hsv, low, high))
        labels = labels.astype(np.uint8)
        for i in range(1, n):
            ys, xs = np.nonzero(labels == i % 256)
            if 0 < len(xs) and len(xs) >= min_area and i < 256:
                box = (int(xs.min()), int(ys.min()), int(np.ptp(xs)) + 1, int(np.ptp(ys)) + 1)
                found.append((name, len(xs), box))
    found.sort(key=lambda f: f[1], reverse=True)
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_zip_of_nothing(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    names, areas, boxes = zip(*found)
    return list(names), list(areas), list(boxes)


def w_list_of_triples(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    return sorted(found, key=lambda f: -f[1])


def w_remembers_objects(rgb_image, color_ranges, min_area, found=[]):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= min_area:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


def w_min_area_fixed(rgb_image, color_ranges, min_area=50):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    found = []
    for name, low, high in color_ranges:
        _, _, stats, _ = cv2.connectedComponentsWithStats(_mask(hsv, low, high))
        for x, y, w, h, area in stats[1:].tolist():
            if area >= 50:
                found.append((name, area, (x, y, w, h)))
    found.sort(key=lambda f: -f[1])
    return [f[0] for f in found], [f[1] for f in found], [f[2] for f in found]


WRONG = [
    (w_four_neighbors, "four neighbors; objects joined only by a corner"),
    (w_sorted_within_color, "sorted within each color only; a larger object of a later color"),
    (w_background_counts, "the background (label 0) counts as an object; every picture"),
    (w_contour_area, "area of the contour polygon instead of the number of pixels; every object"),
    (w_more_than_min_area, "> instead of >=; an object of exactly min_area pixels"),
    (w_bgr, "picture taken for BGR; every colored object"),
    (w_no_wrap, "inRange with a wrapping range finds nothing; red"),
    (w_halves_apart, "the two halves of a wrapping range are labeled apart; an object with hues on both sides of the seam"),
    (w_smallest_first, "smallest first; two objects or more"),
    (w_corners, "box as (left, top, right, bottom); every object"),
    (w_size_one_short, "width and height one too small; every object"),
    (w_rows_first, "box as (top, left, height, width); every object off the diagonal"),
    (w_area_of_box, "area of the box instead of the pixels; objects that are no rectangles"),
    (w_cleans_the_mask, "opening and closing change areas and drop thin objects; thin objects, corners, gaps"),
    (w_one_per_color, "only the largest object of each color; two objects of one color"),
    (w_names_not_sorted, "names keep the old order; colors not in order of size"),
    (w_first_color_only, "return inside the loop; two colors (None without any)"),
    (w_dict_by_name, "dictionary keyed by color: one object per color; two objects of one color"),
    (w_dict_by_area, "dictionary keyed by area; two objects with the same number of pixels"),
    (w_exclusive_limits, "limits are exclusive; colors on a limit, such as saturation 255"),
    (w_joined_mask, "one mask for all colors: touching objects of two colors become one; touching objects"),
    (w_labels_in_bytes, "labels in uint8 wrap around; more than 255 regions"),
    (w_zip_of_nothing, "zip(*[]) raises; no object"),
    (w_list_of_triples, "one list of triples instead of three lists; every picture"),
    (w_remembers_objects, "default list keeps the objects of earlier calls; second call"),
    (w_min_area_fixed, "min_area ignored; any other than 50"),
]

_RANGES = (("red", (170, 120, 50), (6, 255, 255)), ("green", (50, 100, 50), (70, 255, 255)), ("blue", (110, 100, 50), (130, 255, 255)))


def _cases():
    def paint(f):
        hsv = np.zeros((60, 90, 3), np.uint8)
        hsv[...] = (20, 30, 100)
        f(hsv)
        return cv2.cvtColor(hsv, cv2.COLOR_HSV2RGB)

    def a(h):
        h[5:15, 5:12] = (175, 200, 200)
        h[5:15, 12:20] = (3, 200, 200)       # across the seam: 150
        h[20:40, 5:20] = (60, 200, 200)      # 300
        h[20:40, 20:25] = (120, 200, 200)    # touches: 100
        h[45:50, 30:36] = (60, 200, 200)     # 30
        h[50:56, 36:40] = (60, 200, 200)     # corner neighbor: 24
        h[2:3, 40:80] = (120, 255, 255)      # thin: 40
        for i in range(14):
            h[30 + i, 50:51 + i] = (2, 220, 220)   # 105
        h[50:55, 70:80] = (120, 200, 200)    # 50

    def b(h):
        h[10:20, 10:16] = (0, 255, 255)     # 60
        h[30:36, 40:50] = (60, 255, 255)    # 60

    def many(h):
        h[::3, ::3] = (60, 200, 200)

    def c(h):
        h[10:20, 10:20] = (179, 255, 255)
    return [lambda: (paint(a), _RANGES, 20), lambda: (paint(a), _RANGES, 50), lambda: (paint(lambda h: None), _RANGES, 5),
            lambda: (paint(b), _RANGES, 10), lambda: (paint(many), _RANGES, 1), lambda: (paint(c), (("r", (179, 255, 255), (0, 255, 255)),), 10),
            lambda: (paint(a), (), 20)]


def _same(a, b):
    try:
        if not (isinstance(a, tuple) and len(a) == 3 and all(isinstance(x, list) for x in a)):
            return False
        if list(a[1]) != b[1]:
            return False
        return sorted((n, k, tuple(x)) for n, k, x in zip(*a)) == sorted(zip(*b)) and len(a[0]) == len(b[0]) and len(a[2]) == len(b[2])
    except Exception:
        return False
