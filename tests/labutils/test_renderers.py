"""Both renderers keep one protocol, and each knows how its raw depth is read."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils import get_clip_planes, make_renderer, metric_to_raw, render_camera, render_raw_depth
from labutils import raycast as truth
from labutils.renderers import opengl, rays
from labutils.renderers.protocol import Renderer

METHODS = [name for name, one in vars(Renderer).items() if inspect.isfunction(one)]
METHODS = [name for name in METHODS if not name.startswith("__") and "subclass" not in name]


def test_the_protocol_asks_for_what_pages_use() -> None:
    assert {"update_scene", "render", "close", "enable_depth_rendering"} <= set(METHODS)


@pytest.mark.parametrize("kind", [mujoco.Renderer, rays.RaycastRenderer])
@pytest.mark.parametrize("name", METHODS)
def test_a_renderer_takes_the_arguments_of_the_protocol(kind: type, name: str) -> None:
    asked = inspect.signature(getattr(Renderer, name)).parameters
    given = inspect.signature(getattr(kind, name)).parameters
    # MuJoCo's may take more by keyword than the protocol asks for, but nothing more by place.
    taken = [one for one in given.values() if one.name in asked or one.kind is not one.KEYWORD_ONLY]
    assert [one.name for one in taken] == list(asked)
    assert [one.default for one in taken] == [one.default for one in asked.values()]
    assert [one.kind for one in taken] == [one.kind for one in asked.values()]


@pytest.mark.parametrize("make", [make_renderer, rays.RaycastRenderer])
def test_a_renderer_is_one_of_the_protocol_and_says_its_size(
    scene: tuple[mujoco.MjModel, mujoco.MjData], make: Callable[..., Renderer]
) -> None:
    with make(scene[0], 24, 33) as renderer:
        assert isinstance(renderer, Renderer)
        assert (renderer.height, renderer.width) == (24, 33)


def test_what_lacks_a_method_is_no_renderer() -> None:
    assert not isinstance(object(), Renderer)


def test_the_truth_hands_out_the_renderer_of_the_rays() -> None:
    assert truth.RaycastRenderer is rays.RaycastRenderer


def test_opengl_is_told_from_rays(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    with rays.RaycastRenderer(scene[0], 8, 8) as renderer:
        assert not opengl.is_used_by(renderer)


def test_raw_depth_of_rays_is_exact_and_leaves_color_mode(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with rays.RaycastRenderer(model, 24, 32) as renderer:
        _, depth = render_camera(model, data, renderer, "head_camera")
        raw = rays.read_raw_depth(model, renderer)
        assert renderer.render().dtype == np.uint8
    expected = metric_to_raw(depth, *get_clip_planes(model)).astype(np.float32)
    assert_array_equal(raw, expected)


def test_any_renderer_of_the_protocol_has_a_raw_depth(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    """A renderer nobody has written yet: neither MuJoCo's nor ours."""

    class Delegate:
        def __init__(self, inner: Renderer) -> None:
            self._inner = inner

        def __getattr__(self, name: str) -> Any:
            return getattr(self._inner, name)

    model, data = scene
    inner = rays.RaycastRenderer(model, 24, 32)
    raw = render_raw_depth(model, data, Delegate(inner), "head_camera")
    assert_array_equal(raw, render_raw_depth(model, data, inner, "head_camera"))
