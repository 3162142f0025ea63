"""Wrong answers to nearest_object, as strangers wrote them."""
import numpy as np


def _right(labels, depth_metric, K, T_world_cam, max_width):
    valid = np.isfinite(depth_metric) & (depth_metric > 0.01) & (depth_metric < 10)
    best = None
    for k in np.unique(labels[labels > 0]):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(np.float64)
        p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], 1)
        pos = np.median(p, axis=0)
        d = np.linalg.norm(pos)
        if np.ptp(p[:, 0]) <= max_width and (best is None or d < best[0]):
            best = d, int(k), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return (None, None) if best is None else best[1:]


def w_depth_as_distance(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_z, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if x.max() - x.min() <= max_width and pos[2] < best_z:
            best, best_z, best_pos = k, pos[2], T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_mean(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([x.mean(), y.mean(), z.mean()])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_invalid_included(labels, depth_metric, K, T_world_cam, max_width):
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero(labels == k)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_only_nan_dropped(labels, depth_metric, K, T_world_cam, max_width):
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & np.isfinite(depth_metric) & (depth_metric > 0))
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_background_counts(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in np.unique(labels):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = int(k), np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_distance_in_world(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = (T_world_cam @ [np.median(x), np.median(y), np.median(z), 1])[:3]
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), pos
    return best, best_pos


def w_inverse_pose(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    T = np.linalg.inv(T_world_cam)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T[:3, :3] @ pos + T[:3, 3]
    return best, best_pos


def w_row_times_rotation(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), pos @ T_world_cam[:3, :3] + T_world_cam[:3, 3]
    return best, best_pos


def w_stays_in_camera(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), pos
    return best, best_pos


def w_height_for_width(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(y) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_nearest_then_width(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    found = []
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        found.append((np.linalg.norm(pos), k, np.ptp(x), pos))
    if not found:
        return None, None
    _, k, width, pos = min(found, key=lambda f: f[0])
    if width > max_width:
        return None, None
    return k, T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]


def w_nothing_fits_crashes(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    found = []
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width:
            found.append((np.linalg.norm(pos), k, pos))
    _, k, pos = min(found, key=lambda f: f[0])
    return k, T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]


def w_single_none(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best = None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and (best is None or np.linalg.norm(pos) < best[0]):
            best = np.linalg.norm(pos), k, pos
    if best is None:
        return None
    return best[1], T_world_cam[:3, :3] @ best[2] + T_world_cam[:3, 3]


def w_no_valid_pixel_crashes(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in np.unique(labels[labels > 0]):
        v, u = np.nonzero((labels == k) & valid)
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if x.max() - x.min() <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = int(k), np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_last_label_missing(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max()):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_nearest_point(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
        d = np.linalg.norm(p, axis=1).min()
        if np.ptp(p[:, 0]) <= max_width and d < best_d:
            pos = np.median(p, axis=0)
            best, best_d, best_pos = k, d, T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_median_in_world(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
        world = p @ T_world_cam[:3, :3].T + T_world_cam[:3, 3]
        pos = np.median(world, axis=0)
        d = np.linalg.norm(pos - T_world_cam[:3, 3])
        if np.ptp(p[:, 0]) <= max_width and d < best_d:
            best, best_d, best_pos = k, d, pos
    return best, best_pos


def w_width_in_world(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=1)
        world = p @ T_world_cam[:3, :3].T + T_world_cam[:3, 3]
        pos = np.median(p, axis=0)
        if np.ptp(world[:, 0]) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d = k, np.linalg.norm(pos)
            best_pos = T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_width_from_box(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        width = (u.max() - u.min() + 1) * pos[2] / K[0, 0]
        if width <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_fx_for_y(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[0, 0]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_center_pixel(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x = (u - K[0, 2]) * z / K[0, 0]
        uc, vc, zc = np.median(u), np.median(v), np.median(z)
        pos = np.array([(uc - K[0, 2]) * zc / K[0, 0], (vc - K[1, 2]) * zc / K[1, 1], zc])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_rows_and_columns_swapped(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        u, v = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[u, v].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.ptp(x) <= max_width and np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


def w_forgets_max_width(labels, depth_metric, K, T_world_cam, max_width):
    valid = (depth_metric > 0.01) & (depth_metric < 10)
    best, best_d, best_pos = None, np.inf, None
    for k in range(1, labels.max() + 1):
        v, u = np.nonzero((labels == k) & valid)
        if len(u) == 0:
            continue
        z = depth_metric[v, u].astype(float)
        x, y = (u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1]
        pos = np.array([np.median(x), np.median(y), np.median(z)])
        if np.linalg.norm(pos) < best_d:
            best, best_d, best_pos = k, np.linalg.norm(pos), T_world_cam[:3, :3] @ pos + T_world_cam[:3, 3]
    return best, best_pos


WRONG = [
    (w_depth_as_distance, "compares depth instead of the distance from the camera; an object with less depth but far to the side"),
    (w_mean, "mean instead of median; objects with depth outliers or skewed shapes"),
    (w_invalid_included, "invalid pixels count; objects with NaN, 0 or far-plane pixels"),
    (w_only_nan_dropped, "limits 0.01 and 10 m forgotten; far-plane pixels in an object"),
    (w_background_counts, "label 0 counts as an object; a near background no wider than max_width"),
    (w_distance_in_world, "distance from the world's origin instead of the camera; a camera away from the origin"),
    (w_inverse_pose, "inverse of the pose; every pose but the identity"),
    (w_row_times_rotation, "rotation transposed (row vector times R); every turned camera"),
    (w_stays_in_camera, "position stays in the camera frame; every pose but the identity"),
    (w_height_for_width, "extent in y instead of x; objects of other height than width"),
    (w_nearest_then_width, "chooses the nearest first and then checks its width; the nearest is too wide, the next one fits"),
    (w_nothing_fits_crashes, "min of an empty list raises; no object fits"),
    (w_single_none, "None instead of (None, None); no object fits"),
    (w_no_valid_pixel_crashes, "max of nothing raises; an object without a valid pixel"),
    (w_last_label_missing, "range ends one label early; the last label is the nearest, or the only one"),
    (w_nearest_point, "distance of the nearest point instead of the position; an object with a near tip"),
    (w_median_in_world, "median after the move to the world: not the same point; turned cameras, skewed objects"),
    (w_width_in_world, "width along the world's x; turned cameras"),
    (w_width_from_box, "width from the pixel box and the median depth; widths near max_width, objects with uneven depth"),
    (w_fx_for_y, "copy-paste slip: fx for y; fx other than fy"),
    (w_center_pixel, "median pixel and median depth instead of the median of the points; objects with uneven depth"),
    (w_rows_and_columns_swapped, "np.nonzero unpacked as (u, v); every object"),
    (w_forgets_max_width, "max_width ignored; the nearest is too wide"),
]


def _pose(seed):
    r = np.random.default_rng(seed)
    q, _ = np.linalg.qr(r.normal(size=(3, 3)))
    q *= np.linalg.det(q)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = q, r.uniform(-2, 2, 3)
    return T


def _cases():
    K = np.array([[60.0, 0, 39.5], [0, 66.0, 29.5], [0, 0, 1]])

    def scene(seed, width, mod=None):
        def case():
            r = np.random.default_rng(seed)
            L = np.zeros((60, 80), np.int32)
            D = np.full((60, 80), 2.5, np.float32)
            for k, (v, u, h, w, z) in enumerate([(20, 30, 12, 8, 0.9), (5, 0, 20, 8, 0.8), (40, 20, 6, 40, 0.6), (25, 50, 6, 6, 1.3)], 1):
                L[v:v + h, u:u + w] = k
                D[v:v + h, u:u + w] = z + 0.02 * r.random((h, w)) ** 3 + 0.01 * np.arange(w) / w
            D[20:24, 30:33] = 12
            D[24:26, 30:34] = np.nan
            D[26, 30:38] = 0
            D[20:30, 37] = 0.95
            if mod:
                mod(L, D)
            return L, D, K.copy(), _pose(seed), width
        return case

    def no_valid(L, D):
        D[L == 1] = np.nan

    def near_back(L, D):
        D[L == 0] = np.nan
        D[0, 0] = 0.2

    def only_one(L, D):
        L[L != 4] = 0
        L[L == 4] = 1

    def tip(L, D):
        D[28, 52] = 1.0
        D[L == 1] = 1.1
        D[L == 2] = 3

    def far_side(L, D):
        D[L == 1] = 0.93
        D[L == 2] = 0.90
    return [scene(0, 0.2), scene(1, 0.2, far_side), scene(2, 1.0), scene(3, 0.01), scene(4, 0.2, no_valid), scene(5, 0.2, near_back),
            scene(6, 0.3, only_one), scene(7, 0.2, tip), scene(8, 0.12, far_side), scene(9, 0.115)]
