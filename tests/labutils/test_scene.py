"""What the chapters rely on in the scene: names, a steady pose, things to find."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cv2
import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose

from labutils import (
    HSV_RANGES,
    get_camera_intrinsics,
    get_clip_planes,
    is_gl_available,
    make_renderer,
    make_scene,
    render_camera,
    render_segmentation,
    segment_by_color,
)
from labutils.scene import SCENE_PATH

OBJECTS = {
    "red_box": "red",
    "red_ball": "red",
    "orange_cylinder": "orange",
    "green_can": "green",
    "yellow_block": "yellow",
    "blue_bottle": "blue",
    "purple_capsule": "purple",
    "cyan_mug": "cyan",
}


@pytest.fixture(scope="module")
def view() -> tuple[mujoco.MjModel, np.ndarray, np.ndarray]:
    """Color and labels of the head camera at home."""
    model, data = make_scene()
    with make_renderer(model, 480, 640) as renderer:
        rgb, _ = render_camera(model, data, renderer, "head_camera")
        labels = render_segmentation(model, data, renderer, "head_camera")
    return model, rgb, labels


def test_head_camera_has_the_focal_length_the_lab_expects(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    K, fov_y = get_camera_intrinsics(scene[0], "head_camera", 640, 480)
    assert 500 < K[0, 0] < 800
    assert_allclose(np.rad2deg(fov_y), 45, rtol=0, atol=1e-9)


def test_clip_planes_are_scaled_by_the_extent(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    # Without the factor they would read 0.01 and 6 m.
    assert get_clip_planes(scene[0]) == (0.02, 12.0)


@pytest.mark.parametrize("name", OBJECTS)
def test_every_object_is_in_the_picture(
    view: tuple[mujoco.MjModel, np.ndarray, np.ndarray], name: str
) -> None:
    model, _, labels = view
    assert (labels == model.body(name).id).sum() > 1500


@pytest.mark.parametrize("color", sorted(set(OBJECTS.values())))
def test_every_color_range_finds_its_objects_and_little_else(
    view: tuple[mujoco.MjModel, np.ndarray, np.ndarray], color: str
) -> None:
    model, rgb, labels = view
    mask = segment_by_color(rgb, HSV_RANGES[color]) > 0
    truth = np.isin(labels, [model.body(n).id for n, c in OBJECTS.items() if c == color])
    overlap = (mask & truth).sum() / (mask | truth).sum()
    # What is missing are outlines, where two colors mix, and what opening rounds off.
    assert overlap > 0.9


def test_the_two_reds_lie_on_both_sides_of_the_hue_seam(
    view: tuple[mujoco.MjModel, np.ndarray, np.ndarray],
) -> None:
    model, rgb, labels = view
    low = segment_by_color(rgb, ((0, 100, 50), (10, 255, 255))) > 0
    high = segment_by_color(rgb, ((170, 100, 50), (179, 255, 255))) > 0
    ball, box = (labels == model.body(name).id for name in ("red_ball", "red_box"))
    assert low[ball].mean() > 0.8
    assert high[ball].mean() < 0.1
    assert high[box].mean() > 0.8
    assert low[box].mean() < 0.1


@pytest.fixture(scope="module")
def shadow(view: tuple[mujoco.MjModel, np.ndarray, np.ndarray]) -> np.ndarray:
    """What the head camera sees in shadow on the table: there the light dims the picture."""
    if not is_gl_available():
        pytest.skip("the ray caster draws no shadows")
    model, rgb, labels = view
    _, data = make_scene()
    with mujoco.Renderer(model, 480, 640) as renderer:
        renderer.update_scene(data, camera="head_camera")
        renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = 0
        lit = renderer.render()
    gray_lit, gray = (cv2.cvtColor(p, cv2.COLOR_RGB2GRAY).astype(int) for p in (lit, rgb))
    return (gray_lit - gray > 50) & (labels == model.body("table").id)


def get_rim(labels: np.ndarray, body: Any) -> np.ndarray:
    """Return the pixels of a body and those up to three pixels beside it."""
    return cv2.dilate((labels == body.id).astype(np.uint8), np.ones((7, 7))) > 0


# The shadow of the bottle falls behind the block.
@pytest.mark.parametrize("name", sorted(OBJECTS.keys() - {"blue_bottle"}))
def test_every_object_darkens_the_table_right_beside_it(
    view: tuple[mujoco.MjModel, np.ndarray, np.ndarray], shadow: np.ndarray, name: str
) -> None:
    model, _, labels = view
    # An object without this dark seam seems to float.
    assert (get_rim(labels, model.body(name)) & shadow).sum() > 50


def test_the_edge_of_a_shadow_is_as_sharp_as_the_picture(
    view: tuple[mujoco.MjModel, np.ndarray, np.ndarray], shadow: np.ndarray
) -> None:
    model, _, labels = view
    _, parts = cv2.connectedComponents(shadow.astype(np.uint8))
    touching = np.bincount(parts[get_rim(labels, model.body("red_box")) & shadow])
    of_box = parts == touching.argmax()
    rows = np.flatnonzero(of_box.any(axis=1))
    right = np.array([np.flatnonzero(of_box[row]).max() for row in rows])
    # The right edge, from below its upper end to above the corner: straight, as the box's is.
    edge = slice(4, right.argmax() - 4)
    assert right[edge].size > 20
    line = np.polyval(np.polyfit(rows[edge], right[edge], 1), rows[edge])
    # A map half as fine gives steps of 1.4 pixels.
    assert np.abs(right[edge] - line).max() < 1


def test_the_shadow_map_is_small_and_spans_all_that_casts_a_shadow(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    # Without a graphics card, filling a map of 4096 took longer than drawing the picture.
    assert model.vis.quality.shadowsize <= 2048
    key = model.light("key")
    casting = np.flatnonzero(model.geom_castshadow)
    offsets = data.geom_xpos[casting] - data.light(key.id).xpos
    axis = data.light(key.id).xdir
    aside = np.linalg.norm(offsets - np.outer(offsets @ axis, axis), axis=1)
    # Whatever lies outside the map loses its shadow.
    assert aside.max() < model.vis.map.shadowclip * model.stat.extent


def test_the_robot_casts_a_shadow_from_head_to_sole(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, _ = scene
    for name in ("head", "chest", "left_sole", "right_sole"):
        assert model.geom(name).castshadow, name


def test_the_bottle_is_partly_hidden(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    bottle, block = model.body("blue_bottle").id, model.body("yellow_block")
    with make_renderer(model, 480, 640) as renderer:
        visible = (render_segmentation(model, data, renderer, "head_camera") == bottle).sum()
        model.body_pos[block.id] += (0, 0, -5)
        whole = (render_segmentation(model, data, renderer, "head_camera") == bottle).sum()
    assert 0.3 < 1 - visible / whole < 0.7


def test_the_pose_holds_itself_under_gravity(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    start = data.qpos.copy()
    for _ in range(int(2 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert np.rad2deg(np.abs(data.qpos - start)).max() < 0.5


def test_the_neck_goes_where_its_actuators_are_told(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    for name, target in (("neck_pan", 0.3), ("neck_tilt", 0.2)):
        data.actuator(name).ctrl = target
    for _ in range(int(2 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert_allclose(data.joint("neck_pan").qpos[0], 0.3, rtol=0, atol=0.01)
    assert_allclose(data.joint("neck_tilt").qpos[0], 0.2, rtol=0, atol=0.01)


def test_positive_tilt_looks_down(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    camera = model.camera("head_camera").id
    before = data.cam_xmat[camera].reshape(3, 3)[2, 2]
    data.joint("neck_tilt").qpos += 0.1
    mujoco.mj_forward(model, data)
    # MuJoCo's camera z axis points backwards: it rises as the camera looks down.
    assert data.cam_xmat[camera].reshape(3, 3)[2, 2] > before


def test_the_imu_at_rest_reads_gravity_and_no_rotation(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    for _ in range(500):
        mujoco.mj_step(model, data)
    force = data.sensor("accelerometer").data
    assert_allclose(np.linalg.norm(force), 9.81, rtol=0, atol=0.02)
    assert_allclose(data.sensor("gyro").data, 0, rtol=0, atol=0.01)
    # Upward in the world, whichever way the head is turned: specific force, not gravity.
    up = data.site("imu").xmat.reshape(3, 3) @ force
    assert_allclose(up, [0, 0, 9.81], rtol=0, atol=0.05)


def test_an_unknown_keyframe_is_named_with_the_known_ones() -> None:
    with pytest.raises(ValueError, match=r"keyframe: expected one of home.*, got 'sleep'"):
        make_scene("sleep")


def test_a_missing_scene_file_says_where_it_should_be(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("labutils.scene.SCENE_PATH", tmp_path / SCENE_PATH.name)
    with pytest.raises(FileNotFoundError, match="in the folder assets/ beside labutils/"):
        make_scene()
