"""Right answers to segment_by_color, as strangers wrote them."""
import contextlib
from typing import NamedTuple

import cv2
import numpy as np
from numpy.lib.stride_tricks import sliding_window_view


# 1. inRange twice
def f1(rgb_image, target_hsv_range):
    low, high = target_hsv_range
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    if low[0] <= high[0]:
        mask = cv2.inRange(hsv, np.array(low), np.array(high))
    else:
        mask = cv2.bitwise_or(
            cv2.inRange(hsv, np.array(low), np.array([179, high[1], high[2]])),
            cv2.inRange(hsv, np.array([0, low[1], low[2]]), np.array(high)))
    kernel = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, kernel)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, kernel)


# 2. comparisons in NumPy, int16
def f2(rgb_image, target_hsv_range):
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    h, s, v = np.moveaxis(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(np.int16), 2, 0)
    hue = (h >= h0) | (h <= h1) if h0 > h1 else (h >= h0) & (h <= h1)
    m = (hue & (s >= s0) & (s <= s1) & (v >= v0) & (v <= v1)).astype(np.uint8) * 255
    k = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
    m = cv2.dilate(cv2.erode(m, k), k)
    return cv2.erode(cv2.dilate(m, k), k)


# 3. via BGR, because the documentation of OpenCV is BGR; morphology by hand with padding
def _grow(mask):
    p = np.pad(mask, 2, constant_values=False)
    return sliding_window_view(p, (5, 5)).any(axis=(2, 3))


def _shrink(mask):
    p = np.pad(mask, 2, constant_values=True)
    return sliding_window_view(p, (5, 5)).all(axis=(2, 3))


def f3(rgb_image, target_hsv_range):
    bgr = np.ascontiguousarray(rgb_image[..., ::-1])
    hsv = cv2.cvtColor(bgr, cv2.COLOR_BGR2HSV)
    low, high = np.array(target_hsv_range)
    inside = (hsv >= low) & (hsv <= high)
    if low[0] > high[0]:
        inside[..., 0] = ~((hsv[..., 0] < low[0]) & (hsv[..., 0] > high[0]))
    mask = inside.all(axis=2)
    mask = _shrink(_grow(_grow(_shrink(mask))))
    return np.where(mask, 255, 0).astype(np.uint8)


# 4. lookup tables per channel
def f4(rgb_image, target_hsv_range):
    low, high = target_hsv_range
    lut = np.zeros((1, 256, 3), np.uint8)
    for c in range(3):
        for x in range(256):
            if c == 0 and low[0] > high[0]:
                ok = x >= low[0] or x <= high[0]
            else:
                ok = low[c] <= x <= high[c]
            lut[0, x, c] = 255 if ok else 0
    m = cv2.LUT(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV), lut).min(axis=2)
    for op in (cv2.MORPH_OPEN, cv2.MORPH_CLOSE):
        m = cv2.morphologyEx(m, op, np.ones((5, 5)).astype("uint8"))
    return m


# 5. roll the hue so that the range starts at zero; filter by counting
def f5(rgb_image, target_hsv_range):
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    hsv = cv2.cvtColor(rgb_image.copy(), cv2.COLOR_RGB2HSV).astype(int)
    span = (h1 - h0) % 180 if h0 > h1 else h1 - h0
    hue_ok = (hsv[:, :, 0] - h0) % 180 <= span
    mask = hue_ok * (hsv[:, :, 1] >= s0) * (hsv[:, :, 1] <= s1) * (hsv[:, :, 2] >= v0) * (hsv[:, :, 2] <= v1)
    box = np.ones((5, 5), np.float32)
    total = cv2.filter2D(np.ones(mask.shape, np.float32), -1, box, borderType=cv2.BORDER_CONSTANT)
    count = lambda m: cv2.filter2D(m.astype(np.float32), -1, box, borderType=cv2.BORDER_CONSTANT)
    dil = lambda m: count(m) > 0.5
    ero = lambda m: count(m) > total - 0.5
    return ero(dil(dil(ero(mask)))).astype(np.uint8) * 255


# 6. class
class HSVLimits(NamedTuple):
    h: int
    s: int
    v: int


class ColorSegmenter:
    KERNEL = np.ones((5, 5), np.uint8)

    def __init__(self, low, high):
        self.low, self.high = HSVLimits(*map(int, low)), HSVLimits(*map(int, high))

    def _ranges(self):
        if self.low.h <= self.high.h:
            yield self.low, self.high
        else:
            yield self.low, self.high._replace(h=255)
            yield self.low._replace(h=0), self.high

    def __call__(self, rgb):
        if rgb.dtype != np.uint8 or rgb.ndim != 3 or rgb.shape[2] != 3:
            raise TypeError("uint8 RGB expected")
        hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
        mask = np.zeros(rgb.shape[:2], np.uint8)
        for low, high in self._ranges():
            mask |= cv2.inRange(hsv, low, high)
        opened = cv2.morphologyEx(mask, cv2.MORPH_OPEN, self.KERNEL)
        return cv2.morphologyEx(opened, cv2.MORPH_CLOSE, self.KERNEL)


def f6(rgb_image, target_hsv_range):
    return ColorSegmenter(*target_hsv_range)(rgb_image)


# 7. physicist: OpenCV's integer HSV written out; separable min and max
_I = np.arange(1, 256)
_S_DIV = np.concatenate([[0], np.rint((255 << 12) / _I)]).astype(int)
_H_DIV = np.concatenate([[0], np.rint((180 << 12) / (6.0 * _I))]).astype(int)


def _to_hsv(rgb):
    r, g, b = (rgb[..., k].astype(int) for k in range(3))
    v = rgb.max(axis=2).astype(int)
    diff = v - rgb.min(axis=2)
    s = (diff * _S_DIV[v] + (1 << 11)) >> 12
    h = np.where(v == r, g - b, np.where(v == g, b - r + 2 * diff, r - g + 4 * diff))
    h = (h * _H_DIV[diff] + (1 << 11)) >> 12
    return np.where(h < 0, h + 180, h), s, v


def _separable(mask, op, fill):
    h, w = mask.shape
    p = np.pad(mask, ((2, 2), (0, 0)), constant_values=fill)
    mask = op.reduce([p[i:i + h] for i in range(5)])
    p = np.pad(mask, ((0, 0), (2, 2)), constant_values=fill)
    return op.reduce([p[:, i:i + w] for i in range(5)])


def f7(rgb_image, target_hsv_range):
    low, high = target_hsv_range
    h, s, v = _to_hsv(rgb_image)
    wrap = low[0] > high[0]
    in_h = np.logical_or(h >= low[0], h <= high[0]) if wrap else np.logical_and(h >= low[0], h <= high[0])
    m = in_h & (s >= low[1]) & (s <= high[1]) & (v >= low[2]) & (v <= high[2])
    m = np.uint8(255) * m.astype(np.uint8)
    for op, fill in ((np.minimum, 255), (np.maximum, 0), (np.maximum, 0), (np.minimum, 255)):
        m = _separable(m, op, fill)
    return m


# 8. the complement of the hues between; functools style
def f8(rgb_image, target_hsv_range):
    low, high = [list(map(float, x)) for x in target_hsv_range]
    hsv = cv2.cvtColor(np.array(rgb_image), cv2.COLOR_RGB2HSV)
    hue, sat, val = cv2.split(hsv)
    inside = lambda c, a, b: cv2.inRange(c, a, b)
    if low[0] > high[0]:
        between = (hue > high[0]) & (hue < low[0])
        hue_mask = np.where(between, np.uint8(0), np.uint8(255))
    else:
        hue_mask = inside(hue, low[0], high[0])
    mask = cv2.min(hue_mask, cv2.min(inside(sat, low[1], high[1]), inside(val, low[2], high[2])))
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((5, 5), np.uint8), iterations=1)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((5, 5), np.uint8), iterations=1)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
