"""Both renderers keep one protocol, and each knows how its raw depth is read."""

from __future__ import annotations

import inspect
import itertools
from collections.abc import Callable
from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils import (
    get_clip_planes,
    is_gl_available,
    make_renderer,
    metric_to_raw,
    render_camera,
    render_raw_depth,
)
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


def test_rays_are_told_from_opengl_where_everything_is_drawn_by_rays(
    scene: tuple[mujoco.MjModel, mujoco.MjData], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mujoco, "Renderer", rays.RaycastRenderer)  # as in a page
    with mujoco.Renderer(scene[0], 8, 8) as renderer:
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


def test_the_ray_caster_has_all_that_mujocos_renderer_has() -> None:
    names = [name for name in dir(mujoco.Renderer) if not name.startswith("_")]
    assert [name for name in names if not hasattr(rays.RaycastRenderer, name)] == []
    for name in ("__init__", *names):
        theirs, ours = getattr(mujoco.Renderer, name), getattr(rays.RaycastRenderer, name)
        if isinstance(theirs, property):
            assert isinstance(ours, property)
            continue
        taken = inspect.signature(ours).parameters
        for parameter in inspect.signature(theirs).parameters.values():
            assert parameter.name in taken, f"{name}({parameter.name})"
            assert parameter.kind is taken[parameter.name].kind


@pytest.mark.skipif(not is_gl_available(), reason="no OpenGL here to compare with")
def test_any_order_of_switches_gives_the_same_kind_of_picture(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    switches = [name for name in dir(mujoco.Renderer) if name.startswith(("enable", "disable"))]
    with mujoco.Renderer(model, 6, 8) as theirs, rays.RaycastRenderer(model, 6, 8) as ours:
        for renderer in (theirs, ours):
            renderer.update_scene(data, "head_camera")
        for first, second, third in itertools.product(switches, repeat=3):
            for name in (first, second, third):
                getattr(theirs, name)()
                getattr(ours, name)()
            due, came = theirs.render(), ours.render()
            assert (due.shape, due.dtype) == (came.shape, came.dtype), (first, second, third)


def test_the_scene_of_the_ray_caster_is_what_opengl_would_draw(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with rays.RaycastRenderer(model, 24, 32) as renderer:
        assert renderer.scene.ngeom == 0
        renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = 0  # allowed, and without effect
        for camera in ("head_camera", -1):
            renderer.update_scene(data, camera)
            assert renderer.scene.ngeom > model.ngeom / 2
        renderer.update_scene(data, "head_camera")
        eyes = [np.array(eye.pos) for eye in renderer.scene.camera]
    middle = data.camera("head_camera").xpos
    # float32, and two eyes: their middle is where the camera is
    np.testing.assert_allclose(np.mean(eyes, axis=0), middle, rtol=0, atol=1e-6)
