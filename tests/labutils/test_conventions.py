"""Pins: each convention of the book on an asymmetric camera, with the rival's number beside it."""

from __future__ import annotations

import cv2
import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose

from labutils import (
    camera_to_world,
    get_camera_intrinsics,
    get_camera_pose,
    intrinsics_matrix,
    make_renderer,
    points_to_pixels,
    raycast_depth,
    render_camera,
    render_raw_depth,
    segment_by_color,
    visualize_depth,
    world_to_camera,
)
from labutils._constants import FLIP_YZ
from tests.helpers.tolerances import DEPTH_MEDIAN_MM, EXACT


def test_pixel_center_is_the_integer_so_the_middle_is_half_of_width_minus_one() -> None:
    # The rival, W/2 and H/2, would give 320.5 and 150.5: half a pixel more.
    K = intrinsics_matrix(0.9, 641, 301)
    assert_allclose(K[:2, 2], [320.0, 150.0], rtol=0, atol=EXACT)


def see_by_both(model: mujoco.MjModel, data: mujoco.MjData) -> tuple[np.ndarray, np.ndarray]:
    """Return the depth of the sensor camera as it is drawn, and as rays find it."""
    with make_renderer(model, 301, 401) as renderer:
        _, depth = render_camera(model, data, renderer, "sensor")
    return depth, raycast_depth(model, data, "sensor", 401, 301)


def test_half_a_pixel_shows_against_the_rays(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    # With (W-1)/2 depth agrees with the rays far below 0.01 mm; rays through W/2 hit the tilted
    # cube elsewhere, which is worth 0.1 mm and more.
    model, data = asymmetric
    depth, truth = see_by_both(model, data)
    on_cube = np.abs(truth - 1.5) < 0.1
    ours_mm = 1000 * np.abs(depth - truth)[on_cube]
    K, _ = get_camera_intrinsics(model, "sensor", 401, 301)
    shifted = _raycast_with(model, data, K + np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]))
    assert np.median(ours_mm) < DEPTH_MEDIAN_MM
    assert np.median(1000 * np.abs(depth - shifted)[on_cube]) > 0.1


def _raycast_with(model: mujoco.MjModel, data: mujoco.MjData, K: np.ndarray) -> np.ndarray:
    """Cast one mj_ray per pixel of the 401x301 sensor camera with other intrinsics."""
    u, v = np.meshgrid(np.arange(401), np.arange(301))
    rays = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(u.shape)], -1)
    camera = model.camera("sensor").id
    rays = rays @ (data.cam_xmat[camera].reshape(3, 3) @ FLIP_YZ).T
    count = u.size
    geom_ids, distances = np.zeros(count, np.int32), np.zeros(count)
    origin = data.cam_xpos[camera]
    # Not normalized: the unit of distance is then one meter along the optical axis.
    mujoco.mj_multiRay(
        model, data, origin, rays.ravel(), None, 1, -1, geom_ids, distances, None, count, 1e10
    )
    return distances.reshape(u.shape)


@pytest.mark.parametrize("camera", ["sensor", "plain"])
def test_intrinsics_put_a_body_where_the_picture_shows_it(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData], camera: str
) -> None:
    # The rivals: fovy taken as horizontal would be off by 10 px, an unsigned principal point by
    # 75 px, for the ball's center.
    model, data = asymmetric
    width, height = 401, 301
    truth = raycast_depth(model, data, camera, width, height)
    rows, columns = np.nonzero(np.abs(truth - 1.97) < 0.05)
    K, _ = get_camera_intrinsics(model, camera, width, height)
    cam_id = model.camera(camera).id
    ball = world_to_camera(
        data.body("ball").xpos[None], data.cam_xpos[cam_id], data.cam_xmat[cam_id]
    )
    pixel = points_to_pixels(ball, K)[0]
    # A sphere's outline is an ellipse whose center is not the projected center: 0.5 px here.
    assert_allclose([columns.mean(), rows.mean()], pixel, rtol=0, atol=0.6)


def test_opengl_draws_the_same_pixels_as_the_intrinsics_say(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    depth, truth = see_by_both(*asymmetric)
    drawn = np.argwhere(np.abs(depth - 1.97) < 0.05).mean(axis=0)
    cast = np.argwhere(np.abs(truth - 1.97) < 0.05).mean(axis=0)
    # The outlines may differ in a few pixels: MuJoCo draws the ball as a polygon.
    assert_allclose(drawn, cast, rtol=0, atol=0.2)


def test_field_of_view_of_a_sensor_camera_spans_its_upper_and_lower_edge(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    # 2 atan(sensor / 2 focal) would be right only for a centered principal point: 0.6435 rad.
    model, _ = asymmetric
    _, fov_y = get_camera_intrinsics(model, "sensor", 401, 301)
    assert_allclose(fov_y, np.arctan(0.0015 / 0.006) + np.arctan(0.0025 / 0.006), rtol=1e-6)


def test_resolution_of_a_sensor_camera_plays_no_part(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, _ = asymmetric
    before, _ = get_camera_intrinsics(model, "sensor", 401, 301)
    model.cam_resolution[model.camera("sensor").id] = (100, 100)
    after, _ = get_camera_intrinsics(model, "sensor", 401, 301)
    assert_allclose(after, before, rtol=0, atol=0)


def test_camera_frame_is_x_right_y_down_z_forward(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    # MuJoCo's own axes (y up, looking along -z) would give a negative third and flipped second.
    model, data = scene
    T_world_cam = get_camera_pose(model, data, "head_camera")
    in_cam = np.linalg.inv(T_world_cam) @ np.append(data.body("red_box").xpos, 1)
    # Seen from the head: left of the middle, in the lower half, in front.
    assert in_cam[0] < 0 < in_cam[1]
    assert in_cam[2] > 0.5


def test_pose_and_camera_to_world_are_the_same_transform(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    cam_id = model.camera("left_eye").id
    point = np.array([[0.1, -0.2, 1.3]])
    by_pose = get_camera_pose(model, data, "left_eye") @ np.append(point[0], 1)
    by_function = camera_to_world(point, data.cam_xpos[cam_id], data.cam_xmat[cam_id])[0]
    assert_allclose(by_function, by_pose[:3], rtol=0, atol=EXACT)


def test_depth_is_along_the_optical_axis_not_along_the_ray(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    # At the corner of the plain camera the ray is 1.17 times as long as its depth.
    model, data = asymmetric
    depth = raycast_depth(model, data, "plain", 401, 301)
    # The wall's front face is a plane at x = 2.95, seen head on: one depth wherever it is seen.
    assert_allclose([depth[0, 0], depth[0, -1], depth[-1, -1]], 2.95, rtol=1e-6)


def test_raw_depth_is_zero_near_and_one_far(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    with make_renderer(model, 48, 64) as renderer:
        _, depth = render_camera(model, data, renderer, "head_camera")
        raw = render_raw_depth(model, data, renderer, "head_camera")
    nearest, farthest = np.argmin(depth), np.argmax(np.where(depth < 11, depth, 0))
    assert raw.ravel()[nearest] < raw.ravel()[farthest] < 1


def test_eyes_are_one_named_baseline_apart(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    left, right = (data.cam_xpos[model.camera(name).id] for name in ("left_eye", "right_eye"))
    baseline = model.numeric("eye_baseline").data[0]
    assert_allclose(np.linalg.norm(left - right), baseline, rtol=0, atol=EXACT)
    # The right eye lies on the left eye's x axis: rectified by construction.
    T_left_world = np.linalg.inv(get_camera_pose(model, data, "left_eye"))
    right_in_left = T_left_world @ np.append(right, 1)
    assert_allclose(right_in_left[:3], [baseline, 0, 0], rtol=0, atol=1e-9)


def test_colors_are_rgb_in_memory() -> None:
    # Read as BGR this pure blue would be red, inside the range below.
    blue = np.zeros((20, 20, 3), np.uint8)
    blue[...] = (0, 0, 255)
    assert segment_by_color(blue, ((170, 100, 100), (10, 255, 255))).max() == 0
    assert segment_by_color(blue, ((115, 100, 100), (125, 255, 255))).min() == 255


def test_depth_pictures_are_bgr_blue_close_and_red_far() -> None:
    close, far = visualize_depth(np.array([[0.6, 4.9]]))[0]
    blue, _, red = 0, 1, 2
    assert close[blue] > close[red]
    assert far[red] > far[blue]
    assert (
        visualize_depth(np.array([[0.6]]))
        == cv2.applyColorMap(np.array([[30]], np.uint8), cv2.COLORMAP_TURBO)
    ).all()
