"""Right answers to visualize_depth, as strangers wrote them."""
import colorsys
import math

import cv2
import numpy as np


# 1. turbo
def show_turbo(depth_metric, max_depth=5.0):
    valid = np.isfinite(depth_metric) & (depth_metric > 0)
    scaled = np.clip(np.where(valid, depth_metric, 0) / max_depth, 0, 1)
    picture = cv2.applyColorMap((255 * scaled).astype(np.uint8), cv2.COLORMAP_TURBO)
    picture[~valid] = 0
    return picture


# 2. jet, rounded
def show_jet(depth_metric, max_depth=5.0):
    d = np.nan_to_num(depth_metric, nan=-1.0, posinf=-1.0, neginf=-1.0)
    gray = np.uint8(np.rint(np.minimum(np.maximum(d, 0), max_depth) * (255.0 / max_depth)))
    colored = cv2.applyColorMap(gray, cv2.COLORMAP_JET)
    return np.where((d > 0)[:, :, None], colored, np.uint8(0))


# 3. beginner: blue to red by hand, pixel by pixel
def show_beginner(depth_metric, max_depth=5.0):
    height = depth_metric.shape[0]
    width = depth_metric.shape[1]
    picture = np.zeros((height, width, 3), dtype=np.uint8)
    for v in range(height):
        for u in range(width):
            d = float(depth_metric[v, u])
            if math.isnan(d) or math.isinf(d) or d <= 0:
                continue                      # stays black
            part = d / max_depth
            if part > 1:
                part = 1
            picture[v, u, 0] = int(round(255 * (1 - part)))   # blue
            picture[v, u, 1] = 0                              # green
            picture[v, u, 2] = int(round(255 * part))         # red
    return picture


# 4. hue from 240 degrees to 0, by OpenCV's HSV
def show_hsv(depth_metric, max_depth=5.0):
    with np.errstate(invalid="ignore"):
        valid = np.isfinite(depth_metric) & (depth_metric > 0)
    part = np.zeros(depth_metric.shape, np.float32)
    part[valid] = np.minimum(depth_metric[valid] / np.float32(max_depth), 1)
    hsv = np.full(depth_metric.shape + (3,), 255, np.uint8)
    hsv[..., 0] = np.rint(120 * (1 - part)).astype(np.uint8)
    hsv[..., 2] = np.where(valid, 255, 0)
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)


# 5. R: colorRampPalette blue - cyan - yellow - red, np.interp
def show_ramp(depth_metric, max_depth=5.0):
    stops = np.linspace(0, max_depth, 4)
    ramp = {"blue": [255, 255, 0, 0], "green": [0, 255, 255, 0], "red": [0, 0, 255, 255]}
    good = np.logical_and(np.isfinite(depth_metric), np.greater(depth_metric, 0))
    d = np.where(good, depth_metric, 0.0).astype(float)
    planes = [np.interp(d, stops, ramp[c]) for c in ("blue", "green", "red")]
    return (np.dstack(planes) * good[..., np.newaxis]).astype(np.uint8)


# 6. Java: a color map class with a table from colorsys
class ColorMap:
    def __init__(self, steps=256):
        self.table = np.array([
            [round(255 * c) for c in colorsys.hsv_to_rgb((1 - i / (steps - 1)) * 2 / 3, 1, 1)][::-1]
            for i in range(steps)], dtype=np.uint8)

    def __getitem__(self, index):
        return self.table[index]


class DepthPainter:
    BLACK = (0, 0, 0)

    def __init__(self, max_depth):
        if max_depth <= 0:
            raise ValueError("max_depth must be positive")
        self.max_depth, self.colors = float(max_depth), ColorMap()

    def color_of(self, depth):
        if not math.isfinite(depth) or depth <= 0.0:
            return self.BLACK
        return self.colors[int(255 * min(1.0, depth / self.max_depth))]


def show_java(depth_metric, max_depth=5.0):
    painter = DepthPainter(max_depth)
    flat = [painter.color_of(float(d)) for d in depth_metric.flat]
    return np.array(flat, dtype=np.uint8).reshape(*depth_metric.shape, 3)


# 7. masked arrays, convertScaleAbs, bitwise_and with the mask
def show_masked(depth_metric, max_depth=5.0):
    d = np.ma.masked_invalid(depth_metric)
    d = np.ma.masked_where(d.filled(-1) <= 0, d)
    gray = cv2.convertScaleAbs(np.clip(d.filled(0), 0, max_depth).astype(np.float64),
                               alpha=255.0 / max_depth)
    bgr = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    known = 255 - np.ma.getmaskarray(d).astype(np.uint8) * 255
    return cv2.bitwise_and(bgr, bgr, mask=known)


# 8. Matlab: jet(256) built by hand and indexed
def show_matlab(depth_metric, max_depth=5.0):
    t = np.arange(256) / 255
    tri = lambda center: np.clip(1.5 - np.abs(4 * t - center), 0, 1)
    jet_bgr = np.rint(255 * np.column_stack([tri(1), tri(2), tri(3)])).astype(np.uint8)
    nothing = ~(np.isfinite(depth_metric) & (depth_metric > 0))
    D = np.array(depth_metric, dtype=np.float64)
    D[nothing] = 0
    index = np.floor(255 * np.minimum(D / max_depth, 1) + 0.5).astype(int)
    picture = jet_bgr[index]
    picture[nothing] = 0
    return picture


ANSWERS = [show_turbo, show_jet, show_beginner, show_hsv, show_ramp, show_java, show_masked,
           show_matlab]
