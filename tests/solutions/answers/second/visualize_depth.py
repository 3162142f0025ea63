"""Right answers to visualize_depth, as strangers wrote them."""
import colorsys
from dataclasses import dataclass

import cv2
import numpy as np


# 1. turbo, rounded
def f1(depth_metric, max_depth=5.0):
    valid = np.isfinite(depth_metric) & (depth_metric > 0)
    scaled = np.where(valid, depth_metric, 0) / max_depth
    gray = np.uint8(np.round(255 * np.clip(scaled, 0, 1)))
    picture = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    picture[~valid] = 0
    return picture


# 2. jet, cut off
def f2(depth_metric, max_depth=5.0):
    d = np.nan_to_num(depth_metric, nan=0.0, posinf=0.0, neginf=0.0)
    bad = d <= 0
    d8 = (np.minimum(np.maximum(d, 0), max_depth) / max_depth * 255).astype(np.uint8)
    out = cv2.applyColorMap(d8, cv2.COLORMAP_JET)
    return np.where(bad[..., None], 0, out).astype(np.uint8)


# 3. by hand: hue from 240 down to 0 degrees, in OpenCV's HSV
def f3(depth_metric, max_depth=5.0):
    ok = np.isfinite(depth_metric) & (depth_metric > 0)
    t = np.zeros(depth_metric.shape)
    t[ok] = np.minimum(depth_metric[ok] / max_depth, 1)
    hsv = np.full(t.shape + (3,), 255, np.uint8)
    hsv[..., 0] = np.rint(120 * (1 - t))
    hsv[..., 2] = 255 * ok
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)


# 4. C programmer: straight line from blue to red
def f4(depth_metric, max_depth=5.0):
    H, W = depth_metric.shape
    bgr = np.zeros((H, W, 3), np.uint8)
    for y in range(H):
        for x in range(W):
            d = float(depth_metric[y, x])
            if not np.isfinite(d) or d <= 0:
                continue
            t = min(d / max_depth, 1.0)
            bgr[y, x, 0] = int(255 * (1 - t) + 0.5)
            bgr[y, x, 2] = int(255 * t + 0.5)
    return bgr


# 5. piecewise linear, interpolated: blue, cyan, green, yellow, red
def f5(depth_metric, max_depth=5.0):
    stops = np.linspace(0, max_depth, 5)
    blue, green, red = [255, 255, 0, 0, 0], [0, 255, 255, 255, 0], [0, 0, 0, 255, 255]
    known = np.isfinite(depth_metric) & (depth_metric > 0)
    d = np.where(known, depth_metric, 0.0)
    out = np.dstack([np.interp(d, stops, c) for c in (blue, green, red)])
    out *= known[:, :, None]
    return out.astype(np.uint8)


# 6. a table of 256 colors and a 257th, black; LUT by indexing; colors of colorsys
_TABLE = np.array([[round(255 * c) for c in colorsys.hsv_to_rgb(2 / 3 * (1 - i / 255), 1, 1)][::-1]
                   for i in range(256)] + [[0, 0, 0]], dtype=np.uint8)


def f6(depth_metric, max_depth=5.0):
    with np.errstate(invalid="ignore"):
        seen = (depth_metric > 0) & (depth_metric < np.inf)
        index = np.floor(np.clip(depth_metric / max_depth, 0, 1) * 255)
    return _TABLE[np.where(seen, np.nan_to_num(index), 256).astype(np.intp)]


# 7. a masked array, turbo, float32
@dataclass
class _DepthPainter:
    max_depth: float = 5.0
    colormap: int = cv2.COLORMAP_TURBO

    def __post_init__(self):
        if self.max_depth <= 0:
            raise ValueError("max_depth must be positive")

    def paint(self, depth):
        m = np.ma.masked_invalid(np.array(depth, np.float32))
        m = np.ma.masked_less_equal(m, 0)
        scaled = np.ma.minimum(m / np.float32(self.max_depth), np.float32(1)) * np.float32(255)
        colored = cv2.applyColorMap(scaled.filled(0).astype(np.uint8), self.colormap)
        colored[np.ma.getmaskarray(m)] = (0, 0, 0)
        return colored


def f7(depth_metric: np.ndarray, max_depth: float = 5.0) -> np.ndarray:
    return _DepthPainter(max_depth).paint(depth_metric)


# 8. cool to warm through white, convertScaleAbs
def f8(depth_metric, max_depth=5.0):
    keep = np.logical_and(np.isfinite(depth_metric), depth_metric > 0)
    clean = np.where(keep, np.minimum(depth_metric, max_depth), 0).astype(np.float32)
    t = cv2.convertScaleAbs(clean, alpha=255 / max_depth)
    ramp = np.arange(256)
    lut = np.stack([np.clip(510 - 2 * ramp, 0, 255), np.minimum(2 * ramp, 510 - 2 * ramp),
                    np.clip(2 * ramp, 0, 255)], axis=1).astype(np.uint8).reshape(256, 1, 3)
    picture = cv2.LUT(cv2.merge([t, t, t]), lut)
    return cv2.bitwise_and(picture, picture, mask=keep.astype(np.uint8))


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8]
