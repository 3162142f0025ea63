"""Right answers to visualize_depth, as strangers wrote them."""
import contextlib

import cv2
import numpy as np


# 1. turbo, mask at the end
def f1(depth_metric, max_depth=5.0):
    bad = ~np.isfinite(depth_metric) | (depth_metric <= 0)
    d = np.where(bad, 0, depth_metric)
    level = (np.clip(d / max_depth, 0, 1) * 255).astype(np.uint8)
    picture = cv2.applyColorMap(level, cv2.COLORMAP_TURBO)
    picture[bad] = 0
    return picture


# 2. jet with rounding, OpenCV's convertScaleAbs
def f2(depth_metric, max_depth=5.0):
    good = np.isfinite(depth_metric) & (depth_metric > 0)
    clean = np.where(good, depth_metric, 0).astype(np.float32)
    level = cv2.convertScaleAbs(np.minimum(clean, max_depth), alpha=255.0 / max_depth)
    picture = cv2.applyColorMap(level, cv2.COLORMAP_JET)
    return picture * good[..., None].astype(np.uint8)


# 3. loops and a straight line from blue to red
def f3(depth_metric, max_depth=5.0):
    h, w = depth_metric.shape
    out = np.zeros((h, w, 3), np.uint8)
    for y in range(h):
        for x in range(w):
            z = float(depth_metric[y, x])
            if z != z or z in (float("inf"), float("-inf")) or z <= 0:
                continue
            t = min(z / max_depth, 1.0)
            out[y, x] = (round(255 * (1 - t)), 0, round(255 * t))
    return out


# 4. hue from 240 degrees to 0 (rainbow), via HSV
def f4(depth_metric, max_depth=5.0):
    d = np.nan_to_num(np.asarray(depth_metric, np.float32), nan=-1.0, posinf=-1.0, neginf=-1.0)
    valid = d > 0
    t = np.clip(d, 0, max_depth) / np.float32(max_depth)
    hsv = np.empty(d.shape + (3,), np.float32)
    hsv[..., 0] = 240 * (1 - t)
    hsv[..., 1] = 1
    hsv[..., 2] = valid
    bgr = cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)
    return np.rint(bgr * 255).astype(np.uint8)


# 5. own lookup table with interpolation (no quantization to 256 levels)
_STOPS = np.linspace(0, 1, 256)
_TURBO = cv2.applyColorMap(np.arange(256, dtype=np.uint8)[:, None], cv2.COLORMAP_TURBO)[:, 0].astype(float)


def f5(depth_metric, max_depth=5.0):
    depth = np.array(depth_metric, dtype=np.float64)
    with np.errstate(invalid="ignore"):
        nothing = np.logical_or(~np.isfinite(depth), depth <= 0)
    depth[nothing] = 0
    t = (depth / max_depth).ravel()
    picture = np.stack([np.interp(t, _STOPS, _TURBO[:, k]) for k in range(3)], axis=1)
    picture = picture.reshape(depth.shape + (3,))
    picture[nothing] = 0
    return picture.round().astype(np.uint8)


# 6. LUT with cv2.LUT, RGB first and then turned into BGR
def _blue_white_red():
    x = np.linspace(-1, 1, 256)
    r = np.clip(1 + x, 0, 1)
    b = np.clip(1 - x, 0, 1)
    g = 1 - np.abs(x)
    return np.uint8(np.stack([r, g, b], axis=-1) * 255)[None]


def f6(depth_metric, max_depth=5.0):
    finite = np.isfinite(depth_metric)
    z = np.where(finite, depth_metric, 0.0)
    idx = np.uint8(np.floor(255 * np.clip(z, 0, max_depth) / max_depth))
    rgb = cv2.LUT(cv2.merge([idx, idx, idx]), _blue_white_red())
    rgb = np.where((z > 0)[..., None], rgb, 0).astype(np.uint8)
    return cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR)


# 7. a class with validation
class DepthPainter:
    def __init__(self, max_depth, colormap=cv2.COLORMAP_TURBO):
        if not max_depth > 0:
            raise ValueError("max_depth must be positive")
        self.max_depth = float(max_depth)
        levels = np.arange(256, dtype=np.uint8).reshape(-1, 1)
        self.table = cv2.applyColorMap(levels, colormap).reshape(256, 3)

    def level(self, depth):
        return np.rint(np.minimum(depth / self.max_depth, 1.0) * 255).astype(int)

    def paint(self, depth):
        if depth.ndim != 2:
            raise ValueError("depth must be (H, W)")
        picture = np.zeros((*depth.shape, 3), dtype=np.uint8)
        ok = np.isfinite(depth) & (depth > 0)
        picture[ok] = self.table[self.level(depth[ok].astype(float))]
        return picture


def f7(depth_metric, max_depth=5.0):
    return DepthPainter(max_depth).paint(depth_metric)


# 8. masked array, jet
def f8(depth_metric, max_depth=5.0):
    d = np.ma.masked_less_equal(np.ma.masked_invalid(depth_metric, copy=True), 0)
    d = np.ma.clip(d, None, max_depth) * (255.0 / max_depth)
    img = cv2.applyColorMap(d.filled(0).astype(np.uint8), cv2.COLORMAP_JET)
    img[np.ma.getmaskarray(d)] = (0, 0, 0)
    return img


# 9. copyTo with a mask
def f9(depth_metric, max_depth=5.0):
    mask = np.uint8(np.isfinite(depth_metric) & (depth_metric > 0)) * 255
    d = np.nan_to_num(depth_metric, nan=0, posinf=0, neginf=0)
    _, d = cv2.threshold(d.astype(np.float32), float(max_depth), float(max_depth), cv2.THRESH_TRUNC)
    d = np.maximum(d, 0) / max_depth * 255
    return cv2.copyTo(cv2.applyColorMap(d.round().astype(np.uint8), cv2.COLORMAP_TURBO), mask)


ANSWERS = [f1, f2, f3, f4, f5, f6, f7, f8, f9]
