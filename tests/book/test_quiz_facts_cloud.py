"""The answers of the concept questions from step 4 on, computed; `check` in the data names one."""

from __future__ import annotations

import numpy as np
import pytest

import labutils as lab  # isort: skip - chooses the OpenGL backend, so before MuJoCo

from pathlib import Path
from typing import Any

import cv2
import mujoco

from labutils.figures import Picture
from tests.helpers.quiz import HEAD, ITEMS, SIZE, get_numbers, get_texts, make_view
from tests.helpers.tolerances import EXACT


@pytest.fixture(scope="module")
def view() -> dict[str, Any]:
    return make_view()


# ---- Step 4


def test_half_the_light_changes_value_only() -> None:
    rgb = np.array([[[200, 40, 20], [100, 20, 10]]], np.uint8)
    bright, dim = cv2.cvtColor(rgb, cv2.COLOR_RGB2HSV)[0].astype(int)
    np.testing.assert_allclose(bright[:2], dim[:2], atol=1)  # they are rounded to a byte
    assert bright[2] == 2 * dim[2]
    assert ITEMS["4a"].right_text == "Value only"


def test_only_the_wrapping_range_finds_both_reds(view: dict[str, Any]) -> None:
    names = ("red_ball", "red_box", "orange_cylinder")
    masks = {name: view["bodies"] == view["model"].body(name).id for name in names}
    expected = {0: {"red_ball"}, 1: {"orange_cylinder"}, 3: {"red_ball", "red_box"}}
    for place, choice in enumerate(ITEMS["4b"].choices):
        low, high = eval(choice.text.strip("`"), {"__builtins__": {}})  # noqa: S307 - our own text
        if place not in expected:
            with pytest.raises(ValueError, match=r"179|hue"):
                lab.segment_by_color(view["rgb"], (low, high))
            continue
        found = lab.segment_by_color(view["rgb"], (low, high)) > 0
        assert {name for name in names if found[masks[name]].mean() > 0.5} == expected[place]
        assert choice.right == (expected[place] == {"red_ball", "red_box"})


def test_opening_then_closing_cleans_speck_and_hole() -> None:
    whole = np.zeros((80, 80), np.uint8)
    whole[10:60, 10:60] = 255
    dirty = whole.copy()
    dirty[30:33, 30:33] = 0
    dirty[70:73, 70:73] = 255
    square = np.ones((5, 5), np.uint8)
    opened = cv2.morphologyEx(dirty, cv2.MORPH_OPEN, square)
    closed = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, square)
    np.testing.assert_array_equal(closed, whole)
    assert ITEMS["4c"].right_text == "The object without the hole, and no speck."


def test_the_centroid_of_the_largest_region() -> None:
    mask = np.zeros((100, 200), np.uint8)
    for x, reach in ((50, 15), (150, 5)):
        mask[50 - reach : 51 + reach, x - reach : x + reach + 1] = 255
    assert ITEMS["4d"].right_text == f"`{lab.find_object_centroid(mask)}`"
    mean = np.argwhere(mask).mean(axis=0)[::-1].astype(int)
    assert ITEMS["4d"].choices[0].text == f"`({mean[0]}, {mean[1]})`"


def test_the_camera_sees_the_skin_of_the_ball(view: dict[str, Any]) -> None:
    radius_mm = 1000 * view["model"].geom("red_ball").size[0]
    ball = (255 * (view["bodies"] == view["model"].body("red_ball").id)).astype(np.uint8)
    centroid = lab.find_object_centroid(ball)
    assert centroid is not None
    u, v = centroid
    point = lab.pixels_to_points(np.array([(u, v)]), np.array([view["depth"][v, u]]), view["K"])
    camera = view["data"].camera(HEAD)
    found = lab.camera_to_world(point, camera.xpos, camera.xmat)[0]
    off_mm = 1000 * np.linalg.norm(found - view["data"].body("red_ball").xpos)
    assert off_mm == pytest.approx(radius_mm, abs=1)
    assert ITEMS["4e"].right_text == f"About {radius_mm:.0f} mm"
    assert f"{radius_mm:.0f} mm" in ITEMS["4e"].question


# ---- Step 5


def test_one_pixel_becomes_a_point() -> None:
    K = np.array([[600.0, 0, 319.5], [0, 600.0, 239.5], [0, 0, 1]])
    right = lab.pixels_to_points(np.array([[319.5 + 150, 239.5]]), np.array([2.0]), K)[0, 0]
    wrong = [150 / 600, 150 * 2, 600 / 150 * 2]
    np.testing.assert_allclose(get_numbers(ITEMS["5a"]), [right, *wrong], atol=EXACT)


def test_colors_go_with_the_points_that_are_kept(view: dict[str, Any]) -> None:
    rgb, valid = view["rgb"], lab.find_valid_depth(view["depth"])
    points, colors = lab.depth_to_pointcloud(view["depth"], view["K"], rgb)
    assert colors is not None
    for choice in ITEMS["5b"].choices:
        offered = eval(  # noqa: S307 - our own text
            choice.text.strip("`"), {"__builtins__": {}}, {"rgb": rgb, "valid": valid}
        )
        fits = len(offered) == len(points) and np.allclose(offered, colors)
        assert fits == choice.right, choice.text


def test_a_point_straight_ahead_in_the_room() -> None:
    # MuJoCo's axes of a camera that looks along x: right is -y, up is z, backward is -x
    xmat = np.array([[0, -1, 0], [0, 0, 1], [-1, 0, 0]]).T
    position, point = np.array([0, 0, 1.5]), np.array([[0.0, 0, 1]])
    answers = [
        lab.camera_to_world(point, position, xmat)[0],
        (point + position)[0],
        (point @ xmat.T + position)[0],
        lab.camera_to_world(point, 0 * position, xmat)[0],
    ]
    assert get_texts(ITEMS["5c"]) == [
        f"({', '.join(f'{x:g}' for x in answer + 0.0)})" for answer in answers
    ]


def test_large_errors_lie_on_depth_edges(view: dict[str, Any]) -> None:
    depth, valid = view["depth"], lab.find_valid_depth(view["depth"])
    camera = view["data"].camera(HEAD)
    points, _ = lab.depth_to_pointcloud(depth, view["K"])
    world = lab.camera_to_world(points, camera.xpos, camera.xmat)
    truth = lab.raycast_points(view["model"], view["data"], HEAD, 640, 480)[valid]
    error_mm = 1000 * np.linalg.norm(world - truth, axis=1)
    window = np.ones((5, 5), np.uint8)
    edges = (cv2.dilate(depth, window) - cv2.erode(depth, window) > 0.02 * depth)[valid]
    assert np.nanmedian(error_mm) < 0.001
    assert 500 < np.nanmax(error_mm) < 2000
    assert edges[error_mm > 1].all()
    assert "depth edges" in ITEMS["5d"].right_text


def test_ray_length_for_depth_makes_bowls(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    near, far = lab.get_clip_planes(scene[0])
    K = lab.intrinsics_matrix(np.deg2rad(45), 640, 480)
    wall = np.full(SIZE, 2.0)
    half = np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]])
    points, _ = lab.depth_to_pointcloud(wall, K)
    rays = np.linalg.norm(points, axis=1).reshape(SIZE)
    other_planes = lab.process_depth(lab.metric_to_raw(wall, near, far), 0.01, 10)
    walls = [
        lab.depth_to_pointcloud(rays, K)[0],
        lab.depth_to_pointcloud(wall, K + half)[0],
        lab.depth_to_pointcloud(wall, lab.intrinsics_matrix(np.deg2rad(46), 640, 480))[0],
        lab.depth_to_pointcloud(other_planes, K)[0],
    ]
    is_flat = [np.ptp(cloud[:, 2]) < 1e-5 for cloud in walls]
    assert is_flat == [not choice.right for choice in ITEMS["5e"].choices]


# ---- Step 6


def test_without_a_screen_there_is_a_picture(
    view: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    points, colors = lab.depth_to_pointcloud(view["depth"], view["K"], view["rgb"])
    assert colors is not None
    picture = lab.visualize_pointcloud(points[::50], colors[::50])
    assert isinstance(picture, Picture)
    assert picture.png.startswith(b"\x89PNG")
    assert "picture" in ITEMS["6a"].right_text


def test_the_camera_frame_has_the_table_below(view: dict[str, Any]) -> None:
    points, _ = lab.depth_to_pointcloud(view["depth"], view["K"])
    bodies = view["bodies"][lab.find_valid_depth(view["depth"])]
    table, wall = (
        np.median(points[bodies == view["model"].body(name).id, 1]) for name in ("table", "wall")
    )
    assert table > wall  # y is larger below: with y up the table is on top
    assert "y points down" in ITEMS["6b"].right_text


def test_a_second_view_fills_part_of_the_shadow(view: dict[str, Any]) -> None:
    model, data = view["model"], view["data"]
    top = data.geom("table_top").xpos[2] + model.geom("table_top").size[2]
    seen = {}
    with lab.make_renderer(model, *SIZE) as renderer:
        for name in (HEAD, "overview"):
            _, depth = lab.render_camera(model, data, renderer, name)
            K, _ = lab.get_camera_intrinsics(model, name, 640, 480)
            camera = data.camera(name)
            cloud = lab.camera_to_world(
                lab.depth_to_pointcloud(depth, K)[0], camera.xpos, camera.xmat
            )
            squares = np.floor(cloud[np.abs(cloud[:, 2] - top) < 0.002, :2] / 0.01)
            seen[name] = set(map(tuple, squares.astype(int)))
    camera_xy, can_xy = data.camera(HEAD).xpos[:2], data.body("green_can").xpos[:2]
    away = (can_xy - camera_xy) / np.linalg.norm(can_xy - camera_xy)
    shadow = {tuple(np.floor((can_xy + s * away) / 0.01).astype(int)) for s in (0.06, 0.08, 0.1)}
    assert not shadow & seen[HEAD]
    assert shadow & seen["overview"]
    assert "second view" in ITEMS["6c"].right_text


def test_four_decimals_are_off_by_half_a_step(view: dict[str, Any], tmp_path: Path) -> None:
    points, _ = lab.depth_to_pointcloud(view["depth"], view["K"])
    back = np.loadtxt(lab.save_pointcloud_xyz(tmp_path, points))
    worst_mm = 1000 * np.abs(back - points).max()
    assert f"{worst_mm:.2f} mm" in ITEMS["6d"].right_text
