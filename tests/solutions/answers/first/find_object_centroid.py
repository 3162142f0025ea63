"""Right answers to find_object_centroid, as strangers wrote them."""
from fractions import Fraction

import cv2
import numpy as np


def with_moments(mask):
    """cv2.findContours, the contour with the largest area, cv2.moments, floor by //."""
    mask = np.asarray(mask)
    if mask.ndim != 2:
        raise ValueError("mask must be (H, W)")
    if mask.dtype not in (np.uint8, np.bool_):
        raise TypeError("mask must be uint8 or bool")
    if mask.size == 0:
        return None
    binary = (mask != 0).astype(np.uint8)
    contours, _ = cv2.findContours(binary, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return None
    m = cv2.moments(max(contours, key=cv2.contourArea))
    if m["m00"] == 0:
        return None
    return int(m["m10"] // m["m00"]), int(m["m01"] // m["m00"])


def exact_shoelace(mask):
    """Contour with every pixel, shoelace sums in Python integers: exact, no rounding before the floor."""
    a = np.asarray(mask)
    if a.dtype != bool and a.dtype != np.uint8:
        raise TypeError("uint8 or bool expected")
    if a.ndim != 2:
        raise ValueError("one channel expected")
    if not a.any():
        return None
    contours = cv2.findContours(np.where(a, 255, 0).astype(np.uint8), cv2.RETR_EXTERNAL,
                                cv2.CHAIN_APPROX_NONE)[0]
    best = (0, 0, 0)
    for contour in contours:
        points = contour.reshape(-1, 2).tolist()
        twice = six_x = six_y = 0
        for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
            cross = x0 * y1 - x1 * y0
            twice += cross
            six_x += (x0 + x1) * cross
            six_y += (y0 + y1) * cross
        if abs(twice) > abs(best[0]):
            best = (twice, six_x, six_y)
    twice, six_x, six_y = best
    if twice == 0:
        return None
    return six_x // (3 * twice), six_y // (3 * twice)


def outermost_of_a_tree(mask):
    """RETR_CCOMP and the hierarchy: only contours without a parent; a loop keeps the best."""
    image = np.array(mask)
    if image.dtype.name not in ("uint8", "bool") or image.ndim != 2:
        raise ValueError("mask must be a uint8 or bool image of one channel")
    if 0 in image.shape or np.count_nonzero(image) == 0:
        return None
    image = np.uint8(image > 0)
    contours, hierarchy = cv2.findContours(image, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    best_area, best = 0.0, None
    for contour, links in zip(contours, hierarchy[0]):
        if links[3] != -1:
            continue
        area = cv2.contourArea(contour)
        if area > best_area:
            best_area, best = area, contour
    if best is None:
        return None
    m = cv2.moments(best)
    return int(np.floor(m["m10"] / m["m00"])), int(np.floor(m["m01"] / m["m00"]))


def _fill_from_outside(region):
    """The region without its holes (background is connected over edges)."""
    padded = np.pad(np.uint8(region), 1)
    cv2.floodFill(padded, None, (0, 0), 2, flags=4)
    return padded[1:-1, 1:-1] != 2


def cells_between_pixels(mask):
    """Without contours: each region is filled, then the unit squares between pixel centers are summed in integers (a square with three corners inside is half a square)."""
    a = np.asarray(mask)
    if a.ndim != 2 or a.dtype not in (np.dtype(bool), np.dtype(np.uint8)):
        raise TypeError("mask must be uint8 or bool, (H, W)")
    if a.size == 0:
        return None
    count, labels = cv2.connectedComponents((a != 0).astype(np.uint8), connectivity=8)
    best = None
    for k in range(1, count):
        f = _fill_from_outside(labels == k).astype(np.int64)
        if min(f.shape) < 2:
            continue
        corners = [f[:-1, :-1], f[:-1, 1:], f[1:, :-1], f[1:, 1:]]
        n = sum(corners)
        y, x = np.nonzero(n >= 3)
        full = n[y, x] == 4
        area2 = np.where(full, 2, 1)  # twice the area
        # centroid of a half square: the mean of its three corners; times 6, times twice the area
        sx = corners[1][y, x] + corners[3][y, x]
        sy = corners[2][y, x] + corners[3][y, x]
        mx = np.where(full, 2 * (6 * x + 3), 6 * x + 2 * sx)
        my = np.where(full, 2 * (6 * y + 3), 6 * y + 2 * sy)
        total = int(area2.sum())
        if total and (best is None or total > best[0]):
            best = (total, int(mx.sum()), int(my.sum()))
    if best is None:
        return None
    return best[1] // (6 * best[0]), best[2] // (6 * best[0])


def fractions_of_a_polygon(mask):
    """Splits the contour into triangles around its first point and sums fractions."""
    m = np.asanyarray(mask)
    if m.ndim != 2:
        raise ValueError(f"mask has {m.ndim} dimensions")
    if m.dtype not in (np.uint8, bool):
        raise TypeError(f"mask has dtype {m.dtype}")
    if m.shape[0] * m.shape[1] == 0:
        return None
    found, _ = cv2.findContours(np.ascontiguousarray(m, dtype=bool).view(np.uint8), cv2.RETR_EXTERNAL,
                                cv2.CHAIN_APPROX_SIMPLE)
    candidates = []
    for contour in found:
        p = [(int(x), int(y)) for x, y in contour[:, 0]]
        area, cx, cy = Fraction(0), Fraction(0), Fraction(0)
        x0, y0 = p[0]
        for (x1, y1), (x2, y2) in zip(p[1:], p[2:]):
            part = Fraction((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0), 2)
            area += part
            cx += part * Fraction(x0 + x1 + x2, 3)
            cy += part * Fraction(y0 + y1 + y2, 3)
        if area != 0:
            candidates.append((abs(area), int((cx / area).__floor__()), int((cy / area).__floor__())))
    if not candidates:
        return None
    _, x, y = max(candidates)
    return x, y


class _Region:
    def __init__(self, contour):
        self.contour = contour
        self.moments = cv2.moments(contour)

    @property
    def area(self):
        return self.moments["m00"]

    def center(self):
        m = self.moments
        return tuple(int(np.floor(m[k] / m["m00"] + 1e-9)) for k in ("m10", "m01"))


def with_a_class(mask):
    """A class per region, sorted with the last of equal areas winning; a tiny bias against rounding below a whole number."""
    mask = np.asarray(mask)
    if mask.dtype != np.uint8 and mask.dtype != np.bool_:
        raise TypeError("wrong dtype")
    if mask.ndim != 2:
        raise ValueError("wrong number of dimensions")
    if not mask.size:
        return None
    thresholded = cv2.threshold(mask.astype(np.uint8), 0, 255, cv2.THRESH_BINARY)[1]
    regions = [_Region(c) for c in cv2.findContours(thresholded, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]]
    regions = sorted((r for r in regions if r.area > 0), key=lambda r: r.area)
    return regions[-1].center() if regions else None


def with_numpy_integers(mask):
    """Pads the picture and shifts the contour back; the tuple holds NumPy integers."""
    picture = np.asarray(mask)
    if picture.ndim != 2 or picture.dtype.char not in "B?":
        raise ValueError("mask must be uint8 or bool of one channel")
    frame = np.zeros((picture.shape[0] + 2, picture.shape[1] + 2), np.uint8)
    frame[1:-1, 1:-1] = picture.astype(bool)
    contours, _ = cv2.findContours(frame, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE, offset=(-1, -1))
    areas = [cv2.contourArea(c) for c in contours]
    if not areas or max(areas) <= 0:
        return None
    m = cv2.moments(contours[int(np.argmax(areas))])
    x, y = np.floor([m["m10"] / m["m00"], m["m01"] / m["m00"]]).astype(np.int64)
    return x, y


ANSWERS = [with_moments, exact_shoelace, outermost_of_a_tree, cells_between_pixels,
           fractions_of_a_polygon, with_a_class, with_numpy_integers]
