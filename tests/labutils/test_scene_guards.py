"""Model, state, renderer and thread belong together, or a sentence says that they do not."""

from __future__ import annotations

import copy
import threading
import warnings
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from labutils import is_gl_available, make_renderer, raycast, render_camera
from labutils.renderers import omissions
from labutils.renderers.rays import RaycastRenderer
from tests.labutils.test_up_to_date import MODEL as EVERYTHING

pytestmark = pytest.mark.filterwarnings("ignore::labutils.NoOpenGLWarning")

ONE = """
<mujoco><worldbody><camera name="eye"/><geom pos="0 0 -1" size=".{size}"/></worldbody></mujoco>
"""


def make(size: int = 2) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = mujoco.MjModel.from_xml_string(ONE.format(size=size))
    return model, mujoco.MjData(model)


def test_a_renderer_of_another_model_is_refused() -> None:
    (model, data), (other, _) = make(2), make(3)
    with (
        make_renderer(other, 8, 8) as renderer,
        pytest.raises(ValueError, match="renderer: expected one made for this model"),
    ):
        render_camera(model, data, renderer, "eye")


def test_a_renderer_of_an_equal_copy_will_do() -> None:
    model, data = make()
    with make_renderer(model, 8, 8) as renderer:
        _, depth = render_camera(model, data, renderer, "eye")
        twin = copy.copy(model)
        _, same = render_camera(twin, mujoco.MjData(twin), renderer, "eye")
    assert_array_equal(depth, same)


def test_a_state_of_another_model_is_refused(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, _ = make()
    with (
        make_renderer(model, 8, 8) as renderer,
        pytest.raises(ValueError, match=r"data: expected a state of this model \(nq = 0\)"),
    ):
        render_camera(model, scene[1], renderer, "eye")


def test_a_wrapper_says_what_to_pass_instead() -> None:
    model, data = make()
    wrapped: Any = SimpleNamespace(ptr=model)
    wrapped_data: Any = SimpleNamespace(ptr=data)
    with pytest.raises(TypeError, match=r"model: .* got a wrapper of one .*; pass its model.ptr"):
        make_renderer(wrapped, 8, 8)
    with RaycastRenderer(model, 8, 8) as renderer:
        with pytest.raises(TypeError, match=r"pass its model.ptr"):
            render_camera(wrapped, data, renderer, "eye")
        with pytest.raises(TypeError, match=r"pass its data.ptr"):
            render_camera(model, wrapped_data, renderer, "eye")


def test_arguments_in_the_wrong_order_are_named() -> None:
    model, data = make()
    state: Any = data
    name: Any = "eye"
    with RaycastRenderer(model, 8, 8) as renderer:
        with pytest.raises(TypeError, match=r"model: expected a mujoco.MjModel, got .*MjData"):
            render_camera(state, data, renderer, "eye")
        with pytest.raises(TypeError, match=r"renderer: expected one from make_renderer, got str"):
            render_camera(model, data, name, "eye")


def test_a_renderer_of_another_thread_says_so() -> None:
    model, data = make()
    if not is_gl_available():
        pytest.skip("no OpenGL here: rays may be cast in any thread")
    with make_renderer(model, 8, 8) as renderer:
        render_camera(model, data, renderer, "eye")
        caught: list[BaseException] = []

        def draw() -> None:
            try:
                render_camera(model, data, renderer, "eye")
            except RuntimeError as error:
                caught.append(error)

        thread = threading.Thread(target=draw)
        thread.start()
        thread.join()
        assert "expected one made in this thread" in str(caught[0])
        assert "call make_renderer in every thread" in str(caught[0])
        render_camera(model, data, renderer, "eye")  # and it still draws where it was made


@pytest.fixture
def forgetful() -> Iterator[None]:
    """Let the warnings of other tests be forgotten, and this one's too."""
    kept = set(omissions._told)
    omissions._told.clear()
    yield
    omissions._told.clear()
    omissions._told.update(kept)


@pytest.mark.usefixtures("forgetful")
def test_the_ray_caster_says_once_what_it_leaves_out_of_a_model() -> None:
    model = mujoco.MjModel.from_xml_string(EVERYTHING)
    with pytest.warns(omissions.NotDrawnWarning) as caught:
        RaycastRenderer(model, 8, 8)
    assert "3 sites, 1 tendon, 1 flex, 1 range-finder line" in str(caught[0].message)
    assert caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        RaycastRenderer(mujoco.MjModel.from_xml_string(EVERYTHING), 8, 8)
        RaycastRenderer(make()[0], 8, 8)  # geoms only: nothing to say


def test_what_is_hidden_is_not_missed() -> None:
    model = mujoco.MjModel.from_xml_string(EVERYTHING)
    option = mujoco.MjvOption()
    option.sitegroup[:] = 0
    option.flags[mujoco.mjtVisFlag.mjVIS_RANGEFINDER] = 0
    option.flags[mujoco.mjtVisFlag.mjVIS_TENDON] = 0
    assert omissions.list_omissions(model, option) == ["1 flex"]


def test_the_list_is_what_opengl_draws_and_rays_do_not() -> None:
    """Every kind on the list, and nothing else, is seen by one and not by the other."""
    model = mujoco.MjModel.from_xml_string(EVERYTHING)
    data = mujoco.MjData(model)
    if not is_gl_available():
        pytest.skip("no OpenGL here")
    with make_renderer(model, 120, 160) as renderer:
        _, depth = render_camera(model, data, renderer, "fixed")
        renderer.enable_segmentation_rendering()
        kinds = renderer.render()[..., 1]
    true = raycast.raycast_depth(model, data, "fixed", 160, 120)
    differs = np.abs(depth - np.nan_to_num(true, nan=depth.max())) > 0.05
    is_geom = kinds == int(mujoco.mjtObj.mjOBJ_GEOM)
    # Outlines of geoms aside, rays and OpenGL differ where something else than a geom is drawn.
    assert differs[~is_geom & (kinds >= 0)].mean() > 0.5
    assert differs[is_geom].mean() < 0.01
