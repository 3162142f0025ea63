"""Right answers that are written differently have to pass: three and more per function."""

from dataclasses import replace

import cv2
import mujoco
import numpy as np
import pytest

from labutils.checks import judge
from labutils.checks.calls import collect_answers
from labutils.checks.gates import find_failure
from labutils.checks.table import load_table
from solutions import load_exercises
from tests.solutions.challenge_variants import CHALLENGE_VARIANTS


def render_with_kinematics(model, data, renderer, camera_name):
    mujoco.mj_kinematics(model, data)
    mujoco.mj_camlight(model, data)
    renderer.update_scene(data, camera=camera_name)
    renderer.enable_depth_rendering()
    depth = renderer.render()
    renderer.disable_depth_rendering()
    return renderer.render(), depth


def render_by_id_in_double(model, data, renderer, camera_name):
    camera = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_CAMERA, camera_name)
    if camera == -1:
        raise ValueError(camera_name)
    mujoco.mj_forward(model, data)
    renderer.update_scene(data, camera)
    rgb = renderer.render().copy()
    renderer.enable_depth_rendering()
    depth = renderer.render().astype(np.float64)
    renderer.disable_depth_rendering()
    return [rgb, depth]


def render_as_lists(model, data, renderer, camera_name):
    rgb, depth = render_with_kinematics(model, data, renderer, camera_name)
    return rgb, depth.tolist()


def intrinsics_by_diagonal(fov_y, width, height):
    K = np.eye(3, dtype=np.float32)
    K[0, 0] = K[1, 1] = height / (2 * np.tan(fov_y / 2))
    K[:2, 2] = (width - 1) / 2, (height - 1) / 2
    return K


def intrinsics_as_lists(fov_y, width, height):
    f = height / 2 * np.cos(fov_y / 2) / np.sin(fov_y / 2)
    return [[f, 0, width / 2 - 0.5], [0, f, height / 2 - 0.5], [0, 0, 1]]


def intrinsics_as_tuples(fov_y, width, height):
    return tuple(map(tuple, intrinsics_as_lists(fov_y, width, height)))


def camera_by_lookup(model, camera_name, width, height):
    names = [model.camera(number).name for number in range(model.ncam)]
    camera = names.index(camera_name)  # ValueError for an unknown name
    fov_y = np.radians(model.cam_fovy[camera])
    K = intrinsics_by_diagonal(fov_y, width, height).astype(np.float64)
    sensor = model.cam_sensorsize[camera]
    if sensor.any():
        focal, shift = np.split(model.cam_intrinsic[camera], 2)
        scale = np.array([width, height]) / sensor
        K[[0, 1], [0, 1]] = focal * scale
        K[:2, 2] -= shift * scale
        top, bottom = (sensor[1] / 2 - shift[1]), (-sensor[1] / 2 - shift[1])
        fov_y = np.arctan2(top, focal[1]) - np.arctan2(bottom, focal[1])
    return K, fov_y


def camera_in_single_precision(model, camera_name, width, height):
    K, fov_y = camera_by_lookup(model, camera_name, width, height)
    return K.astype(np.float32), np.float32(fov_y)


def camera_as_lists(model, camera_name, width, height):
    K, fov_y = camera_by_lookup(model, camera_name, width, height)
    return [K.tolist(), np.array(fov_y)]


def depth_by_inverse(depth_raw, near, far):
    inverse = 1 / near + np.clip(depth_raw, 0, 1) * (1 / far - 1 / near)
    return 1 / inverse


def depth_by_ndc(depth_raw, near, far):
    ndc = 2 * np.clip(depth_raw.astype(np.float64), 0, 1) - 1
    return 2 * near * far / (far + near - ndc * (far - near))


def depth_in_place(depth_raw, near, far):
    # It overwrites its argument, which may change no other case.
    depth_raw[depth_raw < 0] = 0
    depth_raw[depth_raw > 1] = 1
    depth_raw[:] = near / (1 - depth_raw * (1 - near / far))
    return depth_raw


def depth_as_lists(depth_raw, near, far):
    return depth_by_ndc(depth_raw, near, far).tolist()


def _share(depth_metric, max_depth):
    good = np.isfinite(depth_metric) & (depth_metric > 0)
    return np.clip(np.where(good, depth_metric, 0) / max_depth, 0, 1), ~good


def picture_with_jet(depth_metric, max_depth):
    share, bad = _share(depth_metric, max_depth)
    picture = cv2.applyColorMap(np.rint(share * 255).astype(np.uint8), cv2.COLORMAP_JET)
    picture[bad] = (0, 0, 0)
    return picture


def picture_with_turbo_rounded(depth_metric, max_depth):
    share, bad = _share(depth_metric, max_depth)
    picture = cv2.applyColorMap(cv2.convertScaleAbs(share, alpha=255), cv2.COLORMAP_TURBO)
    return np.where(bad[..., None], np.uint8(0), picture)


def picture_by_hand(depth_metric, max_depth):
    share, bad = _share(depth_metric, max_depth)
    level = (share * 255).astype(np.uint8)
    picture = cv2.merge([255 - level, np.zeros_like(level), level])
    picture[bad] = 0
    return picture


def mask_by_numpy(rgb_image, target_hsv_range):
    hsv = cv2.cvtColor(cv2.cvtColor(rgb_image, cv2.COLOR_RGB2BGR), cv2.COLOR_BGR2HSV)
    (h0, s0, v0), (h1, s1, v1) = target_hsv_range
    hue, saturation, value = cv2.split(hsv)
    inside = (hue >= h0) & (hue <= h1) if h0 <= h1 else (hue >= h0) | (hue <= h1)
    inside &= (saturation >= s0) & (saturation <= s1) & (value >= v0) & (value <= v1)
    kernel = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
    mask = cv2.dilate(cv2.erode(np.uint8(inside) * 255, kernel), kernel)
    return cv2.erode(cv2.dilate(mask, kernel), kernel)


def mask_by_turned_hue(rgb_image, target_hsv_range):
    hsv = cv2.cvtColor(rgb_image, cv2.COLOR_RGB2HSV).astype(int)
    low, high = (np.array(limit) for limit in target_hsv_range)
    width = (high[0] - low[0]) % 180
    inside = (hsv[..., 0] - low[0]) % 180 <= width
    inside &= (hsv[..., 1:] >= low[1:]).all(-1) & (hsv[..., 1:] <= high[1:]).all(-1)
    mask = np.where(inside, np.uint8(255), np.uint8(0))
    for step in (cv2.MORPH_OPEN, cv2.MORPH_CLOSE):
        mask = cv2.morphologyEx(mask, step, np.ones((5, 5), np.uint8))
    return mask


def mask_as_lists(rgb_image, target_hsv_range):
    return mask_by_turned_hue(rgb_image, target_hsv_range).tolist()


def centroid_by_components(mask):
    count, _, stats, centers = cv2.connectedComponentsWithStats(mask)
    # A line has no area for cv2.contourArea: at least two pixels each way are needed.
    good = [n for n in range(1, count) if min(stats[n, 2], stats[n, 3]) > 1]
    if not good:
        return None
    return tuple(int(c) for c in centers[max(good, key=lambda n: stats[n, 4])])


def centroid_rounded_as_array(mask):
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    areas = [cv2.contourArea(contour) for contour in contours]
    if not areas or max(areas) == 0:
        return None
    m = cv2.moments(contours[int(np.argmax(areas))])
    return np.rint([m["m10"] / m["m00"], m["m01"] / m["m00"]]).astype(np.int32)


def centroid_as_list(mask):
    found = centroid_rounded_as_array(mask)
    return None if found is None else [np.int64(found[0]), np.int64(found[1])]


def cloud_column_by_column(depth_metric, K, rgb_image):
    points, colors = [], []
    for u in range(depth_metric.shape[1]):
        for v in range(depth_metric.shape[0]):
            z = float(depth_metric[v, u])
            if 0.01 < z < 10:
                points.append([(u - K[0, 2]) * z / K[0, 0], (v - K[1, 2]) * z / K[1, 1], z])
                colors.append([] if rgb_image is None else rgb_image[v, u] / 255)
    return points, None if rgb_image is None else colors


def cloud_by_inverse_matrix(depth_metric, K, rgb_image):
    v, u = np.nonzero((depth_metric > 0.01) & (depth_metric < 10))
    pixels = np.stack([u, v, np.ones_like(u)])
    points = (np.linalg.inv(K) @ pixels * depth_metric[v, u]).T
    return points, None if rgb_image is None else rgb_image[v, u] / 255.0


def cloud_by_cv2_backwards(depth_metric, K, rgb_image):
    height, width = depth_metric.shape
    grid = np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).reshape(-1, 1, 2)
    slopes = cv2.undistortPoints(grid.astype(np.float64), K, None).reshape(-1, 2)
    z = depth_metric.reshape(-1, 1)
    keep = ((z > 0.01) & (z < 10)).ravel()
    points = np.hstack([slopes * z, z])[keep][::-1].astype(np.float32)
    return points, None if rgb_image is None else (rgb_image.reshape(-1, 3)[keep] / 255)[::-1]


def world_by_homogeneous(points, cam_xpos, cam_xmat):
    T = np.eye(4)
    T[:3, :3] = np.reshape(cam_xmat, (3, 3)) * [1, -1, -1]
    T[:3, 3] = cam_xpos
    return (np.c_[points, np.ones(len(points))] @ T.T)[:, :3]


def world_in_single_precision(points, cam_xpos, cam_xmat):
    rotation = np.asarray(cam_xmat, np.float32).reshape(3, 3)
    turned = np.asarray(points, np.float32) * np.float32([1, -1, -1])
    return np.einsum("ij,nj->ni", rotation, turned) + cam_xpos.astype(np.float32)


def world_as_lists(points, cam_xpos, cam_xmat):
    return world_by_homogeneous(points, cam_xpos, cam_xmat).reshape(-1, 3)


VARIANTS = {
    "render_camera": [render_with_kinematics, render_by_id_in_double, render_as_lists],
    "intrinsics_matrix": [intrinsics_by_diagonal, intrinsics_as_lists, intrinsics_as_tuples],
    "get_camera_intrinsics": [camera_by_lookup, camera_in_single_precision, camera_as_lists],
    "process_depth": [depth_by_inverse, depth_by_ndc, depth_in_place, depth_as_lists],
    "visualize_depth": [picture_with_jet, picture_with_turbo_rounded, picture_by_hand],
    "segment_by_color": [mask_by_numpy, mask_by_turned_hue, mask_as_lists],
    "find_object_centroid": [centroid_by_components, centroid_rounded_as_array, centroid_as_list],
    "depth_to_pointcloud": [
        cloud_column_by_column,
        cloud_by_inverse_matrix,
        cloud_by_cv2_backwards,
    ],
    "camera_to_world": [world_by_homogeneous, world_in_single_precision, world_as_lists],
    **CHALLENGE_VARIANTS,
}


def test_every_exercise_has_three_variants():
    assert set(VARIANTS) == set(load_exercises())
    assert all(len(functions) >= 3 for functions in VARIANTS.values())


@pytest.mark.parametrize(
    ("name", "function"),
    [(name, function) for name, functions in VARIANTS.items() for function in functions],
)
def test_right_answer_written_differently_passes(name, function):
    verdict = judge(load_table(name), function)
    assert verdict.passed, verdict.message


@pytest.mark.parametrize(
    ("name", "function"),
    [(name, function) for name, functions in VARIANTS.items() for function in functions],
)
def test_right_answer_written_differently_passes_hidden_cases(name, function):
    exercise = load_exercises()[name]
    for seed in range(3):
        cases = exercise.hidden(np.random.default_rng(seed))
        expected = exercise.collect(exercise.reference, cases)
        table = replace(load_table(name), cases=cases, expected=expected, wrong={})
        assert find_failure(table, collect_answers(table, function)) is None
