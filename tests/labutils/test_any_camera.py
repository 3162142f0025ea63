"""Cameras by name, by number, without a name, and those of a viewer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import (
    get_camera_intrinsics,
    get_camera_pose,
    is_gl_available,
    make_renderer,
    raycast_depth,
    raycast_points,
    render_camera,
    render_segmentation,
)
from labutils.cameras import get_camera_id
from labutils.renderers.rays import RaycastRenderer
from tests.helpers.tolerances import EXACT

pytestmark = pytest.mark.filterwarnings("ignore::labutils.NoOpenGLWarning")

HEIGHT, WIDTH = 48, 64

MODEL = """
<mujoco>
  <statistic center="0 0 .5" extent="3"/>
  <visual><global fovy="55" azimuth="70" elevation="-25"/><quality offsamples="0"/></visual>
  <worldbody>
    <geom type="plane" size="5 5 .1"/>
    <geom name="hidden" type="box" size=".3 .3 .3" pos=".5 .5 .3" group="3" rgba="0 1 0 1"/>
    <geom name="box" type="box" size=".2 .3 .4" pos="-.5 0 .4" rgba="1 0 0 1"/>
    <body name="pair" pos="0 0 1"><freejoint/>
      <geom type="box" size=".1 .2 .1" pos=".4 0 0" mass="9" rgba="0 0 1 1"/>
      <geom type="box" size=".1 .1 .2" pos="-.4 .1 0" mass="1" rgba="1 1 0 1"/>
    </body>
    <camera name="front" pos="0 -3 1" xyaxes="1 0 0 0 .3 1"/>
    <camera pos="2 -2 2" xyaxes="1 1 0 -.5 .5 1"/>
    <camera name="side" pos="3 0 1" xyaxes="0 1 0 -.3 0 1" fovy="60"/>
  </worldbody>
</mujoco>
"""


@pytest.fixture(scope="module")
def tilted() -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def make_free(**fields: Any) -> mujoco.MjvCamera:
    camera = mujoco.MjvCamera()
    for name, value in fields.items():
        setattr(camera, name, value)
    return camera


FREE = make_free(lookat=[0.2, -0.1, 0.4], distance=2.5, azimuth=130.0, elevation=-35.0)
TRACKING = make_free(
    type=int(mujoco.mjtCamera.mjCAMERA_TRACKING), trackbodyid=1, distance=2.0, azimuth=-40.0
)
DOWN = make_free(lookat=[0.1, 0.2, 0.0], distance=3.0, azimuth=20.0, elevation=-90.0)
FIXED = make_free(type=int(mujoco.mjtCamera.mjCAMERA_FIXED), fixedcamid=2)


@pytest.mark.parametrize("number", [0, np.int32(0), np.int64(2), 2])
def test_a_number_is_as_good_as_the_name(
    tilted: tuple[mujoco.MjModel, mujoco.MjData], number: int
) -> None:
    model, data = tilted
    name = model.camera(number).name
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        for one, other in zip(
            render_camera(model, data, renderer, number),
            render_camera(model, data, renderer, name),
            strict=True,
        ):
            assert_array_equal(one, other)
    K, fov_y = get_camera_intrinsics(model, number, WIDTH, HEIGHT)
    assert_array_equal(K, get_camera_intrinsics(model, name, WIDTH, HEIGHT)[0])
    assert fov_y == get_camera_intrinsics(model, name, WIDTH, HEIGHT)[1]
    assert_array_equal(get_camera_pose(model, data, number), get_camera_pose(model, data, name))
    assert_array_equal(
        raycast_points(model, data, number, WIDTH, HEIGHT),
        raycast_points(model, data, name, WIDTH, HEIGHT),
    )


def test_a_camera_of_a_viewer_that_is_fixed_is_the_camera_of_the_model(
    tilted: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = tilted
    assert get_camera_id(model, FIXED) == 2
    assert_array_equal(get_camera_pose(model, data, FIXED), get_camera_pose(model, data, "side"))


@pytest.mark.parametrize("camera", [1, FREE, TRACKING, DOWN, FIXED])
def test_depth_agrees_with_rays_from_any_camera(
    tilted: tuple[mujoco.MjModel, mujoco.MjData], camera: Any
) -> None:
    model, data = tilted
    if not is_gl_available():
        pytest.skip("no OpenGL here: rays would be compared with themselves")
    with make_renderer(model, HEIGHT, WIDTH) as renderer:
        _, depth = render_camera(model, data, renderer, camera)
        labels = render_segmentation(model, data, renderer, camera)
    true = raycast_depth(model, data, camera, WIDTH, HEIGHT)
    seen = np.isfinite(true)
    assert seen.mean() > 0.3
    assert len(np.unique(labels)) > 1
    error = np.abs(depth - true)[seen]
    # One rounding of float32 at 10 m is 0.001 mm; the buffer's own steps stay below 0.01 mm.
    assert np.median(error) < 1e-5
    # What differs by more lies on outlines, where a pixel has two right answers.
    assert np.mean(error > 1e-3) < 0.05


@pytest.mark.parametrize("camera", [FREE, TRACKING, DOWN])
def test_the_pose_of_a_free_camera_is_the_frame_mujoco_draws_from(
    tilted: tuple[mujoco.MjModel, mujoco.MjData], camera: Any
) -> None:
    model, data = tilted
    if camera is TRACKING:  # MuJoCo moves the target when it draws
        camera.lookat[:] = data.subtree_com[1]
    position, forward, up, right = np.zeros((4, 3))
    mujoco.mjv_cameraFrame(position, forward, up, right, data, camera)
    T = get_camera_pose(model, data, camera)
    assert_allclose(T[:3, 3], position, rtol=0, atol=EXACT)
    assert_allclose(T[:3, :3], np.stack([right, -up, forward], axis=1), rtol=0, atol=EXACT)


def test_the_angle_of_a_free_camera_is_that_of_the_model(
    tilted: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    K, fov_y = get_camera_intrinsics(tilted[0], FREE, WIDTH, HEIGHT)
    assert_allclose(fov_y, np.deg2rad(55), rtol=1e-7)  # MuJoCo keeps the angle in float32
    assert_allclose(K[1, 1], 0.5 * HEIGHT / np.tan(fov_y / 2), rtol=EXACT)


def test_the_ray_caster_takes_the_cameras_of_mujocos_renderer(
    tilted: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = tilted
    default = mujoco.MjvCamera()
    mujoco.mjv_defaultFreeCamera(model, default)
    pictures = []
    with RaycastRenderer(model, HEIGHT, WIDTH) as renderer:
        renderer.enable_depth_rendering()
        for camera in (-1, default, "front", 0, 1, FREE, FIXED):
            renderer.update_scene(data, camera)
            pictures.append(renderer.render())
    assert_array_equal(pictures[0], pictures[1])
    assert_array_equal(pictures[2], pictures[3])
    assert_array_equal(
        pictures[4], np.nan_to_num(raycast_depth(model, data, 1, WIDTH, HEIGHT), nan=150.0)
    )


def find_green(rgb: np.ndarray) -> np.ndarray:
    """Mark the pixels whose green stands out."""
    red, green, blue = np.moveaxis(rgb.astype(int), -1, 0)
    return (green > red + 40) & (green > blue + 40)


@pytest.mark.parametrize("make", [mujoco.Renderer, RaycastRenderer])
def test_a_scene_option_says_what_is_seen(
    tilted: tuple[mujoco.MjModel, mujoco.MjData], make: Callable[..., Any]
) -> None:
    model, data = tilted
    option = mujoco.MjvOption()
    option.geomgroup[:] = [0, 0, 0, 1, 0, 0]
    if make is mujoco.Renderer and not is_gl_available():
        pytest.skip("no OpenGL here")
    with make(model, HEIGHT, WIDTH) as renderer:
        rgb, depth = render_camera(model, data, renderer, "front", scene_option=option)
        labels = render_segmentation(model, data, renderer, "front", scene_option=option)
        plain, _ = render_camera(model, data, renderer, "front")
    green = find_green(rgb)
    assert green.any()
    assert (labels[green] == 0).all()  # of the world's body
    assert depth[green].max() < 4
    assert (depth[labels < 0] > 100).all()  # the far plane: the floor is switched off
    assert not find_green(plain).any()


@pytest.mark.parametrize(
    ("camera", "error", "words"),
    [
        ("nose", ValueError, r"expected one of front, side, or a number from 0 to 2, got 'nose'"),
        ("-1", ValueError, r"expected one of front, side, or a number .* got '-1'"),
        (3, ValueError, r"a number from 0 to 2, got 3"),
        (-1, ValueError, r"got -1 \(the free camera is an mujoco.MjvCamera\)"),
        (1.0, TypeError, r"expected a name, a number or an MjvCamera, got float 1.0"),
        (True, TypeError, r"got bool True"),
        (None, TypeError, r"got NoneType None"),
        (make_free(type=int(mujoco.mjtCamera.mjCAMERA_USER)), ValueError, "of type mjCAMERA_FREE"),
        (make_free(type=2, fixedcamid=7), ValueError, r"a number from 0 to 2, got 7"),
    ],
)
def test_a_camera_that_does_not_exist_is_refused_with_those_that_do(
    tilted: tuple[mujoco.MjModel, mujoco.MjData], camera: Any, error: type[Exception], words: str
) -> None:
    model, data = tilted
    with (
        RaycastRenderer(model, 4, 4) as renderer,
        pytest.raises(error, match="camera_name: .*" + words),
    ):
        render_camera(model, data, renderer, camera)
    with pytest.raises(error, match=words):
        get_camera_intrinsics(model, camera, 4, 4)
    with pytest.raises(error, match=words):
        get_camera_pose(model, data, camera)


def test_a_model_without_a_camera_says_what_can_be_done() -> None:
    model = mujoco.MjModel.from_xml_string("<mujoco/>")
    with pytest.raises(ValueError, match=r"the model has no camera; place an mujoco.MjvCamera"):
        get_camera_id(model, "head")


@pytest.mark.parametrize("camera", ["flat", make_free(orthographic=1)])
def test_an_orthographic_camera_says_what_works_and_what_to_change(
    asymmetric: tuple[mujoco.MjModel, mujoco.MjData], camera: Any
) -> None:
    with pytest.raises(ValueError, match="its depth work; for a K, give the camera perspective"):
        get_camera_intrinsics(asymmetric[0], camera, 10, 10)
