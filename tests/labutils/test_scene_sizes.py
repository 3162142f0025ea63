"""Clouds of scenes of any size: what a surface is follows the model's clip planes."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import (
    MAX_DEPTH,
    camera_to_world,
    depth_to_pointcloud,
    find_valid_depth,
    get_camera_intrinsics,
    get_clip_planes,
    get_depth_limits,
    make_renderer,
    raycast_depth,
    raycast_points,
    render_camera,
)
from labutils.raycast import RaycastRenderer
from labutils.renderers.protocol import Renderer
from tests.helpers.scenes import find_depth_edges

WIDTH, HEIGHT = 161, 120

#: A plate and a tilted box under an open sky, everything a multiple of the size: flat faces alone,
#: because OpenGL draws round ones as polygons.
SCENE = """
<mujoco>
  <statistic extent="{0}" center="0 0 0"/>
  <worldbody>
    <geom type="box" size=".3 .3 .02" pos="0 0 -.1"/>
    <geom type="box" size=".05 .08 .06" pos=".05 .05 0" euler="20 30 40"/>
    <camera name="eye" pos="-.9 -.1 .4" xyaxes=".1 -1 0 .35 .035 .9" sensorsize=".006 .004"
            focal=".005 .006" principal=".0006 .0005" resolution="640 480"/>
  </worldbody>
</mujoco>
"""

#: Near and far plane in sizes of the scene; the first pair is that of a model which gives none.
PLANES = ((0.01, 50.0), (0.1, 10.0), (0.001, 50.0), (0.01, 5000.0), (0.0001, 1000.0))


def make_scaled_scene(size: float) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Compile and forward the scene at a size in meters."""
    spec = mujoco.MjSpec.from_string(SCENE.format(size))
    for thing in (*spec.geoms, *spec.cameras):
        thing.pos = size * np.array(thing.pos)
    for geom in spec.geoms:
        geom.size = size * np.array(geom.size)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


@pytest.mark.parametrize("size", [0.004, 0.04, 1.0, 100.0, 10_000.0])
def test_a_scene_of_any_size_gives_the_cloud_of_its_surfaces(size: float) -> None:
    model, data = make_scaled_scene(size)
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        _, depth = render_camera(model, data, renderer, "eye")
    truth = raycast_depth(model, data, "eye", WIDTH, HEIGHT)
    inner = ~find_depth_edges(truth / size)  # where OpenGL's samples all see what the ray sees
    min_depth, max_depth = get_depth_limits(model)
    valid = find_valid_depth(depth, min_depth, max_depth)
    assert 0.2 < np.isfinite(truth[inner]).mean() < 0.5
    assert_array_equal(valid[inner], np.isfinite(truth[inner]))

    K, _ = get_camera_intrinsics(model, "eye", WIDTH, HEIGHT)
    points, _ = depth_to_pointcloud(depth, K, min_depth=min_depth, max_depth=max_depth)
    assert len(points) == valid.sum()
    camera = data.camera("eye")
    world = camera_to_world(points, camera.xpos, camera.xmat)
    hits = raycast_points(model, data, "eye", WIDTH, HEIGHT)
    # Ten roundings of float32: of OpenGL's transformations, its depth, the cloud and the frames.
    assert_allclose(world[inner[valid]], hits[valid & inner], rtol=0, atol=10 * 2.0**-23 * size)


@pytest.mark.parametrize(("size", "missed"), [(0.04, "sky"), (100.0, "surface")])
def test_the_rooms_limits_are_wrong_for_a_much_smaller_or_larger_scene(
    size: float, missed: str
) -> None:
    # Which is why there are others to give: all sky of the small scene lies before 10 m, and all
    # surfaces of the large one lie behind.
    model, data = make_scaled_scene(size)
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        _, depth = render_camera(model, data, renderer, "eye")
    K, _ = get_camera_intrinsics(model, "eye", WIDTH, HEIGHT)
    points, _ = depth_to_pointcloud(depth, K)
    assert len(points) == (depth.size if missed == "sky" else 0)
    assert (get_clip_planes(model)[1] < MAX_DEPTH) == (missed == "sky")


@pytest.mark.parametrize("kind", [make_renderer, RaycastRenderer])
def test_sky_is_no_surface_on_whichever_side_of_the_far_plane_it_reads(
    kind: Callable[..., Renderer],
) -> None:
    wrong_by = []
    for size, planes in itertools.product((0.04, 0.1, 4.0), PLANES):
        model, data = make_scaled_scene(size)
        model.vis.map.znear, model.vis.map.zfar = planes
        data.cam_xmat[0] = np.diag([1, -1, -1]).ravel()  # upwards
        renderer = kind(model, 4, 5)
        renderer.update_scene(data, camera="eye")
        renderer.enable_depth_rendering()
        depth = renderer.render()
        renderer.close()
        wrong_by.append(depth.max() / get_clip_planes(model)[1] - 1)
        assert not find_valid_depth(depth, *get_depth_limits(model)).any()
    if kind is make_renderer:
        # A rounding of float32 times far / near: 10 % and more where that is ten millions.
        assert min(wrong_by) < -0.1
        assert max(wrong_by) > 0.1


def test_limits_leave_out_little_of_what_lies_before_the_far_plane() -> None:
    model, _ = make_scaled_scene(1.0)
    assert get_clip_planes(model) == (0.01, 50.0)
    assert_allclose(get_depth_limits(model), (0.01, 0.999 * 50), rtol=1e-12)
    # 50,000 times as far: 0.6 %, against the 0.13 and 0.16 % that sky was seen to be wrong by.
    model.vis.map.znear = 0.001
    assert_allclose(get_depth_limits(model), (0.001, 50 / 1.00596), rtol=1e-6)


def test_the_limits_of_the_books_scene_keep_all_its_surfaces(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 120, 160) as renderer:
        _, depth = render_camera(model, data, renderer, "head_camera")
    assert_array_equal(find_valid_depth(depth, *get_depth_limits(model)), find_valid_depth(depth))
