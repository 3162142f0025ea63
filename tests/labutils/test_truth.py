"""Rendered depth, labels and clouds against rays cast at the exact geometry."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose

from labutils import (
    camera_to_world,
    depth_to_pointcloud,
    find_valid_depth,
    get_camera_intrinsics,
    make_renderer,
    pixels_to_points,
    raycast_depth,
    raycast_points,
    render_camera,
    render_segmentation,
)
from labutils.raycast import RaycastRenderer
from tests.helpers.scenes import find_depth_edges, move_neck
from tests.helpers.tolerances import CLOUD_MEDIAN_MM, CLOUD_P99_MM, DEPTH_MEDIAN_MM

#: Odd and even sizes, wide and tall.
SIZES = ((640, 480), (321, 241), (160, 120), (97, 211), (255, 65))
CAMERAS = ("head_camera", "left_eye", "right_eye", "sensor_camera")


@pytest.mark.parametrize("seed", range(20))
def test_depth_and_cloud_agree_with_the_rays_from_random_poses(
    scene: tuple[mujoco.MjModel, mujoco.MjData], seed: int
) -> None:
    model, data = scene
    rng = np.random.default_rng(seed)
    move_neck(model, data, rng)
    camera = CAMERAS[seed % len(CAMERAS)]
    width, height = SIZES[seed % len(SIZES)]
    with make_renderer(model, height, width) as renderer:
        rgb, depth = render_camera(model, data, renderer, camera)
    truth = raycast_depth(model, data, camera, width, height)
    seen = find_valid_depth(depth) & np.isfinite(truth)
    assert seen.mean() > 0.2
    assert np.median(1000 * np.abs(depth - truth)[seen]) < DEPTH_MEDIAN_MM

    K, _ = get_camera_intrinsics(model, camera, width, height)
    cam_id = model.camera(camera).id
    points, colors = depth_to_pointcloud(depth, K, rgb)
    world = camera_to_world(points, data.cam_xpos[cam_id], data.cam_xmat[cam_id])
    valid = find_valid_depth(depth)
    hits = raycast_points(model, data, camera, width, height)[valid]
    error_mm = 1000 * np.linalg.norm(world - hits, axis=1)[~find_depth_edges(truth)[valid]]
    assert colors is not None
    assert len(colors) == len(points) == valid.sum()
    assert np.median(error_mm) < CLOUD_MEDIAN_MM
    assert np.percentile(error_mm, 99) < CLOUD_P99_MM


def test_window_pixels_see_nothing_and_read_the_far_plane(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 240, 320) as renderer:
        _, depth = render_camera(model, data, renderer, "head_camera")
        labels = render_segmentation(model, data, renderer, "head_camera")
    nothing = labels < 0
    assert 0.01 < nothing.mean() < 0.05
    # OpenGL's float32 depth cannot tell 12 m from 11.9999 m.
    assert_allclose(depth[nothing], 12.0, rtol=1e-4)
    assert np.isnan(raycast_depth(model, data, "head_camera", 320, 240)[nothing]).mean() > 0.99


def test_segmentation_labels_the_body_the_ray_hits(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 120, 160) as renderer:
        labels = render_segmentation(model, data, renderer, "head_camera")
    points = raycast_points(model, data, "head_camera", 160, 120)
    ball = model.body("red_ball")
    radius = model.geom_size[model.body_geomadr[ball.id], 0]
    from_center = np.linalg.norm(points - data.body("red_ball").xpos, axis=-1)
    on_ball = np.abs(from_center - radius) < 1e-6
    assert on_ball.sum() > 50
    # The outline of the drawn polygon may lose a pixel.
    assert (labels[on_ball] == ball.id).mean() > 0.95


def test_a_found_pixel_lands_on_the_objects_true_surface(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    width, height = 640, 480
    with make_renderer(model, height, width) as renderer:
        _, depth = render_camera(model, data, renderer, "head_camera")
        labels = render_segmentation(model, data, renderer, "head_camera")
    K, _ = get_camera_intrinsics(model, "head_camera", width, height)
    cam_id = model.camera("head_camera").id
    v, u = np.round(np.argwhere(labels == model.body("red_ball").id).mean(axis=0)).astype(int)
    point = pixels_to_points([[u, v]], [depth[v, u]], K)
    world = camera_to_world(point, data.cam_xpos[cam_id], data.cam_xmat[cam_id])[0]
    radius = model.geom_size[model.body_geomadr[model.body("red_ball").id], 0]
    distance = np.linalg.norm(world - data.body("red_ball").xpos)
    # A polygon of this ball lies at most 0.5 mm below its sphere.
    assert_allclose(distance, radius, rtol=0, atol=5e-4)


def test_ray_cast_depth_is_nan_where_nothing_is_hit_and_float32(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    depth = raycast_depth(model, data, "head_camera", 64, 48)
    assert depth.dtype == np.float32
    assert np.isnan(depth).any()
    assert np.isnan(raycast_points(model, data, "head_camera", 64, 48)[np.isnan(depth)]).all()


def test_ray_caster_sees_only_what_mujoco_draws(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    # Geoms of group 3 and up are not drawn by default, so rays must pass them too.
    model, data = scene
    before = raycast_depth(model, data, "head_camera", 64, 48)
    model.geom_group[model.body_geomadr[model.body("table").id]] = 3
    after = raycast_depth(model, data, "head_camera", 64, 48)
    with make_renderer(model, 48, 64) as renderer:
        _, drawn = render_camera(model, data, renderer, "head_camera")
    assert np.nanmax(after - before) > 0.1
    assert np.nanmedian(np.abs(after - drawn)) < 1e-4


def test_a_state_that_was_never_forwarded_is_refused(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, _ = scene
    with pytest.raises(ValueError, match="data: expected a forwarded state"):
        raycast_depth(model, mujoco.MjData(model), "head_camera", 8, 6)


def test_one_pixel_and_one_row_are_pictures_too(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    for width, height in ((1, 1), (7, 1), (1, 5)):
        renderer = RaycastRenderer(model, height, width)
        rgb, depth = render_camera(model, data, renderer, "head_camera")
        assert rgb.shape == (height, width, 3)
        assert depth.shape == (height, width)
