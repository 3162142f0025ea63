"""Right answers to segment_by_color, as strangers wrote them."""
from dataclasses import dataclass
from functools import reduce

import cv2
import numpy as np


# 1. inRange twice, joined
def f1(rgb_image, target_hsv_range):
    low, high = target_hsv_range
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    if low[0] <= high[0]:
        mask = cv2.inRange(hsv, tuple(low), tuple(high))
    else:
        mask = cv2.inRange(hsv, tuple(low), (179, high[1], high[2]))
        mask |= cv2.inRange(hsv, (0, low[1], low[2]), tuple(high))
    kernel = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, kernel)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, kernel)


# 2. comparisons, erode and dilate
def f2(rgb_image, target_hsv_range):
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    h, s, v = cv2.split(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV))
    hue = (h >= h0) & (h <= h1) if h0 <= h1 else (h >= h0) | (h <= h1)
    m = (hue & (s >= s0) & (s <= s1) & (v >= v0) & (v <= v1)).astype(np.uint8) * 255
    k = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
    return cv2.erode(cv2.dilate(cv2.dilate(cv2.erode(m, k), k), k), k)


# 3. LUT per channel, three square passes of 5 as 3 + 3
def f3(rgb_image, target_hsv_range):
    low, high = np.array(target_hsv_range, dtype=int)
    n = np.arange(256)
    table = (n[:, None] >= low) & (n[:, None] <= high)
    if low[0] > high[0]:
        table[:, 0] = (n >= low[0]) | (n <= high[0])
    table = (255 * table).astype(np.uint8).reshape(256, 1, 3)
    hsv = cv2.cvtColor(np.ascontiguousarray(rgb_image[..., ::-1]), cv2.COLOR_BGR2HSV)
    mask = cv2.LUT(hsv, table).min(axis=2)
    k3 = np.ones((3, 3), np.uint8)
    mask = cv2.erode(mask, k3, iterations=2)
    mask = cv2.dilate(mask, k3, iterations=4)
    return cv2.erode(mask, k3, iterations=2)


# 4. OpenCV's fixed-point HSV written out, morphology by sliding windows
_I = np.arange(1, 256)
_SDIV = np.r_[0, np.rint((255 << 12) / _I)].astype(np.int64)
_HDIV = np.r_[0, np.rint((180 << 12) / (6.0 * _I))].astype(np.int64)


def _hsv(rgb):
    r, g, b = np.moveaxis(rgb.astype(np.int64), -1, 0)
    v = np.maximum(np.maximum(r, g), b)
    d = v - np.minimum(np.minimum(r, g), b)
    s = (d * _SDIV[v] + 2048) >> 12
    h = np.where(v == r, g - b, np.where(v == g, b - r + 2 * d, r - g + 4 * d))
    h = (h * _HDIV[d] + 2048) >> 12
    return h + 180 * (h < 0), s, v


def _window(mask, function, outside):
    padded = np.pad(mask, 2, constant_values=outside)
    return function(np.lib.stride_tricks.sliding_window_view(padded, (5, 5)), axis=(2, 3))


def f4(rgb_image, target_hsv_range):
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    h, s, v = _hsv(rgb_image)
    if h0 > h1:
        hue = np.logical_not((h > h1) & (h < h0))
    else:
        hue = (h0 <= h) & (h <= h1)
    mask = hue & (s0 <= s) & (s <= s1) & (v0 <= v) & (v <= v1)
    mask = _window(mask, np.all, True)
    mask = _window(mask, np.any, False)
    mask = _window(mask, np.any, False)
    mask = _window(mask, np.all, True)
    return np.where(mask, 255, 0).astype(np.uint8)


# 5. chessboard distances instead of morphology
def _shrink(mask):
    if mask.all():
        return mask.copy()
    return cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_C, 3) > 2.5


def _grow(mask):
    return ~_shrink(~mask)


def f5(rgb_image, target_hsv_range):
    low, high = (np.asarray(limit) for limit in target_hsv_range)
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    above, below = hsv >= low, hsv <= high
    inside = above & below
    if low[0] > high[0]:
        inside[..., 0] = above[..., 0] | below[..., 0]
    mask = inside.all(axis=2)
    return _shrink(_grow(_grow(_shrink(mask)))).astype(np.uint8) * 255


# 6. class, hue shifted so that no range wraps
@dataclass(frozen=True)
class _HsvRange:
    low: tuple
    high: tuple

    def __post_init__(self):
        if len(self.low) != 3 or len(self.high) != 3:
            raise ValueError("limits are (h, s, v)")

    def contains(self, hsv):
        shifted = hsv.astype(np.int32)
        span = (int(self.high[0]) - int(self.low[0])) % 180 if self.low[0] > self.high[0] \
            else min(int(self.high[0]), 179) - int(self.low[0])
        shifted[..., 0] = (shifted[..., 0] - int(self.low[0])) % 180
        lo = np.array([0, self.low[1], self.low[2]])
        hi = np.array([span, self.high[1], self.high[2]])
        return np.all((shifted >= lo) & (shifted <= hi), axis=-1)


class _Cleaner:
    def __init__(self, size=5):
        self.kernel = np.ones((size, size), np.uint8)

    def __call__(self, mask):
        return reduce(lambda m, op: cv2.morphologyEx(m, op, self.kernel),
                      (cv2.MORPH_OPEN, cv2.MORPH_CLOSE), mask)


def f6(rgb_image: np.ndarray, target_hsv_range: tuple) -> np.ndarray:
    if rgb_image.ndim != 3 or rgb_image.dtype != np.uint8:
        raise ValueError("need an 8-bit RGB picture")
    low, high = target_hsv_range
    inside = _HsvRange(tuple(low), tuple(high)).contains(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV))
    return _Cleaner()(np.uint8(inside) * np.uint8(255))


# 7. C programmer: loops; separable window of rows, then columns
def _pass(mask, want, H, W):
    # a pixel becomes `want` if any pixel of its 5x5 window (inside the picture) is `want`
    rows = [[0] * W for _ in range(H)]
    for y in range(H):
        for x in range(W):
            rows[y][x] = int(want in mask[y][max(0, x - 2):x + 3])
    out = [[0] * W for _ in range(H)]
    for y in range(H):
        for x in range(W):
            hit = any(rows[j][x] for j in range(max(0, y - 2), min(H, y + 3)))
            out[y][x] = want if hit else 255 - want
    return out


def f7(rgb_image, target_hsv_range):
    low, high = target_hsv_range
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).tolist()
    H, W = len(hsv), len(hsv[0])
    mask = [[0] * W for _ in range(H)]
    for y in range(H):
        for x in range(W):
            h, s, v = hsv[y][x]
            if low[0] > high[0]:
                ok = h >= low[0] or h <= high[0]
            else:
                ok = low[0] <= h <= high[0]
            if ok and low[1] <= s <= high[1] and low[2] <= v <= high[2]:
                mask[y][x] = 255
    for want in (0, 255, 255, 0):
        mask = _pass(mask, want, H, W)
    return np.array(mask, dtype=np.uint8)


# 8. filter2D counts neighbors
def f8(rgb_image, target_hsv_range):
    a, b = map(np.int16, target_hsv_range)
    x = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(np.int16)
    ge, le = x >= a, x <= b
    join = np.logical_or if a[0] > b[0] else np.logical_and
    m = join(ge[..., 0], le[..., 0]) & (ge & le)[..., 1:].all(-1)
    count = lambda z: cv2.filter2D(z.astype(np.float32), -1, np.ones((5, 5), np.float32), borderType=cv2.BORDER_CONSTANT)
    near = lambda z: count(z) > .5
    m = ~near(~m)
    m = near(m)
    m = near(m)
    m = ~near(~m)
    return m.astype(np.uint8) * np.uint8(255)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
