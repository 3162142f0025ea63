"""Things are named by their color, measured along their rays, and found on request."""

from __future__ import annotations

from typing import NamedTuple

import mujoco
import numpy as np
import pytest

from labutils import (
    get_camera_intrinsics,
    make_renderer,
    make_scene,
    render_camera,
    render_segmentation,
)
from labutils.following import Thing, find_thing, find_things
from tests.helpers.scenes import move_neck


class Pose(NamedTuple):
    """What the head sees in one pose, and which body each pixel shows."""

    rgb: np.ndarray
    depth: np.ndarray
    bodies: np.ndarray
    K: np.ndarray
    model: mujoco.MjModel


RED, GREEN = (200, 20, 20), (20, 160, 40)


def draw(
    *things: tuple[tuple[int, int, int], slice, slice, float],
) -> tuple[np.ndarray, np.ndarray]:
    """Draw boxes of a color and a depth on gray, far away."""
    rgb, depth = np.full((60, 80, 3), 128, np.uint8), np.full((60, 80), 5.0)
    for color, rows, columns, z in things:
        rgb[rows, columns], depth[rows, columns] = color, z
    return rgb, depth


def test_things_are_named_by_color_and_the_nearest_comes_first(K: np.ndarray) -> None:
    rgb, depth = draw(
        (RED, slice(5, 15), slice(5, 25), 2.0),
        (GREEN, slice(30, 50), slice(40, 60), 1.0),
        (RED, slice(30, 50), slice(5, 25), 1.5),
    )
    found = find_things(rgb, depth, K)
    assert [(one.color, one.area) for one in found] == [("green", 400), ("red", 400), ("red", 200)]
    assert found[0].pixel == pytest.approx((49.5, 39.5))


def test_a_distance_runs_along_the_ray_and_not_along_the_axis(K: np.ndarray) -> None:
    rgb, depth = draw((RED, slice(20, 29), slice(60, 69), 2.0))
    (thing,) = find_things(rgb, depth, K)
    ray = ((64 - K[0, 2]) / K[0, 0], (24 - K[1, 2]) / K[1, 1], 1.0)
    # by depth alone it would be 2.0, which the tolerance excludes
    assert thing.distance == pytest.approx(2.0 * np.linalg.norm(ray), abs=1e-3)
    assert thing.distance > 2.01


def test_a_hole_in_the_depth_does_not_count_and_a_thing_without_any_is_left_out(
    K: np.ndarray,
) -> None:
    rgb, depth = draw(
        (RED, slice(5, 25), slice(5, 25), 2.0), (GREEN, slice(30, 50), slice(5, 25), 1.0)
    )
    depth[5:20, 5:25] = 0.0
    depth[30:50, 5:25] = np.nan
    (thing,) = find_things(rgb, depth, K)
    assert thing.color == "red"
    assert thing.distance == pytest.approx(2.0, rel=0.02)


def test_specks_are_no_things(K: np.ndarray) -> None:
    rgb, depth = draw((RED, slice(5, 8), slice(5, 8), 1.0))
    assert find_things(rgb, depth, K) == []


def test_sizes_have_to_agree(K: np.ndarray) -> None:
    rgb, depth = draw()
    with pytest.raises(ValueError, match=r"depth: expected the picture's size \(60, 80\), got"):
        find_things(rgb, depth[1:], K)


@pytest.fixture(scope="module")
def poses() -> list[Pose]:
    """Look at the scene from four poses of the head."""
    model, data = make_scene()
    K, _ = get_camera_intrinsics(model, "head_camera", 320, 240)
    found = []
    with make_renderer(model, 240, 320) as renderer:
        rng = np.random.default_rng(14)
        for _ in range(4):
            rgb, depth = render_camera(model, data, renderer, "head_camera")
            bodies = render_segmentation(model, data, renderer, "head_camera")
            found.append(Pose(rgb, depth, bodies, K, model))
            move_neck(model, data, rng)
    return found


def test_each_thing_in_the_scene_is_a_body_of_that_color(poses: list[Pose]) -> None:
    seen = set()
    for rgb, depth, bodies, K, model in poses:
        for thing in find_things(rgb, depth, K):
            u, v = (round(one) for one in thing.pixel)
            body = model.body(bodies[v, u]).name
            assert body.startswith(f"{thing.color}_"), thing
            seen.add(body)
    assert len(seen) == 8  # all that stands on the table


THINGS = [
    Thing("red", (1.0, 1.0), 1.5, 90),
    Thing("cyan", (2.0, 1.0), 0.5, 70),
    Thing("red", (3.0, 1.0), 0.9, 40),
]


@pytest.mark.parametrize(
    ("request_", "place"),
    [
        ("nearest red thing", 2),
        ("farthest red thing", 0),
        ("Look at the largest red thing, please.", 0),
        ("red", 2),
        ("cyan thing", 1),
        ("the nearest purple thing", None),
    ],
)
def test_a_request_finds_the_thing_it_means(request_: str, place: int | None) -> None:
    assert find_thing(request_, THINGS) == (None if place is None else THINGS[place])


@pytest.mark.parametrize("request_", ["nearest thing", "red or cyan thing", ""])
def test_a_request_has_one_color(request_: str) -> None:
    with pytest.raises(ValueError, match="request: expected one color of red, orange"):
        find_thing(request_, THINGS)


def test_a_request_has_one_order() -> None:
    with pytest.raises(ValueError, match="request: expected one of nearest, farthest, largest"):
        find_thing("nearest and farthest red thing", THINGS)
