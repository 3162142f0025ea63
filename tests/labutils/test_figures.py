"""Figures: finished pictures that show themselves, the same every time."""

from __future__ import annotations

import sys
from types import SimpleNamespace
from typing import Any, NoReturn

import cv2
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from labutils import visualize_pointcloud
from labutils._drawing.style import INK
from labutils._splat import get_view_point, make_look_at, render_points
from labutils.figures import (
    Picture,
    plot_cloud,
    plot_comparison,
    plot_depth,
    plot_histogram,
    plot_images,
    plot_lines,
)

RNG_SEED = 3

NAMES = ("cloud", "comparison", "depth", "histogram", "images", "lines")


def decode(picture: Picture) -> np.ndarray:
    """Read a picture back: BGRA."""
    image = cv2.imdecode(np.frombuffer(picture.png, np.uint8), cv2.IMREAD_UNCHANGED)
    assert image is not None
    return image


def make_all() -> dict[str, Picture]:
    """One picture of every kind."""
    rng = np.random.default_rng(RNG_SEED)
    depth = rng.uniform(1, 3, (24, 32))
    depth[0, 0] = np.nan
    image = rng.integers(0, 256, (24, 32, 3), np.uint8)
    x = np.linspace(0, 1, 20)
    return {
        "images": plot_images({"color": image, "mask": image[..., 0] > 99}, columns=1),
        "depth": plot_depth(depth, title="depth", limits=(1, 3)),
        "comparison": plot_comparison(depth, depth + 0.001),
        "histogram": plot_histogram({"a": depth, "b": depth + 1}, label="m", log=True),
        "lines": plot_lines(x, {"a": x, "b": x**2 + 1}, x_label="m", y_label="mm", log_y=True),
        "cloud": plot_cloud(rng.uniform(0.5, 1, (200, 3))),
    }


@pytest.fixture(scope="module")
def figures() -> dict[str, Picture]:
    """Made once for all tests of this file."""
    return make_all()


@pytest.fixture(scope="module")
def figures_again() -> dict[str, Picture]:
    """Made a second time from the same data."""
    return make_all()


@pytest.mark.parametrize("name", NAMES)
def test_a_figure_shows_itself_and_is_the_same_every_time(
    figures: dict[str, Picture], figures_again: dict[str, Picture], name: str
) -> None:
    first, second = figures[name], figures_again[name]
    assert first.png == second.png
    data, metadata = first._repr_mimebundle_()
    assert data["image/png"].startswith(b"\x89PNG")
    assert 100 < metadata["image/png"]["width"] <= 720
    assert name in {"images", "depth"} or first.summary in repr(first)


@pytest.mark.parametrize("name", sorted(set(NAMES) - {"cloud"}))
def test_a_figure_has_a_transparent_ground_and_mid_gray_ink(
    figures: dict[str, Picture], name: str
) -> None:
    bgra = decode(figures[name])
    assert bgra.shape[2] == 4
    assert (bgra[..., 3] == 0).mean() > 0.05
    # The ink has a contrast of 4.5:1 and more on white and on the dark ground (#121212).
    ink = np.array(to_rgb(INK)[::-1])  # BGR
    opaque = bgra[bgra[..., 3] == 255][:, :3].astype(int)
    assert (np.abs(opaque - ink).max(axis=1) <= 2).any()


def to_rgb(color: str) -> tuple[int, int, int]:
    """Read a color as figures name it, ``#rrggbb``."""
    red, green, blue = bytes.fromhex(color.removeprefix("#"))
    return red, green, blue


def relative_luminance(rgb: tuple[int, int, int]) -> float:
    """WCAG 2 relative luminance of an sRGB color."""
    linear = [(c / 255 / 12.92) if c <= 10 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in rgb]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_the_ink_is_readable_on_both_grounds() -> None:
    ink = relative_luminance(to_rgb(INK))
    for ground in ((255, 255, 255), (18, 18, 18)):
        bright, dark = sorted((ink, relative_luminance(ground)), reverse=True)
        # WCAG asks 3:1 for graphics and large text; we want more for small labels.
        assert (bright + 0.05) / (dark + 0.05) > 4.2


def test_comparison_refuses_pictures_of_different_size() -> None:
    with pytest.raises(ValueError, match="truth: expected the size of ours"):
        plot_comparison(np.ones((3, 4)), np.ones((4, 3)))


@pytest.mark.parametrize(
    ("image", "words"),
    [
        (np.zeros((4, 5, 2)), r"images\['a'\]: expected shape \(H, W\), \(H, W, 3\) or"),
        (np.zeros(5), r"images\['a'\]: expected shape .*, got an array of shape \(5,\)"),
    ],
)
def test_what_is_no_picture_is_refused_by_its_title(image: np.ndarray, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        plot_images({"a": image})


def test_no_picture_at_all_is_refused() -> None:
    with pytest.raises(ValueError, match="images: expected at least one picture, got none"):
        plot_images({})


def test_a_curve_without_any_value_is_refused_by_its_name() -> None:
    lines = {"a": np.ones(2), "b": np.full(2, np.nan)}
    with pytest.raises(ValueError, match=r"lines\['b'\]: expected at least one finite value"):
        plot_lines(np.arange(2), lines, x_label="x", y_label="y")


def test_cloud_refuses_an_unknown_frame() -> None:
    with pytest.raises(ValueError, match="frame: expected 'camera' or 'world', got 'robot'"):
        plot_cloud(np.ones((3, 3)), frame="robot")


def test_the_world_frame_is_drawn_with_z_up() -> None:
    # A tall column of points in the world must come out taller than wide.
    column = np.random.default_rng(0).uniform(0, [0.1, 0.1, 1.0], (4000, 3))
    alpha = decode(plot_cloud(column, frame="world", axes=False, elevation_deg=0))[..., 3]
    rows, columns = np.nonzero(alpha)
    assert np.ptp(rows) > 2 * np.ptp(columns)


def test_the_nearest_point_is_on_top() -> None:
    K = np.array([[50.0, 0, 10], [0, 50.0, 10], [0, 0, 1]])
    points = np.array([[0, 0, 2.0], [0, 0, 1.0], [0, 0, 3.0], [0, 0, -1.0]])
    colors = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1.0]])
    drawn = render_points(points, colors, np.eye(4), K, (21, 21), point_size=3)
    assert_array_equal(drawn[10, 10], [0, 255, 0, 255])
    assert (drawn[..., 3] > 0).sum() == 9


def test_a_view_looks_at_its_target() -> None:
    eye, target = np.array([1.0, -2, 0.5]), np.array([0.2, 0.1, 3])
    T = make_look_at(eye, target, np.array([0, -1.0, 0]))
    in_view = T @ np.append(target, 1)
    assert_allclose(in_view[:2], 0, rtol=0, atol=1e-12)
    assert in_view[2] > 0
    with pytest.raises(ValueError, match="expected a view that is not along"):
        make_look_at(eye, eye, np.array([0, -1.0, 0]))


def test_a_view_point_lies_behind_and_above_and_farther_from_the_middle_than_most_points() -> None:
    points = np.random.default_rng(1).uniform([-1, -1, 1], [1, 1, 2], (500, 3))
    target, eye = get_view_point(points)
    assert eye[2] < target[2]
    assert eye[1] < target[1]  # y is down: smaller is above
    distances = np.linalg.norm(points - target, axis=1)
    assert (distances < np.linalg.norm(eye - target)).mean() > 0.9


@pytest.mark.parametrize("point_size", [1, 2, 3, 4])
def test_a_cloud_and_its_mirror_image_are_drawn_as_mirror_images(point_size: int) -> None:
    # With the middle at W/2 instead of (W-1)/2, all would lie half a pixel to the right and below.
    half = np.random.default_rng(6).uniform(0.02, 0.3, (4000, 3))
    points = np.concatenate([half * [x, y, 1] for x in (1, -1) for y in (1, -1)])
    points[:, 2] += 1
    look: dict[str, Any] = {
        "azimuth_deg": 0,
        "elevation_deg": 0,
        "axes": False,
        "point_size": point_size,
    }
    drawn = decode(plot_cloud(points, np.ones(points.shape), **look))[..., 3] > 0
    assert drawn.shape == (1000, 1440)
    assert 0.003 < drawn.mean() < 0.9
    for mirrored in (drawn[:, ::-1], drawn[::-1]):
        # A point in the middle between two pixels may fall to either. The rival, W/2, differs in
        # 0.7 % of the pixels and more.
        assert (mirrored != drawn).mean() < 1e-4


def test_visualize_pointcloud_without_a_screen_gives_a_picture_with_the_cloud_in_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setattr("labutils.cloud_view._has_screen", lambda: False)
    points = np.random.default_rng(0).uniform([-0.5, -0.5, 1], [0.5, 0.5, 2], (20_000, 3))
    red = np.tile([1.0, 0.0, 0.0], (len(points), 1))
    picture = visualize_pointcloud(points, red)
    assert isinstance(picture, Picture)
    bgr = decode(picture)[..., :3].astype(int)
    # Bright red, drawn as it is: no tone mapping, no shading.
    assert ((bgr[..., 2] > 200) & (bgr[..., :2].max(axis=-1) < 60)).mean() > 0.05


def test_visualize_pointcloud_without_open3d_draws_by_itself(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("labutils.cloud_view.find_open3d_problem", lambda: "not installed")
    picture = visualize_pointcloud(np.random.default_rng(0).uniform(1, 2, (500, 3)))
    assert isinstance(picture, Picture)
    assert "point cloud of 500 points" in picture.summary


def test_visualize_pointcloud_without_a_vulkan_driver_draws_by_itself(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fail(*_: object) -> NoReturn:
        raise RuntimeError("Failed to load vulkan library!")

    monkeypatch.setattr("labutils.cloud_view._has_screen", lambda: False)
    monkeypatch.setattr("labutils.cloud_view._draw_off_screen", fail)
    picture = visualize_pointcloud(np.random.default_rng(0).uniform(1, 2, (500, 3)))
    assert isinstance(picture, Picture)
    assert "point cloud of 500 points" in picture.summary


@pytest.mark.parametrize("version", ["0.18.0", "0.19.0+1e7b174"])
def test_visualize_pointcloud_with_an_open3d_that_needs_a_screen_draws_by_itself(
    monkeypatch: pytest.MonkeyPatch, version: str
) -> None:
    def end(*_: object) -> NoReturn:
        pytest.fail("in these versions this ends the process")

    open3d = SimpleNamespace(__version__=version)
    monkeypatch.setitem(sys.modules, "open3d", open3d)
    monkeypatch.delenv("EGL_PLATFORM", raising=False)
    monkeypatch.setattr("labutils.cloud_view.find_open3d_problem", lambda: None)
    monkeypatch.setattr("labutils.cloud_view._has_screen", lambda: False)
    monkeypatch.setattr("labutils.cloud_view._draw_off_screen", end)
    picture = visualize_pointcloud(np.random.default_rng(0).uniform(1, 2, (500, 3)))
    assert isinstance(picture, Picture)
    assert "point cloud of 500 points" in picture.summary


def test_visualize_pointcloud_opens_a_window_where_there_is_a_screen(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    shown = []
    monkeypatch.setattr("labutils.cloud_view.find_open3d_problem", lambda: None)
    monkeypatch.setattr("labutils.cloud_view._has_screen", lambda: True)
    monkeypatch.setattr("labutils.cloud_view._show_window", lambda *given: shown.append(given))
    assert visualize_pointcloud(np.ones((2, 3))) is None
    assert len(shown) == 1


@pytest.mark.parametrize(
    ("points", "colors", "words"),
    [
        (np.empty((0, 3)), None, "points: expected at least one point"),
        (np.ones((4, 2)), None, r"points: expected shape \(N, 3\)"),
        (np.ones((4, 3)), np.ones((3, 3)), r"colors: expected one per point \(4\), got 3"),
        (np.ones((4, 3)), 255 * np.ones((4, 3)), "colors: expected 0 to 1, got 255 to 255"),
    ],
)
def test_visualize_pointcloud_of_bad_input_says_why(
    points: np.ndarray, colors: np.ndarray | None, words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        visualize_pointcloud(points, colors)


@pytest.mark.parametrize("name", ["comparison", "depth", "images"])
def test_no_title_or_label_is_cut_off_at_the_edge(figures: dict[str, Picture], name: str) -> None:
    alpha = decode(figures[name])[..., 3]
    assert alpha[0].max() == 0
    assert alpha[-1].max() == 0


def test_titles_stand_whole_above_wide_pictures() -> None:
    # the pictures of the book: 4:3, so that titles and color bars fight for the height
    depth = np.random.default_rng(RNG_SEED).uniform(1, 3, (240, 320))
    rgb = np.zeros((240, 320, 3), np.uint8)
    for picture in (
        plot_comparison(depth, depth + 0.001),
        plot_images({"one": rgb, "two": rgb}),
        plot_images({"one": rgb, "two": rgb, "three": rgb}),
        plot_depth(depth, title="depth"),
    ):
        assert decode(picture)[0, :, 3].max() == 0
