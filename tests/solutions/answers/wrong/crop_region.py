"""Wrong answers to crop_region, as strangers wrote them."""
import numpy as np


def _right(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_pose_not_inverted(points_world, T_world_robot, low, high):
    p = points_world @ T_world_robot[:3, :3].T + T_world_robot[:3, 3]
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_transposed_pose(points_world, T_world_robot, low, high):
    ones = np.ones((len(points_world), 1))
    p = (np.hstack([points_world, ones]) @ np.linalg.inv(T_world_robot))[:, :3]
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_rotation_not_inverted(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R.T
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_shift_after_turn(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = points_world @ R - t
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_plus_position(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world + t) @ R
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_only_turned(points_world, T_world_robot, low, high):
    p = points_world @ T_world_robot[:3, :3]
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_only_shifted(points_world, T_world_robot, low, high):
    p = points_world - T_world_robot[:3, 3]
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_limits_excluded(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[((p > low) & (p < high)).all(axis=1)]


def w_upper_limit_excluded(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[((p >= low) & (p < high)).all(axis=1)]


def w_world_points_back(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    inside = ((p >= low) & (p <= high)).all(axis=1)
    return points_world[inside]


def w_box_in_world(points_world, T_world_robot, low, high):
    inside = ((points_world >= low) & (points_world <= high)).all(axis=1)
    return (points_world[inside] - T_world_robot[:3, 3]) @ T_world_robot[:3, :3]


def w_corners_to_world(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    a, b = R @ low + t, R @ high + t
    lo, hi = np.minimum(a, b), np.maximum(a, b)
    inside = ((points_world >= lo) & (points_world <= hi)).all(axis=1)
    return (points_world[inside] - t) @ R


def w_any_axis(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[((p >= low) & (p <= high)).any(axis=1)]


def w_height_forgotten(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    inside = (p[:, 0] >= low[0]) & (p[:, 0] <= high[0]) & (p[:, 1] >= low[1]) & (p[:, 1] <= high[1])
    return p[inside]


def w_y_checked_twice(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    x, y, z = ((points_world - t) @ R).T
    inside = (x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1]) & (y >= low[2]) & (z <= high[2])
    return np.stack([x, y, z], axis=1)[inside]


def w_all_values_flat(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[(p >= low) & (p <= high)]


def w_four_columns(points_world, T_world_robot, low, high):
    h = np.c_[points_world, np.ones(len(points_world))]
    p = h @ np.linalg.inv(T_world_robot).T
    return p[((p[:, :3] >= low) & (p[:, :3] <= high)).all(axis=1)]


def w_float32(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[((p >= low) & (p <= high)).all(axis=1)].astype(np.float32)


def w_returns_mask(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return np.logical_and(p >= low, p <= high).all(axis=1)


def w_moves_input(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    points_world -= t
    p = points_world @ R
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_unique(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    p = p[((p >= low) & (p <= high)).all(axis=1)]
    return np.unique(p, axis=0)


def w_yaw_only(points_world, T_world_robot, low, high):
    yaw = np.arctan2(T_world_robot[1, 0], T_world_robot[0, 0])
    c, s = np.cos(yaw), np.sin(yaw)
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    p = (points_world - T_world_robot[:3, 3]) @ R
    return p[((p >= low) & (p <= high)).all(axis=1)]


def w_absolute_values(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    return p[(np.abs(p) <= high).all(axis=1)]


def w_none_when_empty(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    inside = ((p >= low) & (p <= high)).all(axis=1)
    if inside.any():
        return p[inside]


def w_list_of_points(points_world, T_world_robot, low, high):
    Tinv = np.linalg.inv(T_world_robot)
    kept = []
    for point in points_world:
        q = (Tinv @ [*point, 1.0])[:3]
        if all(low[i] <= q[i] <= high[i] for i in range(3)):
            kept.append(q)
    return np.array(kept)


def w_stale_indices(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    p = (points_world - t) @ R
    inside = [(p[:, i] >= low[i]) & (p[:, i] <= high[i]) for i in range(3)]
    for keep in inside:
        p = p[keep]
    return p


def w_clips(points_world, T_world_robot, low, high):
    R, t = T_world_robot[:3, :3], T_world_robot[:3, 3]
    return np.clip((points_world - t) @ R, low, high)


WRONG = [
    (w_pose_not_inverted, "applies the pose instead of its inverse; every pose but the identity"),
    (w_transposed_pose, "row vectors times the inverse without the transpose; every turned or shifted robot"),
    (w_rotation_not_inverted, "rotation in the wrong direction; every turned robot"),
    (w_shift_after_turn, "subtracts the position after the turn; every turned robot off the origin"),
    (w_plus_position, "adds the position; robots off the origin"),
    (w_only_turned, "position forgotten; robots off the origin"),
    (w_only_shifted, "rotation forgotten; every turned robot"),
    (w_limits_excluded, "limits excluded; a point exactly on a limit"),
    (w_upper_limit_excluded, "upper limits excluded; a point exactly on an upper limit"),
    (w_world_points_back, "answers the points in the world frame; every pose but the identity"),
    (w_box_in_world, "compares world points with the robot's box; every pose but the identity"),
    (w_corners_to_world, "box of the two corners moved to the world; every turned robot"),
    (w_any_axis, "any instead of all; a point inside in one direction only"),
    (w_height_forgotten, "z is not compared; a point above or below the box"),
    (w_y_checked_twice, "copy-paste slip: y compared with the lower limit of z; boxes with different limits in y and z"),
    (w_all_values_flat, "mask of (N, 3) without all(axis=1): flat numbers; every input"),
    (w_four_columns, "homogeneous answer (M, 4); every input"),
    (w_float32, "float32; every input"),
    (w_returns_mask, "answers the mask; every input"),
    (w_moves_input, "moves the caller's points in place; robots off the origin"),
    (w_unique, "np.unique drops points that appear twice; a cloud with equal points"),
    (w_yaw_only, "turns about z only; a robot that is pitched or rolled"),
    (w_absolute_values, "compares absolute values with high, low unused; boxes that are not symmetric"),
    (w_none_when_empty, "None where no point is inside; an empty box"),
    (w_list_of_points, "np.array of an empty list has shape (0,); no point inside"),
    (w_stale_indices, "masks of the whole cloud applied one after the other: IndexError; a point outside in x or y"),
    (w_clips, "moves points outside onto the box instead of leaving them out; any point outside"),
]


def _cases():
    def pose(seed):
        r = np.random.default_rng(seed)
        q, _ = np.linalg.qr(r.normal(size=(3, 3)))
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = q * np.linalg.det(q), r.uniform(-1, 1, 3)
        return T

    def a(seed):
        def case():
            r = np.random.default_rng(seed)
            p = r.uniform(-2, 2, (60, 3))
            p[5] = p[6] = pose(seed)[:3, 3]
            return p, pose(seed), np.array([-0.5, -1.0, -0.2]), np.array([1.5, 0.4, 1.2])
        return case

    def edge():
        p = np.array([[1.0, 0, 0], [0.5, 0.5, 0.5], [0, 0, 0], [0.25, 1, 1], [2, 0.5, 0.5], [-0.5, 0.5, 0.5]])
        return p, np.eye(4), np.zeros(3), np.ones(3)

    def none():
        return np.random.default_rng(3).uniform(-1, 1, (5, 3)), pose(3), np.full(3, 50.0), np.full(3, 51.0)
    return [a(0), a(1), a(2), edge, none]


def _same(a, b):
    if not isinstance(a, np.ndarray) or a.shape != b.shape or a.dtype != b.dtype:
        return False
    s = lambda x: x[np.lexsort(np.round(x, 6).T)] if len(x) else x
    return np.allclose(s(a), s(b), atol=1e-8)
