"""The point cloud explorer: what it computes, what it refuses, how it starts."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
import pytest
import traitlets

from labutils import (
    depth_to_pointcloud,
    get_camera_intrinsics,
    intrinsics_matrix,
    make_renderer,
    make_scene,
    raycast_points,
    render_camera,
)
from labutils._splat import make_look_at
from labutils.camera_utils import get_camera_pose
from labutils.explorers import explore_cloud
from labutils.explorers._base import DEPTH_STEP
from labutils.explorers._cloud_poster import make_view_transform
from labutils.explorers.cloud import CloudExplorer
from tests.helpers.tolerances import CLOUD_MEDIAN_MM, EXACT

#: Color, depth, intrinsics, field of view and pose of the head camera.
Frame = tuple[np.ndarray, np.ndarray, np.ndarray, float, np.ndarray]

SIZE = (640, 480)
FACES = {
    "table": [(60, 440), (590, 440), (330, 215)],
    "wall": [(60, 40), (580, 40), (450, 170)],
}
#: Pixels of flat things (table, wall, boxes), away from edges: drawn exactly where they are.
FLAT_PIXELS = [(20, 300), (600, 440), (330, 215), (30, 100), (450, 170), (150, 365), (280, 280)]
#: Behind the window there is nothing.
WINDOW_PIXEL = (250, 20)


@pytest.fixture(scope="module")
def frame() -> Frame:
    model, data = make_scene()
    with make_renderer(model, SIZE[1], SIZE[0]) as renderer:
        rgb, depth = render_camera(model, data, renderer, "head_camera")
    K, fov_y = get_camera_intrinsics(model, "head_camera", *SIZE)
    return rgb, depth, K, fov_y, get_camera_pose(model, data, "head_camera")


@pytest.fixture
def explorer(frame: Frame) -> CloudExplorer:
    rgb, depth, K, _, T_world_cam = frame
    return explore_cloud(rgb, depth, K, T_world_cam, faces=FACES)


def make_small(**changes: Any) -> CloudExplorer:
    """Arguments of a small flat cloud, some of them changed."""
    arguments: dict[str, Any] = {
        "rgb": np.full((6, 8, 3), 90, np.uint8),
        "depth": np.full((6, 8), 2.0, np.float32),
        "K": np.array([[9.0, 0, 3.25], [0, 7.0, 2.5], [0, 0, 1]]),
    }
    return explore_cloud(**{**arguments, **changes})


def test_it_starts_with_every_point_that_the_library_keeps(
    explorer: CloudExplorer, frame: Frame
) -> None:
    _, depth, K, fov_y, _ = frame
    points, _ = depth_to_pointcloud(depth, K)
    assert explorer.values["points"] == len(points)
    assert explorer.fov_y == pytest.approx(fov_y, abs=EXACT)
    np.testing.assert_allclose(explorer.K, K, rtol=0, atol=1e-9)
    assert explorer.values["stretch"] == 1.0
    assert explorer.pixel is None
    assert explorer.point is None


@pytest.mark.parametrize("pixel", FLAT_PIXELS)
def test_a_picked_point_is_the_true_point(
    explorer: CloudExplorer,
    frame: Frame,
    scene: tuple[mujoco.MjModel, mujoco.MjData],
    pixel: tuple[int, int],
) -> None:
    explorer.move(pixel=list(pixel))
    u, v = pixel
    truth = raycast_points(*scene, "head_camera", *SIZE)[v, u]
    K = frame[2]
    ray = np.linalg.norm([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], 1])
    # depth is rounded to half a step, and moves the point along its ray
    limit = DEPTH_STEP / 2 * ray + CLOUD_MEDIAN_MM / 1000
    assert explorer.point is not None
    assert np.linalg.norm(explorer.point - truth) < limit
    assert explorer.pixel == pixel
    camera = np.linalg.inv(frame[4]) @ [*explorer.point, 1]
    np.testing.assert_allclose(explorer.values["point_camera"], camera[:3], rtol=0, atol=EXACT)


def test_without_a_pose_the_point_is_in_the_camera_frame(
    frame: Frame,
) -> None:
    rgb, depth, K, _, _ = frame
    explorer = explore_cloud(rgb, depth, K, pixel=(330, 215))
    assert explorer.values["point_world"] is None
    assert explorer.point is not None
    assert explorer.point[2] == pytest.approx(depth[215, 330], abs=DEPTH_STEP / 2)
    assert explorer.values["angle_deg"] is None


def test_where_nothing_is_seen_there_is_no_point(explorer: CloudExplorer) -> None:
    explorer.move(pixel=list(WINDOW_PIXEL))
    assert explorer.pixel == WINDOW_PIXEL
    assert explorer.point is None
    assert explorer.values["point_camera"] is None


def test_a_point_beyond_the_far_limit_is_gone(explorer: CloudExplorer) -> None:
    u, v = FLAT_PIXELS[4]
    explorer.move(pixel=[u, v])
    depth = explorer.values["point_camera"][2]
    explorer.move(far=depth + 0.001)
    assert explorer.point is not None
    explorer.move(far=depth - 0.001)
    assert explorer.point is None
    assert explorer.far == depth - 0.001  # type: ignore[unreachable]  # the move takes the point away


def test_the_far_limit_counts_as_the_library_does(explorer: CloudExplorer, frame: Frame) -> None:
    far = 1.25
    explorer.move(far=far)
    depth = frame[1]
    # a reading within half a step of the limit may fall on either side
    low, high = (np.count_nonzero(depth < far + shift) for shift in (-DEPTH_STEP, DEPTH_STEP))
    assert low <= explorer.values["points"] <= high
    assert low > 0


def test_table_and_wall_meet_at_a_right_angle_only_with_the_true_field_of_view(
    explorer: CloudExplorer,
) -> None:
    # Depth is off by 0.1 mm at most, over faces 0.4 m wide: 0.03 degrees each.
    assert explorer.values["angle_deg"] == pytest.approx(90.0, abs=0.06)
    angles = []
    for fov_y_deg in (30, 40, 44, 46, 50, 60):
        explorer.move(fov_y_deg=fov_y_deg)
        angles.append(explorer.values["angle_deg"])
    assert angles == sorted(angles)
    assert angles[2] < 89.5
    assert angles[3] > 90.5


def test_a_wrong_field_of_view_stretches_x_and_y_only(explorer: CloudExplorer) -> None:
    explorer.move(pixel=list(FLAT_PIXELS[1]))
    x, y, z = explorer.values["point_camera"]
    explorer.move(fov_y_deg=60)
    values = explorer.values
    assert values["stretch"] == pytest.approx(np.tan(np.pi / 6) / np.tan(np.pi / 8), abs=EXACT)
    stretched = [x * values["stretch"], y * values["stretch"], z]
    np.testing.assert_allclose(values["point_camera"], stretched, rtol=0, atol=EXACT)
    np.testing.assert_allclose(explorer.K, intrinsics_matrix(np.pi / 3, *SIZE), atol=1e-9)


def test_an_uneven_camera_keeps_its_shape_and_its_principal_point(K: np.ndarray) -> None:
    depth = np.full((40, 60), 1.5, np.float32)
    explorer = make_small(rgb=np.zeros((40, 60, 3), np.uint8), depth=depth, K=K)
    np.testing.assert_allclose(explorer.K, K, rtol=0, atol=EXACT)
    explorer.move(fov_y_deg=2 * np.degrees(np.arctan(20 / 90)))  # half of fy = 180
    expected = np.array([[105, 0, 33.25], [0, 90, 20.5], [0, 0, 1]])
    np.testing.assert_allclose(explorer.K, expected, atol=1e-9)


def test_the_sliders_hold_the_start_and_reset_brings_it_back(explorer: CloudExplorer) -> None:
    for name, low_name, high_name in (("fov_y_deg", "min", "max"), ("far", "min", "max")):
        slider = explorer.controls[name].widget
        low, high = getattr(slider, low_name), getattr(slider, high_name)
        assert low < high
        assert low <= explorer.view.start[name] <= high
    assert set(explorer.view.start) == set(explorer.view.PARAMETERS)
    assert explorer.view.start["pixel"] == []


@pytest.mark.parametrize("depth", [0.02, 2.0, 9.99])
def test_a_flat_wall_at_any_depth_has_limits(depth: float) -> None:
    explorer = make_small(depth=np.full((6, 8), depth))
    assert explorer.values["points"] == 48
    slider = explorer.controls["far"].widget
    assert slider.min < slider.max
    assert slider.max <= 10.0
    for low, high in (explorer.view.depth_limits, explorer.view.height_limits):
        assert low < high


def test_height_grows_upward_in_both_frames(explorer: CloudExplorer, frame: Frame) -> None:
    rgb, depth, K, _, _ = frame
    low, high = explorer.view.height_limits
    assert low < 0.86 < high  # the table top
    low, high = explore_cloud(rgb, depth, K).view.height_limits
    assert low < 0 < high  # below and above the camera's axis


def test_the_poster_shows_the_cloud_on_paper(explorer: CloudExplorer, frame: Frame) -> None:
    poster = explorer.view.draw_poster()
    assert poster.shape == (480, 640, 3)
    assert poster.dtype == np.uint8
    drawn = (poster != [253, 252, 250]).any(axis=2)
    assert 0.1 < drawn.mean() < 0.9
    # every drawn pixel is the color of a pixel of the camera
    colors = {tuple(color) for color in frame[0].reshape(-1, 3)}
    assert {tuple(color) for color in poster[drawn]} <= colors
    explorer.move(orbit={**explorer.view.orbit, "distance": 9.0})
    np.testing.assert_array_equal(explorer.view.draw_poster(), poster)


def test_the_reader_stands_where_the_orbit_says() -> None:
    rng = np.random.default_rng(0)
    for _ in range(50):
        azimuth_deg, elevation_deg = rng.uniform(-180, 180), rng.uniform(-89, 89)
        target, distance = rng.normal(size=3), rng.uniform(0.1, 5)
        orbit = {
            "azimuth_deg": azimuth_deg,
            "elevation_deg": elevation_deg,
            "distance": distance,
            "target": target.tolist(),
        }
        azimuth, elevation = np.radians([azimuth_deg, elevation_deg])
        offset = [
            np.sin(azimuth) * np.cos(elevation),
            -np.sin(elevation),
            -np.cos(azimuth) * np.cos(elevation),
        ]
        eye = target + distance * np.array(offset)
        expected = make_look_at(eye, target, np.array([0.0, -1.0, 0.0]))
        np.testing.assert_allclose(make_view_transform(orbit), expected, rtol=0, atol=1e-9)


def test_it_says_its_values_in_words(explorer: CloudExplorer) -> None:
    assert repr(explorer) == (
        f"Point cloud: {explorer.values['points']} points, f = 579.4 px, "
        "1.00 times as wide as it should be, faces meet at 90.0°"
    )


@pytest.mark.parametrize(
    ("changes", "kind", "message"),
    [
        ({"rgb": np.zeros((5, 8, 3), np.uint8)}, ValueError, "rgb_image: expected the depth"),
        ({"rgb": np.zeros((6, 8, 3))}, TypeError, "rgb_image: expected a uint8 image"),
        ({"depth": np.full(6, 1.0)}, ValueError, "depth_metric: expected a depth image"),
        ({"depth": np.zeros((6, 8))}, ValueError, "depth: expected a reading from 0.01 to 10"),
        ({"K": np.eye(2)}, ValueError, "K: expected a 3x3 matrix"),
        ({"K": np.diag([1e-2, 1e-2, 1.0])}, ValueError, "K: expected a field of view of 1 to 150"),
        ({"T_world_cam": np.eye(3)}, ValueError, "T_world_cam: expected a 4x4 matrix"),
        ({"T_world_cam": 2 * np.eye(4)}, ValueError, "last row 0, 0, 0, 1"),
        ({"T_world_cam": np.diag([2.0, 1, 1, 1])}, ValueError, "expected a rotation matrix"),
        ({"pixel": (8, 0)}, ValueError, r"pixel: expected \(u, v\) within 8 x 6 pixels"),
        ({"pixel": (0, -1)}, ValueError, r"pixel: expected \(u, v\) within 8 x 6 .* \(0, -1\)"),
        ({"pixel": (0, 1, 2)}, ValueError, r"pixel: expected \(u, v\) within 8 x 6 pixels"),
        ({"pixel": (0.5, 1)}, TypeError, r"pixel: expected \(u, v\), two whole numbers"),
        ({"faces": {"wall": [(0, 0), (1, 0), (0, 1)]}}, ValueError, "faces: expected two names"),
        ({"fov_y": 3.0}, ValueError, "fov_y: expected 23 to 93 degrees in radians, got 171.887"),
        ({"fov_y": "wide"}, TypeError, "fov_y: expected a number, got str 'wide'"),
        (
            {"faces": {"a": [(0, 0), (1, 0), (0, 1)], "b": [(0, 0), (1, 1), (8, 3)]}},
            ValueError,
            r"faces: 'b': expected \(u, v\) within 8 x 6 pixels, got tuple \(8, 3\)",
        ),
        (
            {"faces": {"a": [(0, 0), (1, 0), (0, 1)], "b": [(0, 0), (1, 1)]}},
            ValueError,
            "faces: expected two names with three pixels each, got {'a': 3, 'b': 2}",
        ),
        (
            {"faces": {"a": [(0, 0), (1, 0), (0, 1)], "b": [(0, 0), (1, 1), (3, 3)]}},
            ValueError,
            "faces: expected three pixels of 'b' not on a line",
        ),
        (
            {
                "depth": np.where(np.eye(6, 8) > 0, 12.0, 2.0),
                "faces": {"a": [(0, 1), (1, 0), (3, 2)], "b": [(0, 0), (1, 0), (0, 1)]},
            },
            ValueError,
            r"faces: expected a surface at \(0, 0\) of 'b', got none",
        ),
    ],
)
def test_what_cannot_be_shown_is_refused(
    changes: dict[str, Any], kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        make_small(**changes)


def test_a_pixel_outside_cannot_be_picked(explorer: CloudExplorer) -> None:
    with pytest.raises(traitlets.TraitError, match=r"pixel: expected \(u, v\) within 640 x 480"):
        explorer.move(pixel=[640, 0])
    assert explorer.pixel is None


def test_it_can_begin_with_a_wrong_field_of_view(frame: Frame) -> None:
    rgb, depth, K, _, T_world_cam = frame
    arguments = (rgb, depth, K, T_world_cam)
    bent = explore_cloud(*arguments, faces=FACES, fov_y=np.radians(55))
    assert bent.view.start["fov_y_deg"] == bent.view.fov_y_deg == 55
    assert bent.fov_y == pytest.approx(np.radians(55))
    poster = bent.view.draw_poster()
    bent.move(fov_y_deg=45.0)
    assert bent.values["angle_deg"] == pytest.approx(90, abs=0.1)
    # the poster stays what the view shows first
    np.testing.assert_array_equal(bent.view.draw_poster(), poster)
    assert (poster != explore_cloud(*arguments, faces=FACES).view.draw_poster()).any()


def test_the_goal_of_a_bent_cloud_is_the_right_angle(frame: Frame) -> None:
    rgb, depth, K, _, T_world_cam = frame
    bent = explore_cloud(rgb, depth, K, T_world_cam, faces=FACES, fov_y=np.radians(55))
    assert bent.goal is not None
    assert bent.goal.text == "Make table and wall meet at a right angle again."
    reached = []
    for fov_y_deg in np.arange(40, 50, 0.5):  # the steps of its slider
        bent.move(fov_y_deg=float(fov_y_deg))
        if bent.goal_is_reached:
            reached.append(float(fov_y_deg))
    assert reached == [45.0]
    assert explore_cloud(rgb, depth, K, T_world_cam, faces=FACES).goal is None
