"""The answers of the concept questions up to step 3, computed; `check` in the data names one."""

from __future__ import annotations

import numpy as np
import pytest

import labutils as lab  # isort: skip - chooses the OpenGL backend, so before MuJoCo

from typing import Any

import cv2
import mujoco

from tests.helpers.quiz import HEAD, ITEMS, SIZE, get_numbers, make_view
from tests.helpers.tolerances import EXACT


@pytest.fixture(scope="module")
def view() -> dict[str, Any]:
    return make_view()


# ---- Background and conventions


def test_half_the_disparity_is_twice_the_depth() -> None:
    Z = 579 * 0.064 / np.array([20.0, 10.0])
    assert Z[1] / Z[0] == 2
    assert ITEMS["b1"].right_text == "Twice as far"


def test_a_falling_accelerometer_feels_nothing() -> None:
    model = mujoco.MjModel.from_xml_string("""<mujoco><worldbody>
        <body pos="0 0 1"><freejoint/><geom size=".1"/><site name="imu"/></body></worldbody>
        <sensor><accelerometer site="imu"/></sensor></mujoco>""")
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=50)
    assert data.qvel[2] < -0.5
    np.testing.assert_allclose(data.sensordata, 0, atol=1e-9)
    assert ITEMS["b2"].right_text == "0"


def test_rows_come_first_in_an_array() -> None:
    rgb = np.zeros((480, 640, 3), np.uint8)
    cv2.circle(rgb, (100, 200), 0, (9, 9, 9))  # OpenCV's points are (u, v)
    assert rgb[200, 100, 0] == 9
    assert ITEMS["b3"].right_text == "`rgb[200, 100]`"


def test_half_a_turn_about_x_between_the_two_camera_frames(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    _, data = scene
    camera = data.camera(HEAD)
    world = camera.xpos + camera.xmat.reshape(3, 3) @ [0, 0.1, -1]
    x, y, z = lab.world_to_camera(world[None], camera.xpos, camera.xmat)[0].round(6) + 0.0
    assert ITEMS["c1"].right_text == f"({x:g}, {y:g}, {z:g})"


def test_libraries_want_the_inverse_pose(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    K, _ = lab.get_camera_intrinsics(model, HEAD, 640, 480)
    world_point = data.body("red_box").xpos[None]
    camera = data.camera(HEAD)
    right = lab.points_to_pixels(lab.world_to_camera(world_point, camera.xpos, camera.xmat), K)
    extrinsic = np.linalg.inv(lab.get_camera_pose(model, data, HEAD))
    rvec, _ = cv2.Rodrigues(extrinsic[:3, :3])
    pixel = cv2.projectPoints(world_point, rvec, extrinsic[:3, 3], K, None)[0].reshape(1, 2)
    np.testing.assert_allclose(pixel, right, atol=1e-6)
    assert "inverse" in ITEMS["c2"].right_text


def test_hue_of_green_in_a_byte() -> None:
    green = np.array([[[0, 255, 0]]], np.uint8)
    half = cv2.cvtColor(green, cv2.COLOR_RGB2HSV)[0, 0, 0]
    full = cv2.cvtColor(green, cv2.COLOR_RGB2HSV_FULL)[0, 0, 0]
    assert get_numbers(ITEMS["c3"]) == [half, 120, full]


# ---- Step 1


def test_render_gives_rows_first_and_meters(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    with lab.make_renderer(model, height=240, width=320) as renderer:
        rgb, depth = lab.render_camera(model, data, renderer, HEAD)
    said = f"`{rgb.dtype}` {rgb.shape} and `{depth.dtype}` {depth.shape} in meters"
    assert ITEMS["1a"].right_text == said
    truth = lab.raycast_depth(model, data, HEAD, 320, 240)
    assert np.nanmedian(np.abs(depth - truth)) < 1e-4  # meters, neither 0 to 1 nor 0 to 255


def test_after_one_step_the_camera_shows_the_angle_of_before(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    data.joint("neck_pan").qpos = 0.2
    mujoco.mj_step(model, data)
    forward = lab.get_camera_pose(model, data, HEAD)[:3, 2]
    assert np.arctan2(forward[1], forward[0]) == pytest.approx(0.2, abs=1e-9)
    assert abs(data.joint("neck_pan").qpos[0] - 0.2) > 1e-5
    assert "0.2 rad of before" in ITEMS["1c"].right_text


def test_a_turn_to_the_left_moves_the_ball_to_the_middle(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    columns = {}
    with lab.make_renderer(model, *SIZE) as renderer:
        for pan in (-0.1, 0.0, 0.1):
            data.joint("neck_pan").qpos = pan
            seen = lab.render_segmentation(model, data, renderer, HEAD)
            columns[pan] = np.nonzero(seen == model.body("red_ball").id)[1].mean()
    assert columns[-0.1] < columns[0.0] < columns[0.1] < SIZE[1] / 2
    assert ITEMS["1d"].right_text.startswith("A positive one")


def test_only_data_knows_where_the_camera_is_now(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    mounted, before = model.camera(HEAD).pos.copy(), data.camera(HEAD).xpos.copy()
    data.joint("neck_tilt").qpos = 0.1
    mujoco.mj_forward(model, data)
    np.testing.assert_array_equal(model.camera(HEAD).pos, mounted)
    assert np.linalg.norm(data.camera(HEAD).xpos - before) > 1e-3
    assert "data.cam_xpos" in ITEMS["1e"].right_text


# ---- Step 2


def test_focal_length_of_a_right_angle() -> None:
    right = lab.intrinsics_matrix(np.deg2rad(90), 640, 480)[1, 1]
    wrong = [240 / np.tan(45), 320 / np.tan(np.deg2rad(45)), 480 / np.tan(np.deg2rad(45))]
    np.testing.assert_allclose(get_numbers(ITEMS["2a"]), [right, *wrong], atol=0.5)


def test_projection_of_one_point() -> None:
    K = np.array([[600.0, 0, 319.5], [0, 600.0, 239.5], [0, 0, 1]])
    (right,) = lab.points_to_pixels(np.array([[0.2, 0, 2]]), K)[:, 0]
    offset = right - 319.5
    wrong = [offset, 319.5 - offset, 319.5 + 600 * 0.2]
    np.testing.assert_allclose(get_numbers(ITEMS["2b"]), [right, *wrong], atol=EXACT)


def test_cost_of_half_a_pixel(view: dict[str, Any]) -> None:
    K = view["K"]
    assert round(K[0, 0]) == 579
    near = np.abs(view["depth"] - 1.1) < 0.01
    assert np.all(view["bodies"][near] > 0)
    assert np.mean(view["bodies"][near] == view["model"].body("table").id) > 0.5
    pixel, half = np.array([[100.0, 50.0]]), np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]])
    points = [lab.pixels_to_points(pixel, np.array([1.1]), matrix) for matrix in (K, K + half)]
    shift_mm = 1000 * np.abs(points[0] - points[1])[0]
    np.testing.assert_allclose(shift_mm, [0.95, 0.95, 0], atol=0.005)
    assert "about a millimeter" in ITEMS["2c"].right_text


def test_focal_length_from_a_data_sheet() -> None:
    model = mujoco.MjModel.from_xml_string("""<mujoco><worldbody>
        <camera name="sheet" sensorsize="0.0048 0.0036" focal="0.006 0.006" resolution="640 480"/>
        </worldbody></mujoco>""")
    right = lab.get_camera_intrinsics(model, "sheet", 640, 480)[0][0, 0]
    wrong = [4.8 / 6 * 640, 6 / 4.8, 6]
    np.testing.assert_allclose(get_numbers(ITEMS["2d"]), [right, *wrong], rtol=1e-6)


def test_a_round_trip_passes_with_a_wrong_matrix(view: dict[str, Any]) -> None:
    wrong = lab.intrinsics_matrix(np.deg2rad(50), 640, 480)
    assert 500 < wrong[0, 0] < 800
    pixels, depth = np.array([[20.0, 30.0], [600.0, 400.0]]), np.array([1.0, 2.0])
    there_and_back = lab.points_to_pixels(lab.pixels_to_points(pixels, depth, wrong), wrong)
    np.testing.assert_allclose(there_and_back, pixels, atol=1e-9)

    camera, body = view["data"].camera(HEAD), view["model"].body("red_ball").id
    center = lab.world_to_camera(view["data"].body("red_ball").xpos[None], camera.xpos, camera.xmat)
    seen = np.argwhere(view["bodies"] == body).mean(axis=0)[::-1]
    off_px = {
        name: np.linalg.norm(lab.points_to_pixels(center, K)[0] - seen)
        for name, K in {"right": view["K"], "wrong": wrong}.items()
    }
    assert off_px["right"] < 1
    assert off_px["wrong"] > 10
    assert ITEMS["2e"].right_text.startswith("Project a body")


# ---- Step 3


def test_the_middle_of_the_buffer_is_four_centimeters(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    near, far = lab.get_clip_planes(scene[0])
    assert (round(near, 6), round(far, 6)) == (0.02, 12)
    depth = lab.process_depth(np.full((1, 1), 0.5, np.float32), near, far)
    assert 100 * depth[0, 0] == pytest.approx(4, abs=0.05)
    assert near + 0.5 * (far - near) == pytest.approx(6, abs=0.05)
    assert ITEMS["3a"].right_text == "About 4 cm"


def test_the_gap_between_levels_grows_with_the_square(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    near, far = lab.get_clip_planes(scene[0])
    z = np.array([1.0, 10.0])
    window = np.float32(lab.metric_to_raw(z, near, far))
    slope = z**2 * (far - near) / (near * far)  # meters per unit of the buffer
    usual, reverse = (
        np.spacing(window) * slope,
        np.spacing(np.float32(1 - lab.metric_to_raw(z, near, far))) * slope,
    )
    assert usual[1] / usual[0] == pytest.approx(100)
    assert reverse[1] < usual[1] / 100  # what reversed order is for
    assert "100 times" in ITEMS["3b"].right_text


def test_depth_of_a_flat_wall_in_the_corner(view: dict[str, Any]) -> None:
    (ray,) = lab.pixels_to_points(np.array([[0, 0]]), np.ones(1), view["K"])
    factor = float(np.linalg.norm(ray))
    assert round(factor, 2) == 1.21
    np.testing.assert_allclose(get_numbers(ITEMS["3c"]), [2, 2 * factor, 2 / factor], atol=0.005)


def test_comparing_with_far_keeps_the_sky(view: dict[str, Any]) -> None:
    _, far = lab.get_clip_planes(view["model"])
    sky = view["depth"][view["bodies"] == -1]
    assert sky.size > 1000
    assert np.ptp(sky) == 0
    assert (sky < far).all()
    assert ITEMS["3d"].right_text == "None of them."


def test_the_sky_looks_like_a_surface_at_the_limit() -> None:
    depth = np.array([[12.0, 2.2, np.nan, 0.7]], np.float32)
    sky, limit, missing, close = lab.visualize_depth(depth, max_depth=2.2)[0].astype(int)
    np.testing.assert_array_equal(sky, limit)
    np.testing.assert_array_equal(missing, 0)
    assert limit[2] > 2 * limit[0]  # BGR: a dark red
    assert limit.max() < 160
    assert close[0] > close[2]
    assert "dark red" in ITEMS["3e"].right_text
