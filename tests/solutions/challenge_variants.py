"""Right answers to the challenges, each written in three ways that no card contains."""

import cv2
import mujoco
import numpy as np


def stale_by_loop(images, pans, noise):
    stale = [False]
    for t in range(1, len(images)):
        moved = abs(pans[t] - pans[t - 1]) > 0.001
        stale.append(bool(moved and cv2.absdiff(images[t], images[t - 1]).max() <= noise))
    return stale


def stale_by_float(images, pans, noise):
    same = (np.ptp([images[1:], images[:-1]], axis=0) <= noise).all(axis=(1, 2, 3))
    return np.concatenate([[False], same & (np.abs(pans[1:] - pans[:-1]) > 0.001)])


def stale_as_tuple(images, pans, noise):
    return tuple(stale_by_loop(images.astype(np.float32), pans, noise))


def pan_by_two_arguments(u, pan, fov_y, width, height):
    return pan + np.arctan2((width - 1) / 2 - u, height / 2 / np.tan(fov_y / 2))


def pan_by_complex_number(u, pan, fov_y, width, height):
    focal_px = height / 2 * np.cos(fov_y / 2) / np.sin(fov_y / 2)
    return np.angle(np.exp(1j * pan) * (focal_px + 1j * (width / 2 - 0.5 - u)))


def pan_in_single_precision(u, pan, fov_y, width, height):
    return np.float32(pan_by_two_arguments(u, pan, fov_y, width, height))


def rank_by_loop(model, data, point_world):
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
    pairs = [
        (sum((a - b) ** 2 for a, b in zip(place, point_world, strict=True)) ** 0.5, number)
        for number, place in enumerate(data.cam_xpos)
    ]
    return [number for _, number in sorted(pairs)], [distance for distance, _ in sorted(pairs)]


def rank_by_name(model, data, point_world):
    mujoco.mj_forward(model, data)
    names = [model.camera(n).name for n in range(model.ncam)]
    gaps = {n: cv2.norm(data.camera(n).xpos - point_world) for n in names}
    names.sort(key=gaps.get)
    return np.int32([model.camera(n).id for n in names]), np.float32([gaps[n] for n in names])


def rank_as_tuples(model, data, point_world):
    ids, distances = rank_by_loop(model, data, point_world)
    return tuple(ids), tuple(distances)


def camera_by_matrix(points, pixels, fovs, width, height):
    errors = []
    for fov in fovs:
        f = height / 2 / np.tan(fov / 2)
        K = np.array([[f, 0, width / 2 - 0.5], [0, f, height / 2 - 0.5], [0, 0, 1]])
        projected = points @ K.T
        gaps = projected[:, :2] / projected[:, 2:] - pixels
        errors.append(np.mean(np.hypot(*gaps.T)))
    best = int(np.argmin(errors))
    return best, errors[best]


def camera_by_cv2(points, pixels, fovs, width, height):
    best = (np.inf, 0)
    for number, fov in enumerate(fovs):
        f = height / 2 / np.tan(fov / 2)
        K = np.array([[f, 0, (width - 1) / 2], [0, f, (height - 1) / 2], [0, 0, 1]])
        projected, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), K, None)
        best = min(best, (np.linalg.norm(projected[:, 0] - pixels, axis=1).mean(), number))
    return [best[1], best[0]]


def camera_in_single_precision(points, pixels, fovs, width, height):
    camera, error = camera_by_matrix(np.float32(points), np.float32(pixels), fovs, width, height)
    return np.int64(camera), np.float32(error)


def fill_by_loop(depth_metric):
    depth = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, 0).astype(float)
    while (holes := np.argwhere(depth == 0)).size:
        before = np.pad(depth, 1)
        for v, u in holes:
            depth[v, u] = before[v : v + 3, u : u + 3].max()
    return depth


def fill_by_windows(depth_metric):
    depth = np.nan_to_num(depth_metric, nan=0, posinf=0, neginf=0)
    depth[(depth <= 0.01) | (depth >= 10)] = 0
    while not depth.all():
        windows = np.lib.stride_tricks.sliding_window_view(np.pad(depth, 1), (3, 3))
        depth = np.where(depth > 0, depth, windows.max(axis=(2, 3)))
    return depth


def fill_as_lists(depth_metric):
    return fill_by_windows(depth_metric).tolist()


def _split(rgb_image, color_ranges, min_area):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(int)
    for name, low, high in color_ranges:
        hue = (hsv[..., 0] - low[0]) % 180 <= (high[0] - low[0]) % 180
        rest = (hsv[..., 1:] >= low[1:]).all(2) & (hsv[..., 1:] <= high[1:]).all(2)
        count, regions = cv2.connectedComponents(np.uint8(hue & rest))
        for number in range(1, count):
            v, u = np.nonzero(regions == number)
            if len(v) >= min_area:
                yield name, len(v), (u.min(), v.min(), np.ptp(u) + 1, np.ptp(v) + 1)


def objects_by_labels(rgb_image, color_ranges, min_area):
    found = sorted(_split(rgb_image, color_ranges, min_area), key=lambda one: -one[1])
    return tuple(zip(*found, strict=True))


def objects_as_arrays(rgb_image, color_ranges, min_area):
    names, areas, boxes = objects_by_labels(rgb_image, color_ranges, min_area)
    return np.array(names), np.array(areas, np.int32), np.array(boxes)


def objects_by_outlines(rgb_image, color_ranges, min_area):
    # The outline runs through pixel centers: add half of its length and one (Pick's theorem).
    found = []
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV)
    for name, low, high in color_ranges:
        turned = hsv.copy()
        turned[..., 0] = (hsv[..., 0].astype(int) - low[0]) % 180
        mask = cv2.inRange(turned, (0, *low[1:]), ((high[0] - low[0]) % 180, *high[1:]))
        for outline in cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]:
            area = round(cv2.contourArea(outline) + len(outline) / 2 + 1)
            if area >= min_area:
                found.append((area, name, list(cv2.boundingRect(outline))))
    found.sort(reverse=True)
    return [f[1] for f in found], [f[0] for f in found], [f[2] for f in found]


def nearest_by_sorting(labels, depth_metric, K, T_world_cam, max_width):
    z = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.nan)
    v, u = np.indices(z.shape)
    cloud = np.stack([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z], axis=2)
    choices = []
    for label in set(labels.ravel().tolist()) - {0}:
        points = cloud[labels == label]
        if np.nanmax(points[:, 0]) - np.nanmin(points[:, 0]) <= max_width:
            place = np.nanmedian(points, axis=0)
            choices.append((np.linalg.norm(place), label, T_world_cam @ [*place, 1]))
    if not choices:
        return None, None
    _, label, place = min(choices, key=lambda choice: choice[0])
    return label, place[:3]


def nearest_as_lists(labels, depth_metric, K, T_world_cam, max_width):
    label, place = nearest_by_sorting(labels, depth_metric, K, T_world_cam, max_width)
    return [label, place if place is None else place.tolist()]


def nearest_in_single_precision(labels, depth_metric, K, T_world_cam, max_width):
    label, place = nearest_by_sorting(labels, depth_metric, np.float32(K), T_world_cam, max_width)
    return (None, None) if label is None else (np.int32(label), np.float32(place))


def size_by_inverse(mask, depth_metric, K):
    z = np.where((mask == 255) & (depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.nan)
    z[np.abs(z - np.nanmedian(z)) > 0.05] = np.nan
    v, u = np.nonzero(np.isfinite(z))
    points = np.linalg.inv(K) @ np.stack([u, v, np.ones_like(u)]) * z[v, u]
    return points[:2].max(axis=1) - points[:2].min(axis=1)


def size_as_list(mask, depth_metric, K):
    return [float(side) for side in size_by_inverse(mask, depth_metric, K)]


def size_in_single_precision(mask, depth_metric, K):
    return size_by_inverse(mask, depth_metric, np.float32(K)).astype(np.float32)


def region_by_homogeneous(points_world, T_world_robot, low, high):
    moved = np.linalg.solve(T_world_robot, np.c_[points_world, np.ones(len(points_world))].T)[:3].T
    return moved[(moved == np.clip(moved, low, high)).all(axis=1)]


def region_backwards(points_world, T_world_robot, low, high):
    return region_by_homogeneous(points_world[::-1], T_world_robot, low, high).astype(np.float32)


def region_by_loop(points_world, T_world_robot, low, high):
    kept = []
    for point in points_world:
        moved = T_world_robot[:3, :3].T @ (point - T_world_robot[:3, 3])
        if all(a <= b <= c for a, b, c in zip(low, moved, high, strict=True)):
            kept.append(tuple(moved))
    return kept


def level_by_eigenvectors(points):
    rng, best = np.random.default_rng(5), (0, None)
    for _ in range(60):
        some = points[rng.permutation(len(points))[:3]]
        normal = np.cross(some[1] - some[0], some[2] - some[0])
        near = np.abs((points - some[0]) @ normal) / np.linalg.norm(normal) < 0.006
        best = max(best, (near.sum(), near), key=lambda pair: pair[0])
    near = best[1]
    for _ in range(4):
        center = points[near].mean(axis=0)
        normal = np.linalg.eigh(np.cov(points[near].T))[1][:, 0]
        near = np.abs((points - center) @ normal) < 0.012
    normal = normal if normal @ center < 0 else -normal
    d = -normal @ center
    axis = np.cross(normal, [0, 0, 1])
    angle = np.arctan2(np.linalg.norm(axis), normal[2])
    R, _ = cv2.Rodrigues(axis / np.linalg.norm(axis) * angle)
    return np.r_[normal, d], (R @ points.T).T + np.array([0, 0, d])


def level_by_columns(points):
    plane, _ = level_by_eigenvectors(points)
    n, up = plane[:3], np.array([0.0, 0, 1])
    # Two reflections make the smallest rotation: at the plane of n, then at the plane between.
    half = (n + up) / np.linalg.norm(n + up)
    moved = points - 2 * np.outer(points @ n, n)
    moved = moved - 2 * np.outer(moved @ half, half)
    moved[:, 2] += plane[3]
    return plane, moved


def level_as_lists(points):
    plane, leveled = level_by_columns(points)
    return plane.tolist(), leveled.tolist()


def visible_by_homogeneous(points_world, T_world_cam, K, depth_metric):
    points = np.linalg.solve(T_world_cam, np.c_[points_world, np.ones(len(points_world))].T)[:3]
    u, v, z = K @ points
    pixels = np.where(z > 0.01, [u / z, v / z], np.nan).T
    surface = np.where((depth_metric > 0.01) & (depth_metric < 10), depth_metric, np.inf)
    seen = []
    for (column, row), depth in zip(pixels, z, strict=True):
        inside = (
            depth > 0.01
            and -0.5 <= column < depth_metric.shape[1] - 0.5
            and -0.5 <= row < depth_metric.shape[0] - 0.5
        )
        seen.append(bool(inside and depth - 0.02 <= surface[round(row), round(column)]))
    return pixels, seen


def visible_by_cv2(points_world, T_world_cam, K, depth_metric):
    back = np.linalg.inv(T_world_cam)
    turn, _ = cv2.Rodrigues(back[:3, :3])
    pixels = cv2.projectPoints(points_world, turn, back[:3, 3], K, None)[0][:, 0]
    z = (back @ np.c_[points_world, np.ones(len(points_world))].T)[2]
    pixels[z <= 0.01] = np.nan
    padded = np.pad(depth_metric, 1, constant_values=-1)  # a frame that says: outside
    u, v = np.clip(np.nan_to_num(np.rint(pixels), nan=-1).astype(int), -1, None).T
    u, v = np.minimum(u, depth_metric.shape[1]), np.minimum(v, depth_metric.shape[0])
    found = padded[v + 1, u + 1]
    hides = (found > 0.01) & (found < 10) & (z > found + 0.02)
    return pixels, (found != -1) & ~hides


def visible_in_single_precision(points_world, T_world_cam, K, depth_metric):
    pixels, seen = visible_by_homogeneous(points_world, T_world_cam, K, depth_metric)
    return pixels.astype(np.float32), np.array(seen)


def map_by_sorting(points_world, colors, low, high, pixels_per_meter):
    order = np.argsort(points_world[:, 2])
    height, width = (round(float(side)) for side in (high - low) * pixels_per_meter)
    picture = np.zeros((height, width, 3), np.uint8)
    for point, color in zip(points_world[order], colors[order], strict=True):
        row, column = ((high - point[:2]) * pixels_per_meter).tolist()
        if 0 <= row < height and 0 <= column < width:
            picture[int(row), int(column)] = 255 * color
    return picture


def map_by_unique(points_world, colors, low, high, pixels_per_meter):
    size = np.rint((high - low) * pixels_per_meter).astype(int)
    place = np.floor((high - points_world[:, :2]) * pixels_per_meter).astype(int)
    keep = ((place >= 0) & (place < size)).all(axis=1)
    order = np.flatnonzero(keep)[np.argsort(-points_world[keep, 2])]
    flat = place[order] @ [size[1], 1]
    cells, first = np.unique(flat, return_index=True)  # the first is the highest
    picture = np.zeros((size.prod(), 3))
    picture[cells] = colors[order][first] * 255
    return picture.round().astype(np.uint8).reshape(*size, 3)


def map_as_lists(points_world, colors, low, high, pixels_per_meter):
    return map_by_unique(points_world, colors, low, high, pixels_per_meter).tolist()


def ply_by_dictionary(text):
    header, body = text.split("end_header\n")
    vertex = header[header.index("element vertex") :].splitlines()
    count, names = int(vertex[0].split()[2]), []
    for line in vertex[1:]:
        if line.startswith("element"):
            break
        if line.startswith("property"):
            names.append(line.split()[2])
    values = [line.split() for line in body.splitlines()[:count]]
    columns = {
        n: [float(v) for v in c] for n, c in zip(names, zip(*values, strict=True), strict=True)
    }
    points = np.stack([columns[n] for n in "xyz"], axis=1)
    if "red" not in columns:
        return points, None
    return points, np.stack([columns[n] for n in ("red", "green", "blue")], axis=1) / 255.0


def ply_in_single_precision(text):
    points, colors = ply_by_dictionary(text)
    return points.astype(np.float32)[::-1], None if colors is None else np.float32(colors)[::-1]


def ply_as_lists(text):
    points, colors = ply_by_dictionary(text)
    return points.tolist(), None if colors is None else colors.tolist()


CHALLENGE_VARIANTS = {
    "find_stale_frames": [stale_by_loop, stale_by_float, stale_as_tuple],
    "choose_pan": [pan_by_two_arguments, pan_by_complex_number, pan_in_single_precision],
    "rank_cameras": [rank_by_loop, rank_by_name, rank_as_tuples],
    "which_camera": [camera_by_matrix, camera_by_cv2, camera_in_single_precision],
    "fill_invalid_depth": [fill_by_loop, fill_by_windows, fill_as_lists],
    "find_all_objects": [objects_by_labels, objects_as_arrays, objects_by_outlines],
    "nearest_object": [nearest_by_sorting, nearest_as_lists, nearest_in_single_precision],
    "measure_object_size": [size_by_inverse, size_as_list, size_in_single_precision],
    "crop_region": [region_by_homogeneous, region_backwards, region_by_loop],
    "level_cloud": [level_by_eigenvectors, level_by_columns, level_as_lists],
    "project_visible_points": [
        visible_by_homogeneous,
        visible_by_cv2,
        visible_in_single_precision,
    ],
    "draw_top_view": [map_by_sorting, map_by_unique, map_as_lists],
    "read_ply": [ply_by_dictionary, ply_in_single_precision, ply_as_lists],
}
