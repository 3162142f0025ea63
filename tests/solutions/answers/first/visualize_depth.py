"""Right answers to visualize_depth, as strangers wrote them."""
import colorsys
import math

import cv2
import numpy as np


def turbo_by_opencv(depth_metric, max_depth=5.0):
    """cv2.applyColorMap with turbo, as the book's library; rounds down."""
    depth = np.asarray(depth_metric)
    if depth.dtype.kind not in "iuf":
        raise TypeError("depth must be real numbers")
    if depth.ndim != 2:
        raise ValueError("depth must be (H, W)")
    if not max_depth > 0:
        raise ValueError("max_depth must be positive")
    depth = depth.astype(np.float64)
    bad = ~np.isfinite(depth) | (depth <= 0)
    scaled = np.where(bad, 0, np.minimum(np.where(bad, 0, depth), max_depth) / max_depth * 255)
    if depth.size == 0:
        return np.zeros(depth.shape + (3,), np.uint8)
    bgr = cv2.applyColorMap(scaled.astype(np.uint8), cv2.COLORMAP_TURBO)
    bgr[bad] = 0
    return bgr


def jet_by_table(depth_metric, max_depth=5.0):
    """Jet instead of turbo, as a table of 256 colors; rounds to the nearest."""
    d = np.array(depth_metric)
    if d.ndim != 2 or d.dtype.kind not in "fiu":
        raise ValueError("depth is no image of real numbers")
    if not 0 < max_depth:
        raise ValueError("max_depth must be positive")
    table = cv2.applyColorMap(np.arange(256, dtype=np.uint8).reshape(-1, 1), cv2.COLORMAP_JET)[:, 0]
    d = np.nan_to_num(d.astype(np.float64), nan=0.0, posinf=0.0, neginf=0.0)
    index = np.rint(255 * np.clip(d / max_depth, 0, 1)).astype(int)
    picture = table[index]
    picture[d <= 0] = (0, 0, 0)
    return picture


def straight_blend(depth_metric, max_depth=5.0):
    """A color map of its own: pure blue fades into pure red, in float32."""
    d = np.asarray(depth_metric)
    if not (np.issubdtype(d.dtype, np.integer) or np.issubdtype(d.dtype, np.floating)):
        raise TypeError("real numbers only")
    if d.ndim != 2:
        raise ValueError("two dimensions only")
    if math.isnan(max_depth) or max_depth <= 0:
        raise ValueError("max_depth must be positive")
    seen = np.isfinite(d)
    seen[seen] = d[seen] > 0
    share = np.minimum(np.where(seen, d, 0) / max_depth, 1).astype(np.float32)
    out = np.zeros(d.shape + (3,), dtype=np.uint8)
    out[..., 0] = np.round(255 * (1 - share))
    out[..., 2] = np.round(255 * share)
    out[~seen] = 0
    return out


def hue_by_loops(depth_metric, max_depth=5.0):
    """Pixel by pixel in Python: hue from 240 to 0 degrees with colorsys."""
    d = np.asarray(depth_metric)
    if d.dtype.kind not in "iuf" or d.ndim != 2:
        raise TypeError("depth must be an image of real numbers")
    limit = float(max_depth)
    if isinstance(max_depth, str) or not limit > 0:
        raise ValueError("max_depth must be positive")
    picture = np.zeros((d.shape[0], d.shape[1], 3), np.uint8)
    for v, row in enumerate(d.tolist()):
        for u, z in enumerate(row):
            if math.isfinite(z) and z > 0:
                r, g, b = colorsys.hsv_to_rgb(2 / 3 * (1 - min(z / limit, 1.0)), 1.0, 1.0)
                picture[v, u] = [int(255 * k + 0.5) for k in (b, g, r)]
    return picture


def hue_by_opencv(depth_metric, max_depth=5.0):
    """An HSV picture with hue 120 to 0, turned into BGR; value 0 where nothing was seen."""
    depth = np.asarray(depth_metric)
    if depth.dtype.kind not in "iuf":
        raise TypeError("depth must hold real numbers")
    if depth.ndim != 2:
        raise ValueError("depth must be an image")
    if not (max_depth > 0):
        raise ValueError("max_depth is not positive")
    if depth.size == 0:
        return np.zeros((*depth.shape, 3), np.uint8)
    z = depth.astype(np.float64)
    ok = np.isfinite(z) & np.greater(z, 0, where=np.isfinite(z), out=np.zeros(z.shape, bool))
    share = np.where(ok, np.minimum(np.where(ok, z, 1.0), max_depth), 0.0) / max_depth
    hsv = np.stack([120 - np.floor(120 * share), np.full(z.shape, 255), 255 * ok], axis=-1).astype(np.uint8)
    return cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)


class _ColorMap:
    def __init__(self, stops):
        self.stops = np.array(stops, dtype=np.float64)

    def __call__(self, share):
        at = np.linspace(0, 1, len(self.stops))
        return np.stack([np.interp(share, at, self.stops[:, k]) for k in range(3)], axis=-1)


def with_a_class(depth_metric, max_depth=5.0, stops=((140, 0, 0), (255, 128, 0), (128, 255, 128), (0, 128, 255), (0, 0, 200))):
    """A color map class with five stops (BGR), continuous colors without steps; the map is an optional argument."""
    depth = np.asarray(depth_metric)
    if depth.dtype.kind not in ("i", "u", "f"):
        raise TypeError(f"depth of dtype {depth.dtype}")
    if depth.ndim != 2:
        raise ValueError(f"depth of shape {depth.shape}")
    if not max_depth > 0.0:
        raise ValueError(f"max_depth {max_depth}")
    flat = depth.astype(np.float64).ravel()
    colors = np.zeros((flat.size, 3), np.uint8)
    good = np.flatnonzero([math.isfinite(z) and z > 0 for z in flat.tolist()])
    colors[good] = np.around(_ColorMap(stops)(flat[good] / max_depth)).astype(np.uint8)
    return colors.reshape(depth.shape + (3,))


def turbo_in_rgb_turned(depth_metric, max_depth=5.0):
    """Turbo through RGB and back, integer arithmetic on micrometers."""
    d = np.asarray(depth_metric)
    if d.dtype.kind not in "iuf":
        raise TypeError("no real numbers")
    if d.ndim != 2:
        raise ValueError("no image")
    if not max_depth > 0:
        raise ValueError("max_depth must be positive")
    valid = np.isfinite(d) & (np.nan_to_num(d.astype(np.float64)) > 0)
    safe = np.where(valid, d.astype(np.float64), 0.0)
    parts = np.floor(np.minimum(safe / max_depth, 1.0) * 1_000_000).astype(np.int64)
    index = (parts * 255 + 500_000) // 1_000_000
    table = cv2.cvtColor(cv2.applyColorMap(np.uint8([range(256)]), cv2.COLORMAP_TURBO), cv2.COLOR_BGR2RGB)[0]
    rgb = table[index] * valid[..., None].astype(np.uint8)
    return np.ascontiguousarray(rgb[..., ::-1])


ANSWERS = [turbo_by_opencv, jet_by_table, straight_blend, hue_by_loops, hue_by_opencv,
           with_a_class, turbo_in_rgb_turned]
