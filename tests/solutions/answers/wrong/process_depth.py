"""Wrong answers to process_depth, as strangers wrote them."""
import numpy as np


def _right(depth_raw, near=0.01, far=10.0):
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "fiu":
        raise TypeError("real numbers")
    if not 0 < near < far:
        raise ValueError("0 < near < far")
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = np.clip(d.astype(np.float64), 0, 1)
    return np.asarray(near * far / (far - d * (far - near))).astype(out)


def _check(depth_raw, near, far):
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "fiu":
        raise TypeError("depth must be real numbers")
    if not 0 < near < far:
        raise ValueError("need 0 < near < far")
    return d, (np.float64 if d.dtype == np.float64 else np.float32)


def w_straight_line(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    return (near + np.clip(d.astype(float), 0, 1) * (far - near)).astype(out)


def w_not_clipped(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = d.astype(np.float64)
    return (near * far / (far - d * (far - near))).astype(out)


def w_nan_becomes_zero(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = np.clip(np.nan_to_num(d.astype(float)), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_reversed(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = 1 - np.clip(d.astype(float), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_near_far_swapped(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = np.clip(d.astype(float), 0, 1)
    return (near * far / (near + d * (far - near))).astype(out)


def w_always_float64(depth_raw, near=0.01, far=10.0):
    d, _ = _check(depth_raw, near, far)
    d = np.clip(d.astype(np.float64), 0, 1)
    return near * far / (far - d * (far - near))


def w_always_float32(depth_raw, near=0.01, far=10.0):
    d, _ = _check(depth_raw, near, far)
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(np.float32)


def w_tutorial_half(depth_raw, near=0.01, far=10.0):
    # learnopengl.com: LinearizeDepth
    d, out = _check(depth_raw, near, far)
    z = np.clip(d.astype(float), 0, 1)
    return ((2.0 * near * far) / (far + near - z * (far - near))).astype(out)


def w_default_planes_always(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    n, f = 0.01, 10.0
    d = np.clip(d.astype(float), 0, 1)
    return (n * f / (f - d * (f - n))).astype(out)


def w_clips_input_in_place(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    np.clip(d, 0, 1, out=d)
    return (near * far / (far - d.astype(np.float64) * (far - near))).astype(out)


def w_no_plane_check(depth_raw, near=0.01, far=10.0):
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "fiu":
        raise TypeError("depth must be real numbers")
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_near_zero_accepted(depth_raw, near=0.01, far=10.0):
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "fiu":
        raise TypeError("depth must be real numbers")
    if near < 0 or far <= near:
        raise ValueError("near must be smaller than far")
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_near_equals_far_accepted(depth_raw, near=0.01, far=10.0):
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "fiu":
        raise TypeError("depth must be real numbers")
    if near <= 0 or near > far:
        raise ValueError("near must be smaller than far")
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_complex_accepted(depth_raw, near=0.01, far=10.0):
    if not 0 < near < far:
        raise ValueError("need 0 < near < far")
    d = np.asarray(depth_raw)
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = np.clip(np.real(d).astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_strings_accepted(depth_raw, near=0.01, far=10.0):
    if not 0 < near < far:
        raise ValueError("need 0 < near < far")
    d = np.asarray(depth_raw)
    if np.iscomplexobj(d):
        raise TypeError("depth must be real")
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_images_only(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    if d.ndim != 2:
        raise ValueError("depth must have shape (H, W)")
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_refuses_outside(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    if (d < 0).any() or (d > 1).any():
        raise ValueError("window depth must lie in [0, 1]")
    d = d.astype(np.float64)
    return (near * far / (far - d * (far - near))).astype(out)


def w_drops_nan(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = d[~np.isnan(d)]
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_crashes_on_empty(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = d.astype(np.float64)
    if d.min() < 0 or d.max() > 1:
        d = np.clip(d, 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_nan_hides_clipping(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = d.astype(np.float64)
    if np.max(d, initial=0) > 1 or np.min(d, initial=0) < 0:
        d = np.clip(d, 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_keeps_any_float(depth_raw, near=0.01, far=10.0):
    d, _ = _check(depth_raw, near, far)
    z = near * far / (far - np.clip(d, 0, 1) * (far - near))
    return z.astype(d.dtype) if d.dtype.kind == "f" else z.astype(np.float32)


def w_integers_stay_integers(depth_raw, near=0.01, far=10.0):
    d, _ = _check(depth_raw, near, far)
    z = near * far / (far - np.clip(d.astype(np.float64), 0, 1) * (far - near))
    return z.astype(d.dtype)


def w_needs_array(depth_raw, near=0.01, far=10.0):
    if depth_raw.dtype.kind not in "fiu":
        raise TypeError("depth must be real numbers")
    if not 0 < near < far:
        raise ValueError("need 0 < near < far")
    out = np.float64 if depth_raw.dtype == np.float64 else np.float32
    d = np.clip(depth_raw.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_millimeters(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = np.clip(d.astype(np.float64), 0, 1)
    return (1000 * near * far / (far - d * (far - near))).astype(out)


def w_far_is_nan(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = np.clip(d.astype(np.float64), 0, 1)
    z = near * far / (far - d * (far - near))
    z = np.where(d >= 1, np.nan, z)
    return z.astype(out)


def w_bytes_scaled(depth_raw, near=0.01, far=10.0):
    d, out = _check(depth_raw, near, far)
    d = d.astype(np.float64)
    if d.size and np.nanmax(d) > 1:  # somebody passed 0..255
        d = d / 255
    d = np.clip(d, 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


def w_wrong_exception(depth_raw, near=0.01, far=10.0):
    d = np.asarray(depth_raw)
    if d.dtype.kind not in "fiu":
        raise TypeError("depth must be real numbers")
    if not 0 < near < far:
        raise Exception("need 0 < near < far")
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = np.clip(d.astype(np.float64), 0, 1)
    return (near * far / (far - d * (far - near))).astype(out)


WRONG = [
    (w_straight_line, "straight line between the planes instead of the hyperbola; every depth but 0 and 1"),
    (w_not_clipped, "values outside [0, 1] are not clipped; -0.1, 1.2"),
    (w_nan_becomes_zero, "NaN becomes 0 and so the near plane; NaN"),
    (w_reversed, "takes the buffer for reversed z; every input"),
    (w_near_far_swapped, "denominator from near upward: 0 is far and 1 near; every input"),
    (w_always_float64, "float64 also for float32; float32 input"),
    (w_always_float32, "float32 also for float64; float64 input"),
    (w_tutorial_half, "formula for normalized device coordinates used without 2 d - 1; every input"),
    (w_default_planes_always, "near and far ignored; other planes than the defaults"),
    (w_clips_input_in_place, "clips the caller's array in place; arrays with values outside [0, 1]"),
    (w_no_plane_check, "no error for bad planes; near >= far, near <= 0"),
    (w_near_zero_accepted, "near = 0 passes; near=0"),
    (w_near_equals_far_accepted, "near = far passes; near=far=1"),
    (w_complex_accepted, "complex numbers lose their imaginary part without an error; complex input"),
    (w_strings_accepted, "text that looks like numbers and bools are converted without an error; np.array(['0.5'])"),
    (w_images_only, "refuses everything but (H, W); scalars, vectors, stacks"),
    (w_refuses_outside, "raises where it should clip; 1.2"),
    (w_drops_nan, "drops NaN, shape changes; NaN, any 2-D input"),
    (w_crashes_on_empty, "min of an empty array raises, and NaN stops the clipping; shape (0,), or NaN beside 1.5"),
    (w_nan_hides_clipping, "asks max() whether to clip: NaN makes the answer no; NaN beside 1.5"),
    (w_keeps_any_float, "float16 comes back as float16; float16 input"),
    (w_integers_stay_integers, "casts back to the input's dtype; integer input"),
    (w_needs_array, "uses .dtype of the argument; lists (AttributeError)"),
    (w_millimeters, "millimeters; every input"),
    (w_far_is_nan, "the far plane becomes NaN; depth 1 and above"),
    (w_bytes_scaled, "divides everything by 255 as soon as one value is above 1; 1.2"),
    (w_wrong_exception, "plain Exception instead of ValueError; near >= far"),
]


def _cases():
    f32 = np.array([[0, 0.3, 0.9], [0.99, 1, np.nan]], np.float32)
    L = [(np.array([0.0, 0.5, 1.0]), 1.0, 3.0), (f32,), (f32, 0.05, 20.0), (np.array([-0.1, 0.4, 1.2]),),
         (np.array([np.nan, 1.5, -2, 0.2], np.float32), 0.1, 5.0), (np.float32(0.7),), (np.zeros((0, 3), np.float32),),
         (np.array([0.5, 0.25], np.float16), 0.1, 2.0), (np.array([0, 1, 2], np.int32), 0.5, 2.0),
         (f32, 1.0, 1.0), (f32, 2.0, 1.0), (f32, 0.0, 1.0), (f32, -1.0, 1.0), (np.array([0.5 + 1j]),), (np.array(["0.5"]),),
         (np.random.default_rng(0).random((2, 3, 4)).astype(np.float32),)]

    def lst():
        return ([[0.25, 0.5]], 0.1, 2.0)
    return [lambda t=t: tuple(x.copy() if isinstance(x, np.ndarray) else x for x in t) for t in L] + [lst]
