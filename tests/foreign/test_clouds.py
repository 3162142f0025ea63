"""Clouds in the world, ours against drake's, which has never heard of MuJoCo."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from labutils import (
    camera_to_world,
    depth_to_pointcloud,
    get_camera_intrinsics,
    get_camera_pose,
)
from labutils._constants import FLIP_YZ
from tests.foreign.conftest import CLOUDS, DRAKE
from tests.foreign.measuring import draw
from tests.foreign.peers import load
from tests.foreign.views import FREE, HEIGHT, WIDTH, View

#: Drake computes a point in single precision: some roundings of 5 m are less than a micrometer.
DISTANCE_MM = 0.001
CAMERAS = (
    View("dm_control", "dog.stand", "y-axis"),
    View("dm_control", "fish.upright", "tracking_x"),
    View("dm_control", "quadruped.escape", "x"),
    View("robosuite", "Lift", "agentview"),
    View("robosuite", "Lift", "robot0_eye_in_hand"),
    View("gymnasium", "Reacher-v5", FREE),
)


@pytest.mark.parametrize("view", CAMERAS, ids=str)
def test_the_cloud_in_the_world_is_drakes(
    view: View, tmp_path: Path, pytestconfig: pytest.Config
) -> None:
    python = pytestconfig.getoption("--drake")
    assert python, "expected --drake, as `make foreign` gives it"
    peer = load(view.peer, view.model)
    data = peer.make_data()
    camera = peer.said[view.camera].camera
    _, depth = draw(peer, data, camera)
    K, fov_y = get_camera_intrinsics(peer.model, camera, WIDTH, HEIGHT)
    T_world_cam = get_camera_pose(peer.model, data, camera)
    points, _ = depth_to_pointcloud(depth, K)
    # MuJoCo's camera has y up and looks along -z
    ours = camera_to_world(points, T_world_cam[:3, 3], T_world_cam[:3, :3] @ FLIP_YZ)

    # Drake has other limits for what is too near and too far: it gets the pixels that we keep.
    kept = (depth > 0.01) & (depth < 10.0)
    frame, cloud = tmp_path / "frame.npz", tmp_path / "cloud.npz"
    np.savez(
        frame,
        depth=np.where(kept, depth, np.inf),
        K=K,
        T_world_cam=T_world_cam,
        fov_y=fov_y,
    )
    script = Path(__file__).with_name("drake_clouds.py")
    subprocess.run([python, str(script), str(frame), str(cloud)], check=True)
    with np.load(cloud) as file:
        theirs, K_drake, version = file["points"], file["K"], str(file["version"])

    assert_allclose(K_drake, K, rtol=0, atol=1e-9)
    assert len(ours) == len(theirs) > 50_000
    largest = float(1000 * np.linalg.norm(ours.astype(float) - theirs, axis=1).max())
    pytestconfig.stash[CLOUDS][view] = largest
    pytestconfig.stash[DRAKE] = version
    assert largest < DISTANCE_MM
