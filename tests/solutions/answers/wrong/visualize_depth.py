"""Wrong answers to visualize_depth, as strangers wrote them."""
import cv2
import numpy as np


def _right(depth_metric, max_depth=5.0):
    d = np.asarray(depth_metric)
    if d.ndim != 2 or d.dtype.kind not in "fiu":
        raise TypeError("depth image")
    if not max_depth > 0:
        raise ValueError("max_depth")
    d = d.astype(np.float64)
    bad = ~np.isfinite(d) | (d <= 0)
    level = np.round(255 * np.clip(np.where(bad, 0, d) / max_depth, 0, 1)).astype(np.uint8)
    out = cv2.applyColorMap(level, cv2.COLORMAP_TURBO)
    out[bad] = 0
    return out


def _check(depth_metric, max_depth):
    d = np.asarray(depth_metric)
    if d.ndim != 2 or d.dtype.kind not in "fiu":
        raise TypeError("depth must be a (H, W) image of real numbers")
    if not max_depth > 0:
        raise ValueError("max_depth must be positive")
    return d


def w_rgb(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.cvtColor(cv2.applyColorMap(gray, cv2.COLORMAP_TURBO), cv2.COLOR_BGR2RGB)
    out[~valid] = 0
    return out


def w_red_is_close(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, 255 - np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_scaled_by_data(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    top = d[valid].max() if valid.any() else 1.0
    gray = np.where(valid, d / top * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_min_max_normalized(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(np.float32)
    valid = np.isfinite(d) & (d > 0)
    d = np.minimum(np.where(valid, d, 0), max_depth)
    gray = cv2.normalize(d, None, 0, 255, cv2.NORM_MINMAX).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_overflows_beyond(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = (np.where(valid, d, 0) / max_depth * 255).astype(np.int64).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_times_256(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = (np.clip(np.where(valid, d, 0) / max_depth, 0, 1) * 256).astype(np.int32).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_invalid_not_black(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    d = np.nan_to_num(d, nan=0.0, posinf=0.0, neginf=0.0)
    gray = (np.clip(d / max_depth, 0, 1) * 255).astype(np.uint8)
    return cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)


def w_infinite_is_red(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    invalid = np.isnan(d) | (d <= 0)
    gray = (np.clip(np.where(invalid, 0, d) / max_depth, 0, 1) * 255).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[invalid] = 0
    return out


def w_zero_is_blue(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    invalid = ~np.isfinite(d) | (d < 0)
    gray = (np.clip(np.where(invalid, 0, d) / max_depth, 0, 1) * 255).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[invalid] = 0
    return out


def w_negative_is_blue(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    invalid = ~np.isfinite(d) | (d == 0)
    gray = (np.clip(np.where(invalid, 0, d) / max_depth, 0, 1) * 255).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[invalid] = 0
    return out


def w_max_depth_not_checked(depth_metric, max_depth=5.0):
    d = np.asarray(depth_metric)
    if d.ndim != 2 or d.dtype.kind not in "fiu":
        raise TypeError("depth must be a (H, W) image of real numbers")
    d = d.astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_zero_max_accepted(depth_metric, max_depth=5.0):
    d = np.asarray(depth_metric)
    if d.ndim != 2 or d.dtype.kind not in "fiu":
        raise TypeError("depth must be a (H, W) image of real numbers")
    if max_depth < 0:
        raise ValueError("max_depth must not be negative")
    d = d.astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max(max_depth, 1e-9), 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_any_shape(depth_metric, max_depth=5.0):
    d = np.asarray(depth_metric)
    if max_depth <= 0:
        raise ValueError("max_depth must be positive")
    d = np.atleast_2d(np.squeeze(d.astype(np.float64)))
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_always_five(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / 5.0, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_gray(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    return cv2.cvtColor(gray, cv2.COLOR_GRAY2BGR)


def w_one_channel(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    return np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)


def w_matplotlib(depth_metric, max_depth=5.0):
    import matplotlib
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    level = np.where(valid, np.clip(d / max_depth, 0, 1), 0)
    out = matplotlib.colormaps["turbo"](level)[..., 2::-1]
    out[~valid] = 0
    return out


def w_changes_input(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth)
    invalid = ~np.isfinite(d) | (d <= 0)
    d[invalid] = 0
    gray = np.round(np.clip(d / max_depth, 0, 1) * 255).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[invalid] = 0
    return out


def w_invalid_white(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 255
    return out


def w_beyond_is_black(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0) & (d <= max_depth)
    gray = np.where(valid, d / max_depth * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_whole_steps(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth)
    valid = np.isfinite(d) & (d > 0)
    d = np.where(valid, d, 0)
    gray = (np.clip(d // max_depth, 0, 1) * 255).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_viridis(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_VIRIDIS)
    out[~valid] = 0
    return out


def w_needs_array(depth_metric, max_depth=5.0):
    if depth_metric.ndim != 2 or depth_metric.dtype.kind not in "fiu":
        raise TypeError("depth must be a (H, W) image of real numbers")
    if max_depth <= 0:
        raise ValueError("max_depth must be positive")
    valid = np.isfinite(depth_metric) & (depth_metric > 0)
    gray = np.where(valid, np.clip(depth_metric / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_floats_only(depth_metric, max_depth=5.0):
    d = np.asarray(depth_metric)
    if d.ndim != 2 or d.dtype.kind != "f":
        raise TypeError("depth must be float")
    if max_depth <= 0:
        raise ValueError("max_depth must be positive")
    valid = np.isfinite(d) & (d > 0)
    gray = np.where(valid, np.clip(d / max_depth, 0, 1) * 255, 0).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[~valid] = 0
    return out


def w_dark_by_color(depth_metric, max_depth=5.0):
    # invalid pixels have level 0, so black out level 0
    d = _check(depth_metric, max_depth).astype(float)
    d = np.nan_to_num(d, nan=0, posinf=0, neginf=0)
    gray = (np.clip(d / max_depth, 0, 1) * 255).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[gray == 0] = 0
    return out


def w_all_nan_spreads(depth_metric, max_depth=5.0):
    d = _check(depth_metric, max_depth).astype(float)
    invalid = ~np.isfinite(d) | (d <= 0)
    if np.isnan(np.max(d)):
        return np.zeros((*d.shape, 3), np.uint8)
    gray = (np.clip(np.where(invalid, 0, d) / max_depth, 0, 1) * 255).astype(np.uint8)
    out = cv2.applyColorMap(gray, cv2.COLORMAP_TURBO)
    out[invalid] = 0
    return out


WRONG = [
    (w_rgb, "RGB instead of BGR; every picture with a valid pixel"),
    (w_red_is_close, "colors turned around; every picture with a valid pixel"),
    (w_scaled_by_data, "scaled by the largest depth in the picture, max_depth unused; largest depth other than max_depth"),
    (w_min_max_normalized, "stretched from the smallest to the largest depth; largest depth below max_depth, no invalid pixel"),
    (w_overflows_beyond, "no clipping, uint8 wraps around; depth beyond max_depth"),
    (w_times_256, "factor 256: max_depth itself wraps to 0 and is blue; depth at or beyond max_depth"),
    (w_invalid_not_black, "invalid pixels get the bluest color; NaN, infinity, 0, negative"),
    (w_infinite_is_red, "infinite depth is red; inf"),
    (w_zero_is_blue, "0 is not black (< instead of <=); depth 0"),
    (w_negative_is_blue, "negative depth is blue; negative depth"),
    (w_max_depth_not_checked, "no error for bad max_depth; max_depth 0 or -1"),
    (w_zero_max_accepted, "max_depth 0 passes; max_depth=0"),
    (w_any_shape, "no error for what is no image of real numbers; shapes (5,) and (1, H, W)"),
    (w_always_five, "max_depth ignored; max_depth=2"),
    (w_gray, "gray picture instead of colors; every valid pixel"),
    (w_one_channel, "shape (H, W); every input"),
    (w_matplotlib, "floats from 0 to 1 instead of uint8; every input"),
    (w_changes_input, "sets invalid pixels of the caller's array to 0; arrays with NaN, inf or negative"),
    (w_invalid_white, "invalid pixels white; NaN"),
    (w_beyond_is_black, "black beyond max_depth instead of red; depth beyond max_depth"),
    (w_whole_steps, "floor division: only two colors; depths below max_depth"),
    (w_viridis, "viridis goes to yellow, not red; far pixels"),
    (w_needs_array, "uses .ndim of the argument: AttributeError; nested lists"),
    (w_floats_only, "refuses whole numbers; integer depth"),
    (w_dark_by_color, "takes level 0 for invalid, so very close surfaces are black; depth below max_depth / 255"),
    (w_all_nan_spreads, "one NaN blackens everything; NaN beside valid pixels"),
]


def _cases():
    base = np.array([[0.5, 1.0, 2.4, 4.9], [5.0, 6.0, 30.0, 3.3]], np.float32)
    bad = np.array([[0.5, np.nan, np.inf, -np.inf], [0, -1, 3.0, 5.0]], np.float32)
    near = np.array([[0.004, 1.0], [0.01, 2.0]])
    L = [(base,), (bad,), (base, 2.0), (near,), (np.array([[1, 2, 3], [9, 0, 4]], np.int32), 4.0), (np.array([[0.5, 1.0], [1.5, 2.0]]),),
         (base, 0.0), (base, -1.0), (np.ones(5, np.float32),), (base[None],), (np.array([["a"]]),)]
    return [lambda t=t: tuple(x.copy() if isinstance(x, np.ndarray) else x for x in t) for t in L] + [lambda: ([[1.0, 2.0], [3.0, 4.0]],)]


def _same(a, b):
    if not isinstance(a, np.ndarray) or a.dtype != np.uint8 or a.shape != b.shape:
        return False
    if not np.array_equal((a == 0).all(-1), (b == 0).all(-1)):
        return False
    return np.abs(a.astype(int) - b).max() <= 25
