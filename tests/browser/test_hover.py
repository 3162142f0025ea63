"""What a reader points at in depth range and stereo is marked in every other picture."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labutils import get_camera_intrinsics, make_renderer, make_scene
from labutils.camera_utils import render_camera
from labutils.explorers import explore_depth_range, explore_stereo
from labutils.explorers._depth_picture import decode_steps
from labutils.explorers.depth_range import BINS, DepthRangeExplorer
from labutils.explorers.stereo import StereoExplorer
from tests.helpers.view_page import write_view_page

CLIP = (0.02, 12.0)


@pytest.fixture(scope="module")
def depth_range() -> DepthRangeExplorer:
    model, data = make_scene()
    with make_renderer(model, 60, 80) as renderer:
        _, depth = render_camera(model, data, renderer, "head_camera")
    return explore_depth_range(depth, clip=CLIP)


@pytest.fixture(scope="module")
def stereo() -> StereoExplorer:
    model, data = make_scene()
    with make_renderer(model, 240, 320) as renderer:
        rgb, depth = render_camera(model, data, renderer, "left_eye")
    K, _ = get_camera_intrinsics(model, "left_eye", 320, 240)
    return explore_stereo(rgb, depth, K)


@pytest.fixture(scope="module")
def seen(
    depth_range: DepthRangeExplorer,
    stereo: StereoExplorer,
    tmp_path_factory: pytest.TempPathFactory,
    chromium: Callable[..., Any],
) -> dict[str, Any]:
    folder: Path = tmp_path_factory.mktemp("hover")
    write_view_page(depth_range.view, folder / "depth_range.html")
    write_view_page(stereo.view, folder / "stereo.html")
    found: dict[str, Any] = chromium("hover.mjs", folder.as_uri() + "/")
    return found


def read_x(line: str) -> float:
    """Place of an upright line in a drawing."""
    return float(line.removeprefix("M").split()[0])


def test_pointing_raises_no_error_and_tells_no_kernel(seen: dict[str, Any]) -> None:
    for one in (seen["depth"], seen["stereo"]):
        assert one["complaints"] == []
        assert one["pointed"]["saves"] == one["first"]["saves"]
        assert one["pointed"]["pixel"] == one["first"]["pixel"]
        assert one["pointed"]["values"] == one["first"]["values"]


@pytest.mark.parametrize(("name", "pixel"), [("pointed", [30, 50]), ("other", [60, 20])])
def test_a_pixel_pointed_at_is_marked_on_color_bar_and_both_histograms(
    seen: dict[str, Any], depth_range: DepthRangeExplorer, name: str, pixel: list[int]
) -> None:
    depth_range.move(pixel=pixel)
    values = depth_range.values
    depth_range.move(pixel=[])
    found = seen["depth"][name]
    assert found["tag"] == f"{values['pixel_depth']:.3f} m"
    assert f"Pixel ({pixel[0]}, {pixel[1]}): {values['pixel_depth']:.4f} m" in found["text"]
    assert float(found["barMark"].rstrip("%")) == pytest.approx(20 * values["pixel_depth"])
    # the plots are 320 wide, with 44 to the left of the axis and 12 to its right
    metric, raw = (read_x(line) for line in found["lines"])
    assert metric == pytest.approx(44 + 264 * values["pixel_depth"] / 5, abs=0.01)
    assert raw == pytest.approx(44 + 264 * values["pixel_raw"], abs=0.01)


def test_a_pixel_without_surface_or_outside_the_range_says_so(seen: dict[str, Any]) -> None:
    window, narrow = seen["depth"]["window"], seen["depth"]["narrow"]
    assert window["tag"] == "no surface"
    assert (window["kinds"], window["barMark"]) == (["no surface"], False)
    assert narrow["tag"].endswith("m, nearer than the range")
    assert (narrow["kinds"], narrow["barMark"]) == (["nearer"], False)


def test_nothing_is_marked_once_the_pointer_has_left(seen: dict[str, Any]) -> None:
    left = seen["depth"]["left"]
    assert (left["tag"], left["lines"], left["barMark"], left["lit"]) == (
        None,
        ["", ""],
        False,
        None,
    )
    assert "Pixel" not in left["text"]
    assert seen["stereo"]["left"] == {
        **seen["stereo"]["first"],
        "drawMs": seen["stereo"]["left"]["drawMs"],
    }


def test_keys_mark_the_same_as_the_pointer(seen: dict[str, Any]) -> None:
    keys = seen["depth"]["keys"]
    assert keys["pixel"] == [41, 30]
    assert all(keys["lines"])
    assert keys["barMark"]
    assert "Pixel (41, 30)" in keys["text"]


def test_a_bar_of_the_histogram_lights_up_its_pixels(
    seen: dict[str, Any], depth_range: DepthRangeExplorer
) -> None:
    steps = decode_steps(depth_range.view.depth_png).ravel()
    bar = seen["depth"]["bar"]
    chosen = int((0.35 * 320 - 44) / 264 * BINS)
    low, high = chosen / 10, (chosen + 1) / 10
    expected = np.flatnonzero((steps >= 5000 * low) & (steps < 5000 * high))
    np.testing.assert_array_equal(bar["lit"], expected)
    assert len(expected) == depth_range.values["metric_bins"][chosen] > 0
    assert bar["sliders"][0].startswith(f"{low:.1f} to {high:.1f} m: ")


def test_the_last_bar_of_the_raw_buffer_lights_up_most_of_the_picture(
    seen: dict[str, Any], depth_range: DepthRangeExplorer
) -> None:
    lit = len(seen["depth"]["lastRaw"]["lit"])
    assert lit == depth_range.values["raw_bins"][-1]
    assert lit > 0.6 * depth_range.values["surfaces"]
    assert seen["depth"]["beside"]["lit"] is None


def test_bars_can_be_chosen_by_keys_and_let_go_again(
    seen: dict[str, Any], depth_range: DepthRangeExplorer
) -> None:
    counts = depth_range.values["metric_bins"]
    first = int(np.argmax(counts))
    assert len(seen["depth"]["keyBar"]["lit"]) == counts[first]
    assert len(seen["depth"]["nextBar"]["lit"]) == counts[first + 1]
    assert seen["depth"]["escaped"]["lit"] is None
    assert seen["depth"]["escaped"]["sliders"] == ["none chosen"] * 2


@pytest.mark.parametrize(("name", "pixel"), [("pointed", [250, 30]), ("near", [100, 220])])
def test_a_pixel_pointed_at_has_its_match_in_the_strip_and_a_place_on_the_curve(
    seen: dict[str, Any], stereo: StereoExplorer, name: str, pixel: list[int]
) -> None:
    start = stereo.pixel
    assert start is not None
    stereo.move(pixel=pixel)
    values = stereo.values
    stereo.move(pixel=list(start))
    found = seen["stereo"][name]
    assert found["tag"] == f"{values['depth']:.3f} m, {values['disparity']:.1f} px"
    for left in found["squares"]:  # in the left picture, and in the strip below it
        assert float(left.rstrip("%")) == pytest.approx((values["u_right"] + 0.5) / 3.2)
    assert len(found["squares"]) == 2
    # both axes are logarithmic: two powers of ten of meters, five of millimeters
    across, up = (float(one) for one in found["point"])
    assert across == pytest.approx(66 + 242 * (np.log10(values["depth"]) + 1) / 2, abs=0.01)
    assert up == pytest.approx(150 - 124 * (np.log10(values["error_mm"]) + 1) / 5, abs=0.01)


def test_a_depth_on_the_curve_lights_up_the_pixels_that_have_it(
    seen: dict[str, Any], stereo: StereoExplorer
) -> None:
    steps = decode_steps(stereo.view.depth_png).ravel()
    for name in ("curve", "keys"):
        found = seen["stereo"][name]
        middle = float(found["sliders"][0].split(" m")[0])
        lit = steps[found["lit"]] * 0.0002
        assert lit.size > 0
        assert lit.min() > middle / 1.05
        assert lit.max() < middle * 1.05
    assert seen["stereo"]["away"]["lit"] is None
