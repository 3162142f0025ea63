"""Depth against rays off edges: the library's, and the peers' own."""

from __future__ import annotations

import copy
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils.renderers.omissions import list_omissions
from tests.foreign.measuring import cast, draw, draw_by_hand, measure
from tests.foreign.peers import load
from tests.foreign.views import VIEWS, View
from tests.helpers.tolerances import DEPTH_MEDIAN_MM

#: All that is seen there is thin and round, and MuJoCo draws round geoms with flat faces.
ROUND_ONLY = View("dm_control", "acrobot.swingup", "lookat")
FLAT = [view for view in VIEWS if view != ROUND_ONLY]


@pytest.mark.parametrize("view", FLAT, ids=str)
def test_depth_agrees_with_the_rays_with_one_sample_a_pixel_and_with_many(view: View) -> None:
    found = measure(view)
    assert found.depth_single_mm < DEPTH_MEDIAN_MM
    # MuJoCo's renderer switches multisampling off for depth, so the model's setting is no matter.
    assert found.depth_mm == found.depth_single_mm


def test_where_only_round_geoms_are_seen_their_flat_faces_are_the_error() -> None:
    # The face of a regular polygon lies inside its circle by a share that falls with the square
    # of the number of faces: 8 times as many, 64 times less. Half of that is asked for.
    peer = load(ROUND_ONLY.peer, ROUND_ONLY.model)
    errors = []
    for factor in (1, 8):
        fine = copy.copy(peer.model)
        fine.vis.quality.numslices *= factor
        fine.vis.quality.numstacks *= factor
        data = peer.make_data()
        _, depth = draw(peer, data, ROUND_ONLY.camera, fine)
        labels = draw_by_hand(peer, data, ROUND_ONLY.camera, fine)[2]
        mujoco.mj_forward(peer.model, data)
        truth = cast(peer, data, ROUND_ONLY.camera, labels)
        error = 1000 * np.abs(depth - truth.depth)[truth.comparable]
        errors.append(np.median(error))
    assert errors[0] < 0.5
    assert errors[1] < errors[0] / 32


@pytest.mark.parametrize("view", VIEWS, ids=str)
def test_peers_depth_is_further_from_the_rays(view: View) -> None:
    # All three read the bare depth buffer, in which several samples a pixel are resolved to one.
    found = measure(view)
    assert found.depth_mm < found.peer_mm


def test_a_sky_box_stands_in_the_peers_depth_before_the_far_plane() -> None:
    # MuJoCo draws it as a cylinder that lies before the far plane: what shows nothing has a depth
    # that looks like one. Its renderer draws no sky box into depth.
    skies = {view: measure(view).sky for view in VIEWS if _has_sky_box(view)}
    seen = {view: sky for view, sky in skies.items() if sky is not None}
    assert len(seen) > 10
    assert {view: sky for view, sky in seen.items() if not 0.3 < sky < 0.9} == {}


def _has_sky_box(view: View) -> bool:
    kinds = load(view.peer, view.model).model.tex_type
    return bool((kinds == mujoco.mjtTexture.mjTEXTURE_SKYBOX.value).any())


@pytest.mark.parametrize("view", VIEWS, ids=str)
def test_what_rays_pass_through_is_named_beforehand(view: View) -> None:
    peer = load(view.peer, view.model)
    named = " ".join(list_omissions(peer.model, peer.scene_option))
    assert {name for name in measure(view).no_geoms if name not in named} == set()


def test_sites_that_robosuite_hides_stand_in_depth_until_their_group_is_hidden() -> None:
    # It hides them by a negative alpha. Color does not show them; where labels and depth are
    # drawn, MuJoCo leaves out only what has no alpha at all.
    peer = load("robosuite", "Lift")
    camera = "robot0_eye_in_hand"
    data = peer.make_data()
    color, depth, labels = draw_by_hand(peer, data, camera)
    option = copy.copy(peer.scene_option)
    assert option is not None
    option.sitegroup[:] = 0
    hidden = replace(peer, scene_option=option)
    color_hidden, depth_hidden = draw(hidden, data, camera)
    ghosts = labels[..., 1] == mujoco.mjtObj.mjOBJ_SITE.value
    assert ghosts.sum() > 1000
    assert_array_equal(color_hidden, color)
    assert np.median((depth_hidden - depth)[ghosts]) > 0.1  # the fingers' gap, far before the table
    truth = cast(hidden, data, camera, draw_by_hand(hidden, data, camera)[2])
    error = 1000 * np.abs(depth_hidden - truth.depth)[ghosts & truth.comparable]
    assert np.median(error) < DEPTH_MEDIAN_MM
