"""Right answers to segment_by_color, as strangers wrote them."""
import cv2
import numpy as np

_TOP = (179, 255, 255)


def with_in_range(rgb_image, target_hsv_range):
    """cv2.inRange once, or twice where the hue wraps; morphologyEx with 5x5 ones."""
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.uint8:
        raise TypeError("the picture must be uint8")
    if rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("the picture must have shape (H, W, 3)")
    low, high = _check_range(target_hsv_range)
    if rgb.size == 0:
        return np.zeros(rgb.shape[:2], np.uint8)
    hsv = cv2.cvtColor(np.ascontiguousarray(rgb), cv2.COLOR_RGB2HSV)
    if low[0] <= high[0]:
        mask = cv2.inRange(hsv, tuple(low), tuple(high))
    else:
        mask = cv2.bitwise_or(cv2.inRange(hsv, (low[0], low[1], low[2]), (179, high[1], high[2])),
                              cv2.inRange(hsv, (0, low[1], low[2]), (high[0], high[1], high[2])))
    square = np.ones((5, 5), np.uint8)
    mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, square)
    return cv2.morphologyEx(mask, cv2.MORPH_CLOSE, square)


def _check_range(target):
    """Two triples of whole numbers within OpenCV's limits."""
    bounds = np.asarray(target)
    if bounds.dtype.kind not in "iuf":
        raise TypeError("the range must be numbers")
    if bounds.shape != (2, 3):
        raise ValueError("the range must be two triples")
    if not np.all((bounds >= 0) & (bounds <= _TOP)) or np.any(bounds != np.round(bounds)):
        raise ValueError("a limit is outside OpenCV's limits")
    low, high = bounds.astype(int).tolist()
    if low[1] > high[1] or low[2] > high[2]:
        raise ValueError("low must not exceed high for saturation and value")
    return low, high


def numpy_comparisons(rgb_image, target_hsv_range):
    """Channel by channel with >= and <= (limits may be fractions); erode and dilate one by one."""
    picture = np.array(rgb_image)
    if picture.dtype != np.uint8 or picture.ndim != 3 or picture.shape[-1] != 3:
        raise TypeError(f"no uint8 RGB picture: {picture.dtype}, {picture.shape}")
    if len(target_hsv_range) != 2 or any(len(t) != 3 for t in target_hsv_range):
        raise ValueError("two triples, please")
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    if not (0 <= h0 <= 179 and 0 <= h1 <= 179):
        raise ValueError("hue must be 0 to 179")
    if not (0 <= s0 <= s1 <= 255 and 0 <= v0 <= v1 <= 255):
        raise ValueError("saturation and value must be ordered and 0 to 255")
    if 0 in picture.shape:
        return np.zeros(picture.shape[:2], dtype=np.uint8)
    h, s, v = cv2.split(cv2.cvtColor(picture, cv2.COLOR_RGB2HSV))
    hue = np.logical_and(h >= h0, h <= h1) if h0 <= h1 else np.logical_or(h >= h0, h <= h1)
    inside = hue & (s >= s0) & (s <= s1) & (v >= v0) & (v <= v1)
    mask = np.where(inside, 255, 0).astype(np.uint8)
    kernel = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
    for step in (cv2.erode, cv2.dilate, cv2.dilate, cv2.erode):
        mask = step(mask, kernel)
    return mask


def lookup_tables(rgb_image, target_hsv_range):
    """A table of 256 bytes per channel and cv2.LUT; a BGR detour on the way to HSV."""
    a = np.asarray(rgb_image)
    if a.dtype != np.uint8:
        raise ValueError(f"dtype {a.dtype}")
    if a.ndim != 3 or a.shape[2] != 3:
        raise ValueError(f"shape {a.shape}")
    low, high = _check_range(target_hsv_range)
    if min(a.shape[:2]) == 0:
        return np.empty(a.shape[:2], dtype=np.uint8)
    numbers = np.arange(256)
    tables = np.zeros((256, 3), np.uint8)
    for k in range(3):
        inside = (numbers >= low[k]) & (numbers <= high[k])
        if k == 0 and low[0] > high[0]:
            inside = (numbers >= low[0]) | (numbers <= high[0])
        tables[inside, k] = 255
    hsv = cv2.cvtColor(np.ascontiguousarray(a[:, :, ::-1]), cv2.COLOR_BGR2HSV)
    mask = cv2.LUT(hsv, tables.reshape(1, 256, 3)).min(axis=2)
    ones = np.ones((5, 5))
    opened = cv2.dilate(cv2.erode(mask, ones), ones)
    return cv2.erode(cv2.dilate(opened, ones), ones)


def _hsv_by_hand(rgb):
    """OpenCV's 8-bit HSV in integer arithmetic."""
    r, g, b = (rgb[..., k].astype(np.int64) for k in range(3))
    v = np.maximum(np.maximum(r, g), b)
    c = v - np.minimum(np.minimum(r, g), b)
    n = np.arange(1, 256)
    by_value = np.concatenate([[0], np.rint((255 << 12) / n)]).astype(np.int64)
    by_chroma = np.concatenate([[0], np.rint((180 << 12) / (6.0 * n))]).astype(np.int64)
    s = (c * by_value[v] + (1 << 11)) >> 12
    h = np.where(v == r, g - b, np.where(v == g, b - r + 2 * c, r - g + 4 * c))
    h = (h * by_chroma[c] + (1 << 11)) >> 12
    return np.where(h < 0, h + 180, h), s, v


def _extreme(mask, function):
    """Maximum or minimum over 5x5, in two passes; outside the picture nothing counts."""
    neutral = 0 if function is np.maximum else 255
    H, W = mask.shape
    p = np.pad(mask, ((2, 2), (0, 0)), constant_values=neutral)
    mask = function.reduce([p[i:i + H] for i in range(5)])
    p = np.pad(mask, ((0, 0), (2, 2)), constant_values=neutral)
    return function.reduce([p[:, j:j + W] for j in range(5)])


def without_opencv(rgb_image, target_hsv_range):
    """HSV by hand in integers (equal to OpenCV's for all colors), morphology in NumPy, OpenCV's border."""
    rgb = np.asarray(rgb_image)
    if rgb.dtype.name != "uint8" or rgb.shape[2:] != (3,):
        raise TypeError("an RGB picture of uint8 is needed")
    low, high = _check_range(target_hsv_range)
    h, s, v = _hsv_by_hand(rgb)
    hue = (h - low[0]) % 180 <= (high[0] - low[0]) % 180
    inside = hue & (low[1] <= s) & (s <= high[1]) & (low[2] <= v) & (v <= high[2])
    mask = np.where(inside, np.uint8(255), np.uint8(0))
    for function in (np.minimum, np.maximum, np.maximum, np.minimum):
        mask = _extreme(mask, function)
    return mask


class _HSVRange:
    def __init__(self, low, high):
        self.low, self.high = tuple(low), tuple(high)
        if len(self.low) != 3 or len(self.high) != 3:
            raise ValueError("a limit is no triple")
        for number, top in zip(self.low + self.high, _TOP + _TOP):
            if not 0 <= number <= top:
                raise ValueError(f"{number!r} is not within 0 and {top}")
            if number != int(number):
                raise ValueError(f"{number!r} is no whole number")
        for channel, a, b in zip("sv", self.low[1:], self.high[1:]):
            if a > b:
                raise ValueError(f"{channel}: {a} > {b}")

    def split(self):
        if self.low[0] <= self.high[0]:
            return [(self.low, self.high)]
        return [(self.low, (179,) + self.high[1:]), ((0,) + self.low[1:], self.high)]


def with_a_class(rgb_image, target_hsv_range, size=5):
    """A range class that splits itself; morphology on bool pictures by counting with box sums."""
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.dtype("uint8"):
        raise TypeError("uint8 only")
    if rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("three channels only")
    low, high = target_hsv_range
    parts = _HSVRange(low, high).split()
    if not rgb.size:
        return np.zeros(rgb.shape[:2], np.uint8)
    hsv = cv2.cvtColor(rgb.copy(), cv2.COLOR_RGB2HSV).astype(int)
    inside = np.zeros(rgb.shape[:2], bool)
    for a, b in parts:
        inside |= ((hsv >= np.array(a)) & (hsv <= np.array(b))).all(axis=2)

    def any_near(m):
        count = cv2.boxFilter(m.astype(np.float32), -1, (size, size), normalize=False, borderType=cv2.BORDER_CONSTANT)
        return count > 0.5

    opened = any_near(~any_near(~inside))  # dilation of the erosion
    closed = ~any_near(~any_near(opened))
    return np.uint8(255) * closed.astype(np.uint8)


def lists_allowed(rgb_image, target_hsv_range):
    """Takes nested lists of whole numbers from 0 to 255 for a picture too (arrays must be uint8)."""
    if isinstance(rgb_image, (list, tuple)):
        values = np.array(rgb_image)
        if values.dtype.kind not in "iu" or values.size and not (0 <= values.min() and values.max() <= 255):
            raise TypeError("the list holds no bytes")
        rgb_image = values.astype(np.uint8)
    rgb = np.asarray(rgb_image)
    if rgb.dtype != np.uint8:
        raise TypeError("uint8, please")
    if rgb.ndim != 3 or rgb.shape[2] != 3:
        raise ValueError("RGB, please")
    if rgb.shape[0] == 0 or rgb.shape[1] == 0:
        raise ValueError("an empty picture has no pixels to mark")
    low, high = _check_range(target_hsv_range)
    hsv = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)
    if low[0] > high[0]:  # the complement of the hues between
        mask = cv2.inRange(hsv, (0, low[1], low[2]), (179, high[1], high[2]))
        if low[0] - high[0] > 1:
            mask &= ~cv2.inRange(hsv, (high[0] + 1, 0, 0), (low[0] - 1, 255, 255))
    else:
        mask = cv2.inRange(hsv, np.array(low, np.uint8), np.array(high, np.uint8))
    kernel = np.ones((5, 5), dtype=np.uint8)
    return cv2.morphologyEx(cv2.morphologyEx(mask, cv2.MORPH_OPEN, kernel), cv2.MORPH_CLOSE, kernel)


ANSWERS = [with_in_range, numpy_comparisons, lookup_tables, without_opencv, with_a_class, lists_allowed]
