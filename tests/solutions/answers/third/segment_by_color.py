"""Right answers to segment_by_color, as strangers wrote them."""
import cv2
import numpy as np


# 1. the book's way
def segment_inrange(rgb_image, target_hsv_range):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    low, high = (np.array(limit) for limit in target_hsv_range)
    if low[0] <= high[0]:
        mask = cv2.inRange(hsv, low, high)
    else:
        mask = cv2.inRange(hsv, low, np.array([179, high[1], high[2]]))
        mask |= cv2.inRange(hsv, np.array([0, low[1], low[2]]), high)
    kernel = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, kernel)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, kernel)


# 2. NumPy comparisons, getStructuringElement, BGR detour
def segment_numpy(rgb_image, target_hsv_range):
    bgr = np.ascontiguousarray(rgb_image[:, :, ::-1])
    h, s, v = np.moveaxis(cv2.cvtColor(bgr, cv2.COLOR_BGR2HSV), 2, 0)
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    hue = (h >= h0) & (h <= h1) if h0 <= h1 else (h >= h0) | (h <= h1)
    inside = hue & (s >= s0) & (s <= s1) & (v >= v0) & (v <= v1)
    mask = np.where(inside, 255, 0).astype(np.uint8)
    box = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
    return cv2.morphologyEx(cv2.morphologyEx(mask, cv2.MORPH_OPEN, box), cv2.MORPH_CLOSE, box)


# 3. beginner: loops, hand-made erosion and dilation
def _erode_slow(mask):
    height, width = mask.shape
    result = np.zeros((height, width), np.uint8)
    for row in range(height):
        for column in range(width):
            smallest = 255
            for r in range(max(0, row - 2), min(height, row + 3)):
                for c in range(max(0, column - 2), min(width, column + 3)):
                    if mask[r, c] < smallest:
                        smallest = mask[r, c]
            result[row, column] = smallest
    return result


def _dilate_slow(mask):
    return 255 - _erode_slow(255 - mask)


def segment_beginner(rgb_image, target_hsv_range):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    low = target_hsv_range[0]
    high = target_hsv_range[1]
    height, width, _ = hsv.shape
    mask = np.zeros((height, width), np.uint8)
    for row in range(height):
        for column in range(width):
            h = int(hsv[row, column, 0])
            s = int(hsv[row, column, 1])
            v = int(hsv[row, column, 2])
            if low[0] > high[0]:
                good_hue = h >= low[0] or h <= high[0]
            else:
                good_hue = h >= low[0] and h <= high[0]
            if good_hue and low[1] <= s <= high[1] and low[2] <= v <= high[2]:
                mask[row, column] = 255
    mask = _dilate_slow(_erode_slow(mask))
    mask = _erode_slow(_dilate_slow(mask))
    return mask


# 4. look-up tables, then sliding windows with a padded border
def _window(mask, pad, reduce):
    padded = np.pad(mask, 2, constant_values=pad)
    return reduce(np.lib.stride_tricks.sliding_window_view(padded, (5, 5)), axis=(2, 3))


def segment_lut(rgb_image, target_hsv_range):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    table = np.zeros((1, 256, 3), np.uint8)
    low, high = target_hsv_range
    for channel in range(3):
        numbers = np.arange(256)
        if channel == 0 and low[0] > high[0]:
            on = (numbers >= low[0]) | (numbers <= high[0])
        else:
            on = (numbers >= low[channel]) & (numbers <= high[channel])
        table[0, on, channel] = 255
    mask = cv2.LUT(hsv, table).min(axis=2)
    for pad, reduce in ((255, np.min), (0, np.max), (0, np.max), (255, np.min)):
        mask = _window(mask, pad, reduce)
    return mask


# 5. own HSV in OpenCV's integer arithmetic; distance transform for morphology
_V = np.arange(256, dtype=np.float64)
with np.errstate(divide="ignore"):
    _SDIV = np.where(_V > 0, np.rint((255 << 12) / _V), 0).astype(np.int64)
    _HDIV = np.where(_V > 0, np.rint((180 << 12) / (6.0 * _V)), 0).astype(np.int64)


def _hsv_by_hand(rgb):
    r, g, b = rgb.astype(np.int64).transpose(2, 0, 1)
    v = np.maximum(np.maximum(r, g), b)
    c = v - np.minimum(np.minimum(r, g), b)
    h = np.where(v == r, g - b, np.where(v == g, b - r + 2 * c, r - g + 4 * c))
    h = (h * _HDIV[c] + 2048) >> 12
    h = np.where(h < 0, h + 180, h)
    s = (c * _SDIV[v] + 2048) >> 12
    return h, s, v


def _grow(mask):
    if not mask.any():
        return mask
    if mask.all():
        return mask
    away = cv2.distanceTransform(255 - mask, cv2.DIST_C, 3)
    return np.where(away <= 2, 255, 0).astype(np.uint8)


def segment_by_hand(rgb_image, target_hsv_range):
    h, s, v = _hsv_by_hand(rgb_image)
    (a, s0, v0), (b, s1, v1) = target_hsv_range
    if a <= b:
        hue = np.logical_and(a <= h, h <= b)
    else:
        hue = np.logical_not(np.logical_and(b < h, h < a))
    mask = np.uint8(255) * (hue & (s0 <= s) & (s <= s1) & (v0 <= v) & (v <= v1)).astype(np.uint8)
    shrink = lambda m: 255 - _grow(255 - m)
    return shrink(_grow(_grow(shrink(mask))))


# 6. separable erode and dilate, anchor and iterations spelled out
def segment_separable(rgb_image, target_hsv_range):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    lo, hi = (tuple(int(a) for a in limit) for limit in target_hsv_range)
    if lo[0] > hi[0]:
        # inside is what is not in the gap
        gap = np.uint8(255) - cv2.inRange(hsv, (hi[0] + 1, 0, 0), (lo[0] - 1, 255, 255))
        mask = cv2.bitwise_and(gap, cv2.inRange(hsv, (0,) + lo[1:], (255,) + hi[1:]))
    else:
        mask = cv2.inRange(hsv, lo, hi)
    row, column = np.ones((1, 5), np.uint8), np.ones((5, 1), np.uint8)
    mask = cv2.erode(cv2.erode(mask, row), column)
    mask = cv2.dilate(cv2.dilate(mask, row), column)
    mask = cv2.dilate(cv2.dilate(mask, column), row)
    return cv2.erode(cv2.erode(mask, column), row)


# 7. Java
class HsvRange:
    def __init__(self, low, high):
        if len(low) != 3 or len(high) != 3:
            raise ValueError("limits have three numbers")
        self.low, self.high = [int(a) for a in low], [int(a) for a in high]

    def wraps(self):
        return self.low[0] > self.high[0]

    def parts(self):
        if not self.wraps():
            yield tuple(self.low), tuple(self.high)
            return
        yield tuple(self.low), (255, self.high[1], self.high[2])
        yield (0, self.low[1], self.low[2]), tuple(self.high)


class Segmenter:
    KERNEL = np.ones((5, 5), np.uint8)

    def __init__(self, hsv_range):
        self.range = hsv_range

    def __call__(self, image):
        if image.dtype != np.uint8 or image.ndim != 3:
            raise TypeError("need an RGB picture of bytes")
        hsv = cv2.cvtColor(image, cv2.COLOR_RGB2HSV)
        mask = np.zeros(image.shape[:2], np.uint8)
        for low, high in self.range.parts():
            cv2.bitwise_or(mask, cv2.inRange(hsv, low, high), dst=mask)
        for operation in (cv2.MORPH_ERODE, cv2.MORPH_DILATE, cv2.MORPH_DILATE, cv2.MORPH_ERODE):
            mask = cv2.morphologyEx(mask, operation, self.KERNEL)
        return mask


def segment_java(rgb_image, target_hsv_range):
    return Segmenter(HsvRange(*target_hsv_range))(rgb_image)


# 8. counting with box filters: a 5x5 sum of 25 is all white, above 0 is some white
def _count(mask01):
    return cv2.filter2D(mask01.astype(np.float32), -1, np.ones((5, 5), np.float32),
                        borderType=cv2.BORDER_CONSTANT)


def segment_counting(rgb_image, target_hsv_range):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(np.int32)
    low, high = np.array(target_hsv_range, dtype=np.int32)
    if low[0] > high[0]:
        hsv[..., 0] = (hsv[..., 0] - low[0]) % 180     # turn the circle: low becomes 0
        high = high + [180 - low[0], 0, 0]
        low = low * [0, 1, 1]
    m = np.all((hsv >= low) & (hsv <= high), axis=-1)
    erode = lambda m: _count(~m) < 0.5
    dilate = lambda m: _count(m) > 0.5
    m = erode(dilate(dilate(erode(m))))
    return m.astype(np.uint8) * 255


ANSWERS = [segment_inrange, segment_numpy, segment_beginner, segment_lut, segment_by_hand,
           segment_separable, segment_java, segment_counting]
