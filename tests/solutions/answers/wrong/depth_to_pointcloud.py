"""Wrong answers to depth_to_pointcloud, as strangers wrote them."""
import numpy as np


def _check(depth_metric, K, rgb_image):
    d = np.asarray(depth_metric)
    if d.ndim != 2 or d.dtype.kind not in "fiu":
        raise TypeError("depth must be a (H, W) image of real numbers")
    K = np.asarray(K)
    if K.dtype.kind not in "fiu":
        raise TypeError("K must be numbers")
    K = K.astype(float)
    if K.shape != (3, 3) or K[0, 0] <= 0 or K[1, 1] <= 0 or not np.array_equal(K[2], [0, 0, 1]):
        raise ValueError("K is no intrinsic matrix")
    if rgb_image is not None:
        rgb_image = np.asarray(rgb_image)
        if rgb_image.shape != (*d.shape, 3):
            raise ValueError("pictures differ in size")
    return d, K, rgb_image


def _right(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    d = d.astype(np.float64)
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid]
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_half_pixel(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u + 0.5 - K[0, 2]) * z / K[0, 0], (v + 0.5 - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_u_v_swapped(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    u, v = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_nothing_left_out(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    h, w = d.shape
    u, v = np.meshgrid(np.arange(w), np.arange(h))
    z = d.astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=-1).reshape(-1, 3)
    return p.astype(out), None if rgb is None else (rgb.reshape(-1, 3) / 255).astype(np.float32)


def w_only_zero_left_out(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_ten_is_kept(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d <= 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_one_centimeter_kept(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d >= 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_colors_not_filtered(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    colors = None if rgb is None else rgb.reshape(-1, 3).astype(np.float32) / 255
    return p.astype(out), colors


def w_colors_to_255(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else rgb[valid].astype(np.float32)


def w_colors_float64(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else rgb[valid] / 255.0


def w_colors_integer_division(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] // 255).astype(np.float32)


def w_colors_bgr(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[..., ::-1][valid] / 255).astype(np.float32)


def w_always_float64(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid]
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p, None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_always_float32(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    d = d.astype(np.float32)
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid]
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(np.float32), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_column_by_column(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    points, colors = [], []
    h, w = d.shape
    for u in range(w):
        for v in range(h):
            z = float(d[v, u])
            if np.isfinite(z) and 0.01 < z < 10:
                points.append([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z])
                if rgb is not None:
                    colors.append(rgb[v, u] / 255)
    p = np.array(points, out).reshape(-1, 3)
    return p, None if rgb is None else np.array(colors, np.float32).reshape(-1, 3)


def w_only_points(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1).astype(out)
    if rgb is None:
        return p
    return p, (rgb[valid] / 255).astype(np.float32)


def w_black_without_picture(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    if rgb is None:
        rgb = np.zeros((*d.shape, 3), np.uint8)
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), (rgb[valid] / 255).astype(np.float32)


def w_center_from_last_row(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[2, 0]) * z / K[0, 0], (v - K[2, 1]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_inverse_not_transposed(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    rays = np.stack([u, v, np.ones_like(u)], axis=1) @ np.linalg.inv(K)
    return (rays * z[:, None]).astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_fx_for_y(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    f = K[0, 0]
    p = np.stack([(u - K[0, 2]) * z / f, (v - K[1, 2]) * z / f, z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_ray_length(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    rays = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(len(u))], axis=1)
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    p = rays * d[valid].astype(float)[:, None]
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_y_up(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], -(v - K[1, 2]) * z / K[1, 1], -z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_sizes_not_compared(depth_metric, K, rgb_image=None):
    d, K, _ = _check(depth_metric, K, None)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    colors = None
    if rgb_image is not None:
        colors = (np.asarray(rgb_image)[v, u] / 255).astype(np.float32)
    return p.astype(out), colors


def w_truth_of_picture(depth_metric, K, rgb_image=None):
    d, K, _ = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    colors = (rgb_image[valid] / 255).astype(np.float32) if rgb_image else None
    return p.astype(out), colors


def w_changes_depth(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    if d.dtype.kind == "f":
        d[~np.isfinite(d)] = 0
    valid = (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_rows_of_coordinates(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.array([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z])
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_fixed_grid(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    u, v = np.meshgrid(np.arange(640), np.arange(480))
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    x = (u - K[0, 2]) * d / K[0, 0]
    y = (v - K[1, 2]) * d / K[1, 1]
    p = np.stack([x[valid], y[valid], d[valid]], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_empty_shape(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    points, colors = [], []
    for v, u in np.argwhere(np.isfinite(d) & (d > 0.01) & (d < 10)):
        z = float(d[v, u])
        points.append([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z])
        if rgb is not None:
            colors.append(rgb[v, u] / 255)
    return np.array(points, out), None if rgb is None else np.array(colors, np.float32)


def w_K_not_checked(depth_metric, K, rgb_image=None):
    K = np.asarray(K)
    d, _, rgb = _check(depth_metric, np.eye(3), rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_keeps_any_dtype(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(d.dtype), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_focal_multiplied(depth_metric, K, rgb_image=None):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([u - K[0, 2] * z / K[0, 0], v - K[1, 2] * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


def w_every_second_pixel(depth_metric, K, rgb_image=None, step=2):
    d, K, rgb = _check(depth_metric, K, rgb_image)
    out = np.float64 if d.dtype == np.float64 else np.float32
    valid = np.zeros(d.shape, bool)
    valid[::step, ::step] = True
    valid &= np.isfinite(d) & (d > 0.01) & (d < 10)
    v, u = np.nonzero(valid)
    z = d[valid].astype(float)
    p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
    return p.astype(out), None if rgb is None else (rgb[valid] / 255).astype(np.float32)


WRONG = [
    (w_half_pixel, "adds half a pixel; every valid pixel"),
    (w_u_v_swapped, "np.nonzero unpacked as (u, v); every picture"),
    (w_nothing_left_out, "invalid pixels stay; NaN, 0, far plane"),
    (w_only_zero_left_out, "limits 0.01 and 10 m forgotten; 12 m, 0.005 m"),
    (w_ten_is_kept, "<= 10 instead of < 10; a pixel of exactly 10 m"),
    (w_one_centimeter_kept, ">= 0.01 instead of >; a float64 pixel of exactly 0.01 m"),
    (w_colors_not_filtered, "colors of all pixels; invalid pixels and a picture"),
    (w_colors_to_255, "colors not divided by 255; every picture"),
    (w_colors_float64, "colors float64; every picture"),
    (w_colors_integer_division, "integer division: only 0 and 1; every picture"),
    (w_colors_bgr, "colors in BGR; every picture"),
    (w_always_float64, "float64 points; float32 depth"),
    (w_always_float32, "float32 points; float64 depth"),
    (w_column_by_column, "points column by column; more than one row and column"),
    (w_only_points, "one array instead of (points, None); no picture"),
    (w_black_without_picture, "black colors instead of None; no picture"),
    (w_center_from_last_row, "takes cx, cy from the last row of K; every picture"),
    (w_inverse_not_transposed, "rows times K inverse without the transpose; every picture"),
    (w_fx_for_y, "copy-paste slip: fx for y; fx other than fy"),
    (w_ray_length, "depth taken for the length of the ray; pixels off the axis"),
    (w_y_up, "MuJoCo's axes, y up and z backward; every picture"),
    (w_sizes_not_compared, "no error where the pictures differ in size; a larger color picture"),
    (w_truth_of_picture, "`if rgb_image` raises for arrays; every call with a picture"),
    (w_changes_depth, "writes 0 into the caller's depth; NaN or infinity"),
    (w_rows_of_coordinates, "shape (3, N); every picture"),
    (w_fixed_grid, "grid of 640 x 480; any other size"),
    (w_empty_shape, "shape (0,) instead of (0, 3); no valid pixel"),
    (w_K_not_checked, "no error for a K that is no intrinsic matrix; zero focal length, 3 x 4"),
    (w_keeps_any_dtype, "casts back to the depth's dtype: integers; integer or float16 depth"),
    (w_focal_multiplied, "parentheses missing: u - cx * z / f; every picture"),
    (w_every_second_pixel, "takes every second pixel only; pictures wider than one pixel"),
]


def _cases():
    K = np.array([[50.0, 0, 3.5], [0, 60.0, 2.5], [0, 0, 1]])

    def depth(dtype):
        d = np.random.default_rng(0).uniform(0.5, 3, (6, 8))
        d[0, 0], d[1, 1], d[2, 2], d[3, 3], d[4, 4], d[5, 5], d[0, 7], d[1, 6] = np.nan, np.inf, 0, 12, 10, 0.01, 0.005, -1
        return d.astype(dtype)

    def rgb(h=6, w=8):
        return np.random.default_rng(1).integers(0, 256, (h, w, 3), dtype=np.uint8)
    bad = K.copy()
    bad[0, 0] = 0
    return [lambda: (depth(np.float32), K.copy(), rgb()), lambda: (depth(np.float64), K.copy(), rgb()), lambda: (depth(np.float32), K.copy()),
            lambda: (np.zeros((3, 4), np.float32), K.copy(), rgb(3, 4)), lambda: (np.array([[1, 2], [3, 0]]), K.copy()),
            lambda: (np.array([[1, 2], [3, 0]], np.float16), K.copy()),
            lambda: (depth(np.float32), K.copy(), rgb(7, 9)), lambda: (depth(np.float32), bad.copy()), lambda: (depth(np.float32), np.eye(4)),
            lambda: (depth(np.float32)[0], K.copy()), lambda: (np.array([[2.0, np.nan]]), np.array([[100.0, 0, 0.5], [0, 100.0, 0], [0, 0, 1]]))]
