"""The renderer contract: what is drawn, and what happens where nothing can draw."""

from __future__ import annotations

import os
import subprocess
import sys
import warnings
from collections.abc import Callable, Iterator
from typing import Any

import mujoco
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import NoOpenGLWarning, make_renderer, render_camera, render_segmentation, rendering
from labutils.raycast import RaycastRenderer
from labutils.renderers.protocol import Renderer


@pytest.fixture
def _no_gl(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A machine where OpenGL cannot draw."""
    rendering._find_gl_problem.cache_clear()
    rendering._warn_once.cache_clear()
    monkeypatch.setenv("MUJOCO_GL", "disable")
    yield
    rendering._find_gl_problem.cache_clear()
    rendering._warn_once.cache_clear()


def run_python(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run code in a process of its own, with a chosen environment."""
    env = {k: v for k, v in os.environ.items() if k not in {"MUJOCO_GL", "DISPLAY"}}
    return subprocess.run(
        [sys.executable, "-c", code],
        env={**env, **environment},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


def test_render_camera_returns_color_bytes_and_metric_depth(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 121, 161) as renderer:
        rgb, depth = render_camera(model, data, renderer, "head_camera")
    assert (rgb.shape, rgb.dtype) == ((121, 161, 3), np.uint8)  # type: ignore[comparison-overlap]  # a dtype equals its type
    assert (depth.shape, depth.dtype) == ((121, 161), np.float32)  # type: ignore[comparison-overlap]  # a dtype equals its type
    assert 0.4 < depth.min() < 1.0


def test_render_camera_leaves_the_renderer_in_color_mode(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 30, 40) as renderer:
        renderer.enable_depth_rendering()
        render_camera(model, data, renderer, "head_camera")
        assert renderer.render().dtype == np.uint8
        render_segmentation(model, data, renderer, "head_camera")
        assert renderer.render().dtype == np.uint8


def test_render_camera_shows_the_current_qpos_without_mj_forward(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 48, 64) as renderer:
        _, before = render_camera(model, data, renderer, "head_camera")
        data.joint("neck_pan").qpos = 0.5
        _, turned = render_camera(model, data, renderer, "head_camera")
        mujoco.mj_forward(model, data)
        _, forwarded = render_camera(model, data, renderer, "head_camera")
    assert np.abs(turned - before).max() > 0.1
    assert_array_equal(turned, forwarded)


def test_render_camera_shows_a_moved_mocap_body(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with make_renderer(model, 48, 64) as renderer:
        before = render_segmentation(model, data, renderer, "head_camera")
        data.mocap_pos[0] += (0, -0.3, 0.3)
        after = render_segmentation(model, data, renderer, "head_camera")
    ball = model.body("red_ball").id
    assert np.argwhere(before == ball).mean(axis=0)[1] < np.argwhere(after == ball).mean(axis=0)[1]


def test_render_camera_changes_no_state(scene: tuple[mujoco.MjModel, mujoco.MjData]) -> None:
    model, data = scene
    size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_INTEGRATION)
    before, after = np.empty(size), np.empty(size)
    mujoco.mj_getState(model, data, before, mujoco.mjtState.mjSTATE_INTEGRATION)
    with make_renderer(model, 24, 32) as renderer:
        render_camera(model, data, renderer, "head_camera")
    mujoco.mj_getState(model, data, after, mujoco.mjtState.mjSTATE_INTEGRATION)
    assert_array_equal(after, before)


@pytest.mark.parametrize("function", [render_camera, render_segmentation])
def test_an_unknown_camera_is_named_with_the_known_ones(
    scene: tuple[mujoco.MjModel, mujoco.MjData], function: Callable[..., Any]
) -> None:
    model, data = scene
    with (
        make_renderer(model, 24, 32) as renderer,
        pytest.raises(ValueError, match=r"expected one of .*head_camera.*, got 'hand'"),
    ):
        function(model, data, renderer, "hand")


@pytest.mark.parametrize(
    ("height", "width", "error", "words"),
    [
        (0, 64, ValueError, "height: expected at least 1 pixel, got 0"),
        (48, 64.0, TypeError, "width: expected a whole number of pixels"),
        (True, 64, TypeError, "height: expected a whole number"),
    ],
)
def test_a_size_that_is_none_is_refused(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
    height: Any,
    width: Any,
    error: type[Exception],
    words: str,
) -> None:
    with pytest.raises(error, match=words):
        make_renderer(scene[0], height, width)


@pytest.mark.usefixtures("_no_gl")
def test_without_opengl_the_ray_caster_takes_over_and_says_so_once(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with pytest.warns(
        NoOpenGLWarning, match=r"MUJOCO_GL switches OpenGL off.*exact.*To get"
    ) as told:
        renderer = make_renderer(model, 48, 64)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        make_renderer(model, 48, 64)
    assert len(told) == 1
    assert isinstance(renderer, RaycastRenderer)
    rgb, depth = render_camera(model, data, renderer, "head_camera")
    assert rgb.std() > 10
    assert 0.4 < depth.min() < depth.max() <= 12.0


@pytest.mark.usefixtures("_no_gl")
def test_in_a_page_the_ray_caster_draws_and_nobody_is_warned(
    scene: tuple[mujoco.MjModel, mujoco.MjData], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "platform", "emscripten")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert isinstance(make_renderer(scene[0], 48, 64), RaycastRenderer)
    assert not rendering.is_gl_available()


def test_the_ray_caster_draws_what_opengl_draws(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    frames = []
    for renderer in (make_renderer(model, 120, 160), RaycastRenderer(model, 120, 160)):
        _, depth = render_camera(model, data, renderer, "head_camera")
        frames.append((depth, render_segmentation(model, data, renderer, "head_camera")))
        renderer.close()
    (gl_depth, gl_labels), (ray_depth, ray_labels) = frames
    same = gl_labels == ray_labels
    # Outlines of polygons and of true curves differ by a pixel here and there.
    assert same.mean() > 0.995
    assert np.median(np.abs(gl_depth - ray_depth)[same]) < 1e-5
    # Where nothing is seen both read the far plane: 12 m, to OpenGL's float32 resolution there.
    assert_allclose(gl_depth[same & (ray_labels < 0)], 12.0, rtol=1e-4)
    assert_allclose(ray_depth[ray_labels < 0], 12.0, rtol=1e-6)


def test_the_ray_caster_refuses_what_it_cannot_do(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    renderer = RaycastRenderer(model, 24, 32)
    with pytest.raises(RuntimeError, match="expected a call of update_scene first"):
        renderer.render()
    with pytest.raises(ValueError, match="a number from 0 to"):
        renderer.update_scene(data, -2)
    renderer.update_scene(data, "head_camera")
    with pytest.raises(ValueError, match=r"out: expected shape \(24, 32, 3\), got \(32, 24, 3\)"):
        renderer.render(out=np.empty((32, 24, 3), np.uint8))
    with pytest.raises(ValueError, match="width: expected at most"):
        RaycastRenderer(model, 24, 100_000)


@pytest.mark.parametrize("make", [make_renderer, RaycastRenderer])
def test_a_picture_is_written_where_it_is_asked_to(
    scene: tuple[mujoco.MjModel, mujoco.MjData], make: Callable[..., Any]
) -> None:
    model, data = scene
    with make(model, 24, 32) as renderer:
        renderer.update_scene(data, "head_camera")
        expected = renderer.render()
        for dtype in (np.uint8, np.float64):
            out = np.zeros((24, 32, 3), dtype)
            assert renderer.render(out=out) is out
            assert_array_equal(out, expected)


def test_the_ray_caster_accepts_a_camera_id_and_forgets_on_close(
    scene: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = scene
    with RaycastRenderer(model, 24, 32) as renderer:
        renderer.update_scene(data, camera=model.camera("overview").id)
        assert renderer.render().shape == (24, 32, 3)
    renderer.update_scene(data, "head_camera")
    with pytest.raises(RuntimeError, match="expected an open renderer, got one after close"):
        renderer.render()


@pytest.mark.parametrize("make", [make_renderer, RaycastRenderer])
def test_a_state_that_was_never_forwarded_shows_nothing_but_the_far_plane(
    scene: tuple[mujoco.MjModel, mujoco.MjData], make: Callable[..., Renderer]
) -> None:
    model, _ = scene
    with make(model, 24, 32) as renderer:
        renderer.update_scene(mujoco.MjData(model), camera="head_camera")
        assert renderer.render().shape == (24, 32, 3)
        renderer.enable_depth_rendering()
        assert_allclose(renderer.render(), 12.0, rtol=1e-4)


def test_an_empty_model_is_all_sky_for_the_ray_caster() -> None:
    model = mujoco.MjModel.from_xml_string(
        "<mujoco><worldbody><camera name='c'/></worldbody></mujoco>"
    )
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    renderer = RaycastRenderer(model, 4, 6)
    renderer.update_scene(data, "c")
    assert np.ptp(renderer.render().reshape(-1, 3), axis=0).max() == 0


def test_headless_linux_chooses_egl_and_a_users_choice_wins() -> None:
    code = "import labutils, os; print(os.environ.get('MUJOCO_GL'))"
    if sys.platform.startswith("linux"):
        expected = "disable" if rendering._find_missing_libraries() else "egl"
        assert run_python(code).stdout.strip() == expected
    assert run_python(code, MUJOCO_GL="disable").stdout.strip() == "disable"


@pytest.mark.skipif(
    not sys.platform.startswith("linux") or bool(rendering._find_missing_libraries()),
    reason="only EGL, on Linux, draws without a screen",
)
def test_mujoco_may_be_imported_before_the_library() -> None:
    # MuJoCo alone would settle for GLFW, which needs a screen.
    code = """
import mujoco
from labutils import make_renderer, make_scene, render_raw_depth
model, data = make_scene()
renderer = make_renderer(model, 24, 32)
print(type(renderer).__module__, render_raw_depth(model, data, renderer, 'head_camera').shape)
"""
    done = run_python(code)
    assert done.stdout.strip() == "mujoco.rendering.classic.renderer (24, 32)", done.stderr
    assert done.stderr == ""


@pytest.mark.parametrize(
    ("gone", "named"), [("EGL", "libEGL.so.1"), ("OpenGL GLESv2", "libOpenGL.so.0")]
)
@pytest.mark.parametrize("first", ["import mujoco", ""])
def test_without_its_libraries_mujoco_still_imports_and_draws_with_rays(
    gone: str, named: str, first: str
) -> None:
    code = f"""
import ctypes.util
find = ctypes.util.find_library
ctypes.util.find_library = lambda name: None if name in {gone.split()} else find(name)
{first}
from labutils import make_renderer, make_scene
model, data = make_scene()
print(type(make_renderer(model, 24, 32)).__name__)
"""
    done = run_python(code, MUJOCO_GL="" if first else "egl")
    assert done.stdout.strip() == "RaycastRenderer", done.stderr
    assert f"not installed: {named}" in done.stderr


def test_a_driver_that_fails_hands_over_with_its_own_words() -> None:
    code = """
import labutils, mujoco
class Broken:
    def __init__(self, *args): raise RuntimeError('no such display')
mujoco.Renderer = Broken
model, data = labutils.make_scene()
print(type(labutils.make_renderer(model, 24, 32)).__name__)
"""
    # "glfw" is a name MuJoCo accepts everywhere at import; nothing is drawn with it here.
    done = run_python(code)
    assert done.stdout.strip() == "RaycastRenderer", done.stderr
    if "libEGL" not in done.stderr:
        assert "RuntimeError: no such display" in done.stderr
