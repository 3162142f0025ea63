"""Intrinsic matrices and poses, ours against the peers'."""

from __future__ import annotations

import copy

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import get_camera_intrinsics, get_camera_pose, points_to_pixels, raycast_points
from tests.foreign.measuring import cast, draw, draw_by_hand, measure
from tests.foreign.peers import load
from tests.foreign.views import FREE, HEIGHT, VIEWS, WIDTH, View
from tests.helpers.tolerances import DEPTH_MEDIAN_MM, EXACT

#: A field of view in degrees is a focal length of hundreds of pixels: some roundings of those.
K_PX = 1e-9
DM = [view for view in VIEWS if view.peer == "dm_control"]
ROBOSUITE = [view for view in VIEWS if view.peer == "robosuite"]


@pytest.mark.parametrize("view", DM, ids=str)
def test_intrinsics_are_those_of_dm_control(view: View) -> None:
    offset = measure(view).K_offset_px
    assert offset is not None
    assert_allclose(offset, 0, rtol=0, atol=K_PX)


@pytest.mark.parametrize("view", ROBOSUITE, ids=str)
def test_robosuites_principal_point_is_half_a_pixel_further(view: View) -> None:
    # It takes W/2 and H/2, where integer pixels would be corners; MuJoCo's depth has centers.
    offset = measure(view).K_offset_px
    assert offset is not None
    half = np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]])
    assert_allclose(offset, half, rtol=0, atol=K_PX)


def test_gymnasium_has_no_intrinsics_to_compare() -> None:
    # the table says "none"; this notices the day it has some
    gymnasium = pytest.importorskip("gymnasium.envs.mujoco.mujoco_rendering")
    names = [name.lower() for name in dir(gymnasium) + dir(gymnasium.MujocoRenderer)]
    assert not [name for name in names if "intrinsic" in name or "matri" in name]


@pytest.mark.parametrize("view", [*DM, *ROBOSUITE], ids=str)
def test_poses_are_those_of_the_peers(view: View) -> None:
    peer = load(view.peer, view.model)
    said = peer.said[view.camera]
    data = peer.make_data()
    mujoco.mj_forward(peer.model, data)
    assert said.T_world_cam is not None
    # A free camera's axes stand in the scene in single precision.
    tolerance = 1e-6 * peer.model.stat.extent if view.camera == FREE else EXACT
    pose = get_camera_pose(peer.model, data, said.camera)
    assert_allclose(pose, said.T_world_cam, rtol=0, atol=tolerance)


@pytest.mark.parametrize("view", [view for view in VIEWS if view.camera == FREE], ids=str)
def test_the_rays_of_a_free_camera_come_back_to_their_pixels(view: View) -> None:
    peer = load(view.peer, view.model)
    camera = peer.said[view.camera].camera
    data = peer.make_data()
    mujoco.mj_forward(peer.model, data)
    K, _ = get_camera_intrinsics(peer.model, camera, WIDTH, HEIGHT)
    T_world_cam = get_camera_pose(peer.model, data, camera)
    hits = raycast_points(peer.model, data, camera, WIDTH, HEIGHT)
    v, u = np.nonzero(np.isfinite(hits[..., 0]))
    points = (hits[v, u] - T_world_cam[:3, 3]) @ T_world_cam[:3, :3]
    assert len(points) > 1000
    assert_allclose(points_to_pixels(points, K), np.stack([u, v], axis=1), rtol=0, atol=1e-3)


@pytest.mark.parametrize("name", ["humanoid.stand", "walker.stand"])
def test_a_free_camera_that_tracks_a_body_is_right_too(name: str) -> None:
    peer = load("dm_control", name)
    camera = copy.copy(peer.said[FREE].camera)
    assert isinstance(camera, mujoco.MjvCamera)
    camera.type, camera.trackbodyid = mujoco.mjtCamera.mjCAMERA_TRACKING.value, 1
    camera.distance, camera.azimuth, camera.elevation = 3.0, 70.0, -30.0
    data = peer.make_stepped_data()
    by_hand = draw_by_hand(peer, data, camera)
    color, depth = draw(peer, data, camera)
    assert_array_equal(color, by_hand[0])
    assert_array_equal(depth, by_hand[1])
    mujoco.mj_forward(peer.model, data)
    truth = cast(peer, data, camera, by_hand[2])
    error_mm = 1000 * np.abs(depth - truth.depth)[truth.comparable]
    assert np.median(error_mm) < DEPTH_MEDIAN_MM
