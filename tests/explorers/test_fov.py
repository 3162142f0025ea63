"""The field-of-view explorer agrees with the camera it stands for."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from labutils import (
    get_camera_intrinsics,
    intrinsics_matrix,
    make_renderer,
    make_scene,
    points_to_pixels,
    render_camera,
    render_segmentation,
    world_to_camera,
)
from labutils.explorers import explore_fov
from labutils.explorers.fov import MAX_FOV_DEG, FovExplorer, _render_wide
from tests.helpers.node import evaluate
from tests.helpers.tolerances import EXACT

OBJECTS = ("red_box", "blue_bottle", "cyan_mug", "red_ball")


@pytest.fixture(scope="module")
def explorer() -> FovExplorer:
    return explore_fov(*make_scene(), objects=OBJECTS)


def test_it_starts_at_the_angle_of_the_camera(
    explorer: FovExplorer, scene: tuple[mujoco.MjModel, mujoco.MjData]
) -> None:
    K, fov_y = get_camera_intrinsics(scene[0], "head_camera", 640, 480)
    assert explorer.fov_y == pytest.approx(fov_y, abs=EXACT)
    np.testing.assert_allclose(explorer.K, K, rtol=EXACT)


def test_values_follow_angle_and_size(explorer: FovExplorer) -> None:
    explorer.move(fov_y_deg=60.0, size=2)
    try:
        assert explorer.picture_size == (1280, 960)
        np.testing.assert_allclose(explorer.K, intrinsics_matrix(np.radians(60), 1280, 960))
        assert explorer.values["f"] == pytest.approx(480 / np.tan(np.radians(30)))
    finally:
        explorer.move(**explorer.view.start)


@pytest.mark.parametrize("fov", [10.0, 30.0, 45.0, 88.5, 100.0])
@pytest.mark.parametrize("size", [0, 1, 2])
def test_the_page_computes_the_same_camera(explorer: FovExplorer, fov: float, size: int) -> None:
    explorer.move(fov_y_deg=fov, size=size)
    expected = explorer.values
    sizes = explorer.view.sizes
    explorer.move(**explorer.view.start)
    found = evaluate(
        "_camera",
        "{K: m.intrinsicsMatrix(fov, w, h), fov_x_deg: m.fovFromFocal(m.focalFromFov(fov, h), w)}",
        fov=fov,
        w=sizes[size][0],
        h=sizes[size][1],
    )
    np.testing.assert_allclose(found["K"], expected["K"], rtol=EXACT)
    assert found["fov_x_deg"] == pytest.approx(expected["fov_x_deg"], rel=EXACT)


def test_a_narrow_view_is_exactly_the_middle_of_the_wide_one(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    # With 100 and 61.6 degrees the middle half of the wide picture is the whole narrow one,
    # pixel for pixel; what differs is the smoothing of edges.
    model, data = scene
    wide, _ = _render_wide(model, data, "head_camera")
    half = np.degrees(2 * np.arctan(np.tan(np.radians(MAX_FOV_DEG / 2)) / 2))
    model.cam("head_camera").fovy[:] = half
    renderer = make_renderer(model, 480, 640)
    narrow, _ = render_camera(model, data, renderer, "head_camera")
    renderer.close()
    crop = wide[240:720, 320:960]
    difference = np.abs(crop.astype(int) - narrow).max(axis=2)
    # one pixel off, every edge of the scene would differ: 8 % of the pixels
    assert (difference > 24).mean() < 0.002


@pytest.mark.parametrize("fov", [20.0, 33.0, 45.0])
def test_objects_inside_are_those_whose_center_falls_on_a_column(
    explorer: FovExplorer, scene: tuple[mujoco.MjModel, mujoco.MjData], fov: float
) -> None:
    _, data = scene
    camera = data.cam("head_camera")
    explorer.move(fov_y_deg=fov)
    for name in OBJECTS:
        point = world_to_camera(data.body(name).xpos[None], camera.xpos, camera.xmat)
        u = points_to_pixels(point, explorer.K)[0, 0]
        inside = -0.5 <= u <= 639.5
        assert (name.replace("_", " ") in explorer.values["seen"]) == inside, name
    explorer.move(**explorer.view.start)
    assert explorer.values["seen"] == ["red ball", "red box", "blue bottle", "cyan mug"]


def test_all_objects_are_whole_down_to_the_angle_that_leaves_nothing_to_spare(
    explorer: FovExplorer, scene: tuple[mujoco.MjModel, mujoco.MjData]
) -> None:
    # rendered at that angle, some object reaches into the last pixels of the rim, and none beyond
    model, data = scene
    smallest = explorer.view.fov_y_deg - explorer.values["spare_deg"]
    ids = [model.body(name).id for name in OBJECTS]
    model.cam("head_camera").fovy[:] = smallest
    renderer = make_renderer(model, 480, 640)
    bodies = render_segmentation(model, data, renderer, "head_camera")
    renderer.close()
    seen = np.isin(bodies, ids)
    rim = np.ones_like(seen)
    rim[3:-3, 3:-3] = False
    assert (seen & rim).any()
    rim[1:-1, 1:-1] = False
    assert (seen & rim).sum() < 40  # the wide picture is coarser by half a pixel


def test_the_goal_is_the_smallest_angle_with_all_objects(explorer: FovExplorer) -> None:
    smallest = explorer.view.fov_y_deg - explorer.values["spare_deg"]
    reached = {}
    for spare in (-0.5, 0.5, 1.5):
        explorer.move(fov_y_deg=smallest + spare)
        reached[spare] = explorer.goal_is_reached
    explorer.move(**explorer.view.start)
    assert reached == {-0.5: False, 0.5: True, 1.5: False}


def test_without_objects_there_is_no_goal() -> None:
    explorer = explore_fov(*make_scene())
    assert explorer.values["spare_deg"] is None
    assert explorer.goal is None


def test_the_scene_keeps_its_own_angle(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    before = model.cam_fovy.copy()
    explore_fov(model, data)
    np.testing.assert_array_equal(model.cam_fovy, before)


def test_the_poster_shows_the_camera_picture(
    explorer: FovExplorer, scene: tuple[mujoco.MjModel, mujoco.MjData]
) -> None:
    model, data = scene
    renderer = make_renderer(model, 480, 640)
    rgb, _ = render_camera(model, data, renderer, "head_camera")
    renderer.close()
    poster = explorer.view.draw_poster()
    assert poster.shape == rgb.shape
    # the crop is stretched by 1.04 from the wide picture: edges blur, areas agree
    assert np.abs(poster.astype(int) - rgb).mean() < 6


def test_an_unknown_camera_or_body_is_named(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    with pytest.raises(ValueError, match="nose_camera"):
        explore_fov(*scene, "nose_camera")
    with pytest.raises(KeyError, match="green_cow"):
        explore_fov(*scene, objects=("green_cow",))


def test_a_camera_wider_than_the_slider_is_refused(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    model.cam("head_camera").fovy[:] = 120
    with pytest.raises(ValueError, match="expected a field of view of 10 to 100 degrees, got 120"):
        explore_fov(model, data)
