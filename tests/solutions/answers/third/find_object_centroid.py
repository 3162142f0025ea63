"""Right answers to find_object_centroid, as strangers wrote them."""
import math
from dataclasses import dataclass

import cv2
import numpy as np


# 1. the book's way: largest external contour, moments, rounded down
def centroid_moments(mask):
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    m = cv2.moments(max(contours, key=cv2.contourArea))
    if m["m00"] == 0:
        return None
    return int(m["m10"] / m["m00"]), int(m["m01"] / m["m00"])


# 2. sorted, all points, rounded to the nearest
def centroid_sorted(mask):
    binary = np.where(mask != 0, np.uint8(255), np.uint8(0))
    found = cv2.findContours(binary, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]
    by_area = sorted(found, key=cv2.contourArea, reverse=True)
    if len(by_area) == 0 or cv2.contourArea(by_area[0]) <= 0:
        return None
    m = cv2.moments(by_area[0])
    return (round(m["m10"] / m["m00"]), round(m["m01"] / m["m00"]))


# 3. beginner
def centroid_beginner(mask):
    copy_of_mask = mask.copy()
    result = cv2.findContours(copy_of_mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    contours = result[0]
    largest = None
    largest_area = 0
    for i in range(len(contours)):
        area = cv2.contourArea(contours[i])
        if area > largest_area:
            largest_area = area
            largest = contours[i]
    if largest is None:
        return None
    moments = cv2.moments(largest)
    x = moments["m10"] / moments["m00"]
    y = moments["m01"] / moments["m00"]
    x = int(np.floor(x + 0.5))
    y = int(np.floor(y + 0.5))
    return (x, y)


# 4. mathematician: Green's theorem, the shoelace sums
def _polygon(contour):
    x, y = np.asarray(contour, dtype=float).reshape(-1, 2).T
    xn, yn = np.roll(x, -1), np.roll(y, -1)
    cross = x * yn - xn * y
    area = cross.sum() / 2
    if area == 0:
        return 0.0, None
    return abs(area), (((x + xn) * cross).sum() / (6 * area), ((y + yn) * cross).sum() / (6 * area))


def centroid_green(mask):
    contours, tree = cv2.findContours(mask, cv2.RETR_TREE, cv2.CHAIN_APPROX_NONE)
    if tree is None or len(contours) == 0:
        return None
    parents = np.asarray(tree).reshape(-1, 4)[:, 3]
    outer = [_polygon(c) for c, parent in zip(contours, parents) if parent == -1]
    area, center = max(outer, key=lambda pair: pair[0])
    if center is None:
        return None
    return math.ceil(center[0] - 0.5), math.ceil(center[1] - 0.5)


# 5. Java: a list of regions, comparable
@dataclass(order=True)
class Region:
    area: float
    number: int

    def centroid(self, contours):
        m = cv2.moments(contours[self.number])
        return tuple(int(m[k] // m["m00"]) for k in ("m10", "m01"))


def centroid_java(mask):
    if mask.ndim != 2:
        raise ValueError("a mask has two dimensions")
    contours, hierarchy = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    regions = []
    for number in range(len(contours)):
        is_hole = int(np.asarray(hierarchy).reshape(-1, 4)[number, 3]) >= 0
        if not is_hole:
            regions.append(Region(cv2.contourArea(contours[number]), number))
    if not regions:
        return None
    best = max(regions)
    return best.centroid(contours) if best.area > 0 else None


# 6. Matlab: an array of areas, argmax; answer from np.divide, up instead of down
def centroid_matlab(mask):
    C, _ = cv2.findContours((mask > 0).astype(np.uint8), mode=cv2.RETR_EXTERNAL,
                            method=cv2.CHAIN_APPROX_SIMPLE)
    M = np.array([[m["m00"], m["m10"], m["m01"]] for m in map(cv2.moments, C)]).reshape(-1, 3)
    if M.shape[0] == 0 or np.all(M[:, 0] == 0):
        return None
    i = np.argmax(M[:, 0])
    xy = np.ceil(M[i, 1:] / M[i, 0]).astype(int)
    return tuple(xy.tolist())


# 7. triangles from the first corner: a weighted mean of their centers
def centroid_triangles(mask):
    contours, _ = cv2.findContours(np.ascontiguousarray(mask), cv2.RETR_EXTERNAL,
                                   cv2.CHAIN_APPROX_SIMPLE)

    def measure(contour):
        p = contour.reshape(-1, 2).astype(np.float64)
        a, b = p[1:-1] - p[0], p[2:] - p[0]
        weight = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
        return p, a, b, weight

    best = max((measure(c) for c in contours), key=lambda q: abs(q[3].sum()), default=None)
    if best is None or abs(best[3].sum()) < 1e-9:
        return None
    p, a, b, weight = best
    center = p[0] + ((a + b) / 3 * weight[:, None]).sum(axis=0) / weight.sum()
    x, y = np.rint(center)
    return int(x), int(y)


# 8. NumPy integers back, validated by a guard
def centroid_numpy_ints(mask):
    if cv2.countNonZero(mask) == 0:
        return None
    contours = cv2.findContours(mask.copy(), cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)[0]
    # a hole is never larger than the region around it, so LIST will do
    areas = np.fromiter((abs(cv2.contourArea(c, oriented=True)) for c in contours), float)
    if not np.any(areas):
        return None
    m = cv2.moments(contours[int(areas.argmax())].astype(np.float32))
    return tuple(np.floor([m["m10"] / m["m00"], m["m01"] / m["m00"]]).astype(np.int64))


ANSWERS = [centroid_moments, centroid_sorted, centroid_beginner, centroid_green, centroid_java,
           centroid_matlab, centroid_triangles, centroid_numpy_ints]
