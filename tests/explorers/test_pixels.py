"""A pixel outside the picture is refused alike by every explorer in which one is picked."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import traitlets

from labutils import make_scene
from labutils.explorers import (
    explore_cloud,
    explore_depth_range,
    explore_hsv,
    explore_matching,
    explore_scene,
    explore_stereo,
)
from labutils.explorers._base import PixelExplorer, PixelView, read_size
from tools.explorer_views import find_view_classes

WIDTH, HEIGHT = 9, 6
RGB = np.random.default_rng(1).integers(0, 256, (HEIGHT, WIDTH, 3), np.uint8)
DEPTH = np.random.default_rng(2).uniform(0.5, 2.0, (HEIGHT, WIDTH))
MATRIX = np.array([[11.0, 0, 4.0], [0, 11.0, 2.5], [0, 0, 1]])

MAKERS: dict[str, Callable[[], PixelExplorer]] = {
    "CloudView": lambda: explore_cloud(RGB, DEPTH, MATRIX),
    "DepthRangeView": lambda: explore_depth_range(DEPTH, clip=(0.02, 12.0)),
    "HsvView": lambda: explore_hsv(RGB),
    "MatchingView": lambda: explore_matching(RGB, RGB, K=MATRIX, baseline=0.1),
    "SceneView": lambda: explore_scene(*make_scene(), width=WIDTH, height=HEIGHT),
    "StereoView": lambda: explore_stereo(RGB, DEPTH, MATRIX),
}


@pytest.fixture(params=MAKERS)
def explorer(request: pytest.FixtureRequest) -> PixelExplorer:
    return MAKERS[request.param]()


def test_every_view_with_a_pixel_is_tried_here() -> None:
    with_pixel = {one.__name__ for one in find_view_classes() if "pixel" in one.class_traits()}
    assert with_pixel == set(MAKERS)


@pytest.mark.parametrize(
    "pixel", [[99, 99], [WIDTH, 0], [0, HEIGHT], [-1, 0], [0, -1], [3], [1, 2, 3]]
)
def test_a_pixel_outside_is_refused_by_name_and_the_old_one_stays(
    explorer: PixelExplorer, pixel: list[int]
) -> None:
    explorer.move(pixel=[2, 3])
    before = explorer.values
    with pytest.raises(traitlets.TraitError) as refused:
        explorer.move(pixel=pixel)
    said = f"pixel: expected (u, v) within {WIDTH} x {HEIGHT} pixels, got list {pixel}"
    assert str(refused.value) == said
    assert explorer.pixel == (2, 3)
    assert explorer.values == before


def test_every_pixel_of_the_picture_can_be_picked(explorer: PixelExplorer) -> None:
    for u in range(WIDTH):
        for v in range(HEIGHT):
            explorer.move(pixel=[u, v])
            assert explorer.pixel == (u, v)
            assert explorer.values


def test_a_fraction_is_no_pixel(explorer: PixelExplorer) -> None:
    with pytest.raises(traitlets.TraitError):
        explorer.move(pixel=[1.5, 2])


def test_no_pixel_can_be_picked_again(explorer: PixelExplorer) -> None:
    explorer.move(pixel=[2, 3])
    explorer.move(pixel=[])
    assert explorer.pixel is None


def test_a_view_without_its_picture_takes_no_pixel() -> None:
    class Empty(PixelView):
        PICTURE = "png"
        png = traitlets.Bytes()

    with pytest.raises(traitlets.TraitError, match="png: expected the bytes of a PNG file, got 0"):
        Empty(pixel=[0, 0])


def test_the_size_is_read_from_the_header(explorer: PixelExplorer) -> None:
    view = explorer.view
    assert view.picture_size == (WIDTH, HEIGHT)
    assert read_size(getattr(view, view.PICTURE)[:24]) == (WIDTH, HEIGHT)
