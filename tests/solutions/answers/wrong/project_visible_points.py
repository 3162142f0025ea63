"""Wrong answers to project_visible_points, as strangers wrote them."""
import cv2
import numpy as np


def _right(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    pixels = np.full((len(p), 2), np.nan)
    visible = np.zeros(len(p), bool)
    for i, (x, y, z) in enumerate(p):
        if z <= 0.01:
            continue
        pixels[i] = K[0, 0] * x / z + K[0, 2], K[1, 1] * y / z + K[1, 2]
        u, v = np.rint(pixels[i])
        if 0 <= u < w and 0 <= v < h:
            d = float(depth_metric[int(v), int(u)])
            visible[i] = not (0.01 < d < 10) or z <= d + 0.02
    return pixels, visible


def w_pose_not_inverted(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = points_world @ T_world_cam[:3, :3].T + T_world_cam[:3, 3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i])
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[int(v), int(u)]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_rotation_transposed(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3].T
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i])
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[int(v), int(u)]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_mujoco_axes(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    R = T_world_cam[:3, :3] @ np.diag([1, -1, -1])
    p = (points_world - T_world_cam[:3, 3]) @ R
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i])
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[int(v), int(u)]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_cuts_instead_of_rounding(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = int(pixels[i, 0]), int(pixels[i, 1])
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_tests_unrounded(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = pixels[i]
        if 0 <= u <= w - 1 and 0 <= v <= h - 1:
            d = depth_metric[round(v), round(u)]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_index_swapped(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < h and 0 <= v < w:
            d = depth_metric[u, v]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_behind_not_nan(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    pixels = p[:, :2] / z[:, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    u, v = np.rint(pixels).T
    inside = (z > 0.01) & (u >= 0) & (u < w) & (v >= 0) & (v < h)
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(inside)[0]:
        d = depth_metric[int(v[i]), int(u[i])]
        visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_points_behind_are_seen(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    pixels = p[:, :2] / z[:, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    u, v = np.rint(pixels).T
    inside = (u >= 0) & (u < w) & (v >= 0) & (v < h)
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(inside)[0]:
        d = depth_metric[int(v[i]), int(u[i])]
        visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    pixels[z <= 0.01] = np.nan
    return pixels, visible


def w_pixels_rounded(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = np.rint(p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2])
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = pixels[i].astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_nan_outside_picture(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
        else:
            pixels[i] = np.nan
    return pixels, visible


def w_no_occlusion(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    u, v = np.rint(pixels).T
    visible = ok & (u >= 0) & (u < w) & (v >= 0) & (v < h)
    return pixels, visible


def w_invalid_hides(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            visible[i] = z[i] <= depth_metric[v, u] + 0.02
    return pixels, visible


def w_far_plane_hides(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not np.isfinite(d) or d <= 0.01 or z[i] <= d + 0.02
    return pixels, visible


def w_must_lie_on_surface(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or abs(z[i] - d) <= 0.02
    return pixels, visible


def w_no_tolerance(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d
    return pixels, visible


def w_tolerance_on_wrong_side(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] + 0.02 <= d
    return pixels, visible


def w_compares_ray_length(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    r = np.linalg.norm(p, axis=1)
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or r[i] <= d + 0.02
    return pixels, visible


def w_one_column_too_many(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u <= w and 0 <= v <= h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_negative_index(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        try:
            d = depth_metric[v, u]
        except IndexError:
            continue
        visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_clips_to_border(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    u, v = np.rint(np.nan_to_num(pixels)).astype(int).T
    d = depth_metric[np.clip(v, 0, h - 1), np.clip(u, 0, w - 1)]
    invalid = ~((d > 0.01) & (d < 10))
    return pixels, ok & (invalid | (z <= d + 0.02))


def w_fixed_size(points_world, T_world_cam, K, depth_metric):
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < 640 and 0 <= v < 480:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_own_center(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0.01
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * K[0, 0] + [(w - 1) / 2, (h - 1) / 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_only_points_in_front(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    p = p[p[:, 2] > 0.01]
    z = p[:, 2]
    pixels = p[:, :2] / z[:, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in range(len(p)):
        u, v = np.rint(pixels[i]).astype(int)
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[v, u]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_opencv_pose(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    rvec, _ = cv2.Rodrigues(T_world_cam[:3, :3])
    pixels = cv2.projectPoints(points_world, rvec, T_world_cam[:3, 3], K, None)[0].reshape(-1, 2)
    z = (points_world @ T_world_cam[:3, :3].T + T_world_cam[:3, 3])[:, 2]
    pixels[z <= 0.01] = np.nan
    visible = np.zeros(len(z), bool)
    for i in np.nonzero(z > 0.01)[0]:
        u, v = np.rint(pixels[i])
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[int(v), int(u)]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


def w_near_limit_zero(points_world, T_world_cam, K, depth_metric):
    h, w = depth_metric.shape
    p = (points_world - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    z = p[:, 2]
    ok = z > 0
    pixels = np.full((len(p), 2), np.nan)
    pixels[ok] = p[ok, :2] / z[ok, None] * [K[0, 0], K[1, 1]] + K[:2, 2]
    visible = np.zeros(len(p), bool)
    for i in np.nonzero(ok)[0]:
        u, v = np.rint(pixels[i])
        if 0 <= u < w and 0 <= v < h:
            d = depth_metric[int(v), int(u)]
            visible[i] = not (0.01 < d < 10) or z[i] <= d + 0.02
    return pixels, visible


WRONG = [
    (w_pose_not_inverted, "applies the pose instead of its inverse; every pose but the identity"),
    (w_rotation_transposed, "rotation in the wrong direction; every turned camera"),
    (w_mujoco_axes, "changes MuJoCo's axes although the pose has OpenCV's already; every point"),
    (w_cuts_instead_of_rounding, "cuts pixels to whole numbers; fractions above one half at a depth edge, u between -1 and -0.5"),
    (w_tests_unrounded, "tests the unrounded pixel against 0 and W-1; points in the outer half of a border pixel"),
    (w_index_swapped, "depth[u, v]; every point off the diagonal"),
    (w_behind_not_nan, "pixels of points behind the camera are numbers; a point behind"),
    (w_points_behind_are_seen, "points behind the camera count as visible; a point behind whose mirror image lies in the picture"),
    (w_pixels_rounded, "answers rounded pixels; every point"),
    (w_nan_outside_picture, "NaN outside the picture; a point outside"),
    (w_no_occlusion, "depth image is not compared; a hidden point"),
    (w_invalid_hides, "invalid pixels hide points; NaN, 0, or 12 m with a point beyond"),
    (w_far_plane_hides, "upper limit of validity forgotten; a point beyond 12 m behind a far-plane pixel"),
    (w_must_lie_on_surface, "absolute difference: points in front of the surface are hidden; a point in the air"),
    (w_no_tolerance, "0.02 m forgotten; a point 0.01 m behind the measured depth"),
    (w_tolerance_on_wrong_side, "0.02 m added to the wrong side; a point on the surface"),
    (w_compares_ray_length, "compares the distance with the depth; surface points off the axis"),
    (w_one_column_too_many, "<= W instead of < W: IndexError; u = W after rounding"),
    (w_negative_index, "negative indices wrap around to the other side; points left of or above the picture"),
    (w_clips_to_border, "clips pixels to the border, so points outside are visible; points outside"),
    (w_fixed_size, "640 x 480 written into the code: IndexError; points outside a smaller picture"),
    (w_own_center, "center of the picture and fx for both instead of K; K with another center, fx other than fy"),
    (w_only_points_in_front, "leaves out points behind the camera, so N changes; a point behind"),
    (w_opencv_pose, "hands the camera's pose to projectPoints, which wants its inverse; every pose but the identity"),
    (w_near_limit_zero, "limit 0 instead of 0.01 m; a point at 0.005 m"),
]


def _cases():
    K = np.array([[60.0, 0, 20.2], [0, 66.0, 13.9], [0, 0, 1]])

    def make(seed):
        def case():
            r = np.random.default_rng(seed)
            D = np.full((30, 44), 1.5, np.float32)
            D[8:20, 10:25] = 0.8
            D[0:6, 30:40] = 12
            D[22:28, 2:12] = np.nan
            D[22:28, 30:40] = 0
            n = 150
            u, v = r.uniform(-8, 52, n), r.uniform(-8, 38, n)
            z = r.uniform(0.3, 2.5, n)
            near = r.random(n) < 0.5
            ui, vi = np.clip(np.rint(u), 0, 43).astype(int), np.clip(np.rint(v), 0, 29).astype(int)
            z[near] = (np.nan_to_num(D[vi, ui], nan=1.0) + r.choice([-0.3, -0.01, 0.0005, 0.01, 0.03], n))[near]
            z[(z < 0.1)] = 1.0
            u[:6] = [-0.4, -0.6, -0.9, 43.4, 43.7, 44.1]
            v[:6] = [3.1, 3.2, 29.4, 29.3, 12.4, 11.3]
            z[:6] = 0.5
            z[6:12] = -z[6:12]
            z[12], u[12], v[12] = 0.005, 15, 15
            u[13], v[13], z[13] = 34, 3, 14.0
            u[14], v[14], z[14] = 5, 25, 3.0
            p = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], 1)
            q, _ = np.linalg.qr(r.normal(size=(3, 3)))
            q *= np.linalg.det(q)
            t = r.uniform(-1, 1, 3)
            T = np.eye(4)
            T[:3, :3], T[:3, 3] = q, t
            return p @ q.T + t, T, K.copy(), D
        return case
    return [make(0), make(1), make(2)]
