"""Right answers to find_object_centroid, as strangers wrote them."""
import math
from typing import Optional, Tuple

import cv2
import numpy as np


# 1. as in OpenCV's tutorial, floor
def f1(mask):
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    M = cv2.moments(max(contours, key=cv2.contourArea))
    if M["m00"] == 0:
        return None
    return int(M["m10"] / M["m00"]), int(M["m01"] / M["m00"])


# 2. all contour points, rounded
def f2(mask):
    binary = np.where(mask != 0, 255, 0).astype(np.uint8)
    contours = cv2.findContours(binary, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[-2]
    best, best_area = None, 0.0
    for contour in contours:
        area = cv2.contourArea(contour)
        if area > best_area:
            best, best_area = contour, area
    if best is None:
        return None
    m = cv2.moments(best)
    return round(m["m10"] / m["m00"]), round(m["m01"] / m["m00"])


# 3. shoelace by hand, ceil
def _shoelace(contour):
    points = contour.reshape(-1, 2).tolist()
    area = sx = sy = 0.0
    for i in range(len(points)):
        x0, y0 = points[i - 1]
        x1, y1 = points[i]
        cross = x0 * y1 - x1 * y0
        area += cross / 2
        sx += (x0 + x1) * cross / 6
        sy += (y0 + y1) * cross / 6
    return area, sx, sy


def f3(mask):
    contours, _ = cv2.findContours(mask.copy(), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    measured = [_shoelace(c) for c in contours]
    measured = [m for m in measured if abs(m[0]) > 0]
    if len(measured) == 0:
        return None
    area, sx, sy = max(measured, key=lambda m: abs(m[0]))
    return (math.ceil(sx / area), math.ceil(sy / area))


# 4. full hierarchy, keep the outermost
def f4(mask):
    contours, hierarchy = cv2.findContours((mask > 0).astype(np.uint8), cv2.RETR_CCOMP,
                                           cv2.CHAIN_APPROX_SIMPLE)
    if hierarchy is None or len(contours) == 0:
        return None
    outer = [c for c, h in zip(contours, hierarchy.reshape(-1, 4)) if h[3] == -1]
    outer.sort(key=cv2.contourArea, reverse=True)
    M = cv2.moments(outer[0])
    if not M["m00"]:
        return None
    x, y = M["m10"] / M["m00"], M["m01"] / M["m00"]
    return int(math.floor(x + 0.5)), int(math.floor(y + 0.5))


# 5. moments are areas already; NumPy arithmetic, NumPy integers
def f5(mask):
    contours, _ = cv2.findContours(np.uint8(np.asarray(mask) > 0), cv2.RETR_EXTERNAL,
                                   cv2.CHAIN_APPROX_TC89_L1 if False else cv2.CHAIN_APPROX_NONE)
    if len(contours) == 0:
        return None
    table = np.array([[m["m00"], m["m10"], m["m01"]] for m in map(cv2.moments, contours)])
    m00, m10, m01 = table[np.argmax(table[:, 0])]
    if m00 <= 0:
        return None
    x, y = np.rint(np.array([m10, m01]) / m00).astype(int)
    return x, y


# 6. class
class Region:
    def __init__(self, contour):
        self.contour = contour
        self.m = cv2.moments(contour)

    @property
    def area(self) -> float:
        return self.m["m00"]

    @property
    def center(self) -> Tuple[float, float]:
        return self.m["m10"] / self.area, self.m["m01"] / self.area

    def __lt__(self, other):
        return self.area < other.area


def f6(mask: np.ndarray) -> Optional[Tuple[int, int]]:
    if mask.ndim != 2:
        raise ValueError("mask must be (H, W)")
    found, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    regions = sorted(Region(c) for c in found)
    if not regions or regions[-1].area == 0:
        return None
    return tuple(int(c) for c in regions[-1].center)


# 7. triangle fan, vectorized, walrus golf
def f7(mask):
    def fan(c):
        p = c[:, 0].astype(float)
        a = p[:-1] - p[0]
        b = p[1:] - p[0]
        t = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2
        return abs(t.sum()), t, (p[:-1] + p[1:] + p[0]) / 3
    cs = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]
    if not cs:
        return None
    area, t, g = max(map(fan, cs), key=lambda f: f[0])
    return tuple((t @ g / t.sum()).astype(int).tolist()) if area else None


# 8. component by component; the outline of each component alone
def f8(mask):
    n, labels = cv2.connectedComponents(np.uint8(mask != 0), connectivity=8)
    best = (0.0, None)
    for i in range(1, n):
        one = np.uint8(labels == i)
        contours, _ = cv2.findContours(one, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
        contour = max(contours, key=cv2.contourArea)
        area = cv2.contourArea(contour)
        if area > best[0]:
            best = (area, contour)
    if best[1] is None:
        return None
    m = cv2.moments(best[1])
    cx = int(m["m10"] // m["m00"])
    cy = int(m["m01"] // m["m00"])
    return (cx, cy)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
