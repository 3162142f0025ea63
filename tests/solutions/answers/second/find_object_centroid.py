"""Right answers to find_object_centroid, as strangers wrote them."""
import math
from collections import deque, namedtuple
from dataclasses import dataclass

import cv2
import numpy as np


# 1. the usual
def f1(mask):
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    m = cv2.moments(max(contours, key=cv2.contourArea))
    if m["m00"] == 0:
        return None
    return int(m["m10"] / m["m00"]), int(m["m01"] / m["m00"])


# 2. binary copy, all points kept, rounded
def f2(mask):
    binary = (mask != 0).astype(np.uint8)
    contours = cv2.findContours(binary, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[-2]
    best, best_area = None, 0.0
    for c in contours:
        area = cv2.contourArea(c)
        if area > best_area:
            best, best_area = c, area
    if best is None:
        return None
    m = cv2.moments(best)
    return (round(m["m10"] / m["m00"]), round(m["m01"] / m["m00"]))


# 3. shoelace by hand, vectorised
def _shoelace(contour):
    p = contour.reshape(-1, 2).astype(np.float64)
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1]
    area = cross.sum() / 2
    return area, ((p + q) * cross[:, None]).sum(axis=0) / 6


def f3(mask):
    contours, _ = cv2.findContours(mask.copy(), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    if len(contours) == 0:
        return None
    areas = [abs(_shoelace(c)[0]) for c in contours]
    k = int(np.argmax(areas))
    if areas[k] < 1e-9:
        return None
    area, first = _shoelace(contours[k])
    x, y = np.floor(first / area + 0.5).astype(int).tolist()
    return x, y


# 4. hierarchy of RETR_CCOMP, sorted by area, ceil
def f4(mask):
    contours, hierarchy = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    if hierarchy is None or len(contours) == 0:
        return None
    parents = np.asarray(hierarchy).reshape(-1, 4)[:, 3]
    outer = [c for c, parent in zip(contours, parents) if parent < 0]
    moments = sorted((cv2.moments(c) for c in outer), key=lambda m: m["m00"])
    top = moments[-1]
    if not top["m00"] > 0:
        return None
    return tuple(math.ceil(top[k] / top["m00"]) for k in ("m10", "m01"))


# 5. without contours: flood from outside, 2 x 2 blocks carry the polygon's area
def f5(mask):
    count, labels = cv2.connectedComponents((mask != 0).astype(np.uint8), connectivity=8)
    best_area, best = 0.0, None
    for k in range(1, count):
        padded = np.pad((labels == k).astype(np.uint8), 1)
        outside = padded.copy()
        cv2.floodFill(outside, None, (0, 0), 2, flags=4)
        solid = (outside != 2)[1:-1, 1:-1]
        a, b, c, d = (solid[:-1, :-1], solid[:-1, 1:], solid[1:, :-1], solid[1:, 1:])
        n = a.astype(int) + b + c + d
        weight = np.where(n == 4, 1.0, np.where(n == 3, 0.5, 0.0))
        area = weight.sum()
        if area <= best_area:
            continue
        y, x = np.indices(n.shape)
        # center of mass of a block: its middle, or of a triangle its three corners
        with np.errstate(all="ignore"):
            cx = np.where(n == 3, x + (b.astype(int) + d) / n, x + 0.5)
            cy = np.where(n == 3, y + (c.astype(int) + d) / n, y + 0.5)
        best_area = area
        best = (float(np.sum(weight * cx) / area), float(np.sum(weight * cy) / area))
    return None if best is None else (int(best[0]), int(best[1]))


# 6. class with named tuple
Pixel = namedtuple("Pixel", "x y")


@dataclass
class _Blob:
    contour: np.ndarray

    def __post_init__(self):
        self.moments = cv2.moments(self.contour)

    @property
    def area(self):
        return cv2.contourArea(self.contour)

    def center(self):
        m = self.moments
        return Pixel(int(m["m10"] // m["m00"]), int(m["m01"] // m["m00"]))


def f6(mask: np.ndarray):
    if mask.ndim != 2:
        raise ValueError("a mask has two axes")
    contours, _ = cv2.findContours(mask, cv2.RETR_TREE, cv2.CHAIN_APPROX_NONE)
    blobs = [b for b in map(_Blob, contours) if b.area > 0]
    if not blobs:
        return None
    blobs.sort(key=lambda b: -b.area)
    return blobs[0].center()


# 7. short
def f7(mask):
    c = cv2.findContours(np.uint8(mask > 0), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_TC89_L1 * 0 + cv2.CHAIN_APPROX_SIMPLE)[0]
    m = max(map(cv2.moments, c), key=lambda q: q["m00"], default={"m00": 0})
    return (int(m["m10"] / m["m00"] + .5), int(m["m01"] / m["m00"] + .5)) if m["m00"] else None


# 8. C programmer: Green's theorem edge by edge, integers only
def f8(mask):
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    best2, sx, sy = 0, 0, 0
    for contour in contours:
        pts = contour[:, 0, :].tolist()
        a2 = x6 = y6 = 0
        for i in range(len(pts)):
            x0, y0 = pts[i - 1]
            x1, y1 = pts[i]
            w = x0 * y1 - x1 * y0
            a2 += w
            x6 += (x0 + x1) * w
            y6 += (y0 + y1) * w
        if abs(a2) > abs(best2):
            best2, sx, sy = a2, x6, y6
    if best2 == 0:
        return None
    return int(sx / (3 * best2)), int(sy / (3 * best2))


# 9. arrays of areas, NumPy integers come back
def f9(mask):
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    areas = np.array([cv2.contourArea(c) for c in contours])
    if areas.size == 0 or areas.max() == 0:
        return None
    m = cv2.moments(contours[areas.argmax()])
    x, y = np.rint(np.array([m["m10"], m["m01"]]) / m["m00"]).astype(np.int64)
    return x, y


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8, f9]
