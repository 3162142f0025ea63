"""The matching view on a page of its own: what one points at is marked, and sets nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from labutils.explorers import MatchingExplorer, explore_matching
from labutils.recordings import load_recording
from labutils.stereo import depth_to_disparity
from tests.helpers.view_page import write_view_page

#: A part of the recorded view, as in tests/explorers/test_matching.py.
PART = np.s_[20:220, 60:480]
POLE = (395, 140)
LONGEST = 64


@pytest.fixture(scope="module")
def explorer() -> MatchingExplorer:
    pair = load_recording("room").pairs[0]
    truth = depth_to_disparity(pair.depth, pair.K, pair.baseline)
    return explore_matching(
        pair.left[PART],
        pair.right[PART],
        K=pair.K,
        baseline=pair.baseline,
        truth=truth[PART],
        max_disparity=LONGEST,
        pixel=(220, 110),
        places={"pole": POLE},
    )


@pytest.fixture(scope="module")
def seen(
    explorer: MatchingExplorer,
    tmp_path_factory: pytest.TempPathFactory,
    chromium: Callable[..., Any],
) -> dict[str, Any]:
    folder = tmp_path_factory.mktemp("matching")
    write_view_page(explorer.view, folder / "matching.html")
    found: dict[str, Any] = chromium("matching.mjs", folder.as_uri() + "/")
    return found


def compute(explorer: MatchingExplorer, **values: Any) -> dict[str, Any]:
    """What labutils computes for other values; the explorer stays as it was."""
    before = {name: getattr(explorer.view, name) for name in explorer.view.PARAMETERS}
    explorer.move(**values)
    found = explorer.values
    explorer.move(**before)
    return found


def check_box(box: list[float] | None, u: float, v: float, window: int) -> None:
    """Check that a frame lies around a window; the browser rounds to whole pixels of its own."""
    reach = window // 2
    assert box == pytest.approx([u - reach, v - reach, window, window], abs=1)


def test_pointing_sets_nothing_and_tells_no_kernel(seen: dict[str, Any]) -> None:
    assert seen["complaints"] == []
    for name in ("pointed", "curve", "keys"):
        assert seen[name]["values"] == seen["first"]["values"]
        assert seen[name]["saves"] == seen["first"]["saves"]
    assert seen["left"] == seen["first"]


def test_the_frames_lie_around_the_windows_that_are_compared(seen: dict[str, Any]) -> None:
    values = seen["first"]["values"]
    left, true, found, pointed = seen["first"]["boxes"]
    check_box(left, 220, 110, 9)
    # the strip has 60 of 200 rows, and shows the chosen one in its middle
    check_box(found, 220 - values["disparity"], 30, 9)
    check_box(true, 220 - values["truth"], 30, 9)
    assert pointed is None
    assert seen["first"]["search"]


def test_a_pixel_that_is_pointed_at_has_its_own_match(
    seen: dict[str, Any], explorer: MatchingExplorer
) -> None:
    values = compute(explorer, pixel=[250, 150])
    found = seen["pointed"]
    check_box(found["boxes"][0], 250, 150, 9)
    check_box(found["boxes"][2], 250 - values["disparity"], 30, 9)
    assert found["text"].startswith(f"Pixel (250, 150): {values['subpixel']:.2f} px")
    off = abs(values["error_px"])
    assert found["tag"] == f"{values['subpixel']:.1f} px, off by {off:.1f} px"
    assert f"{values['subpixel']:.2f} px" in found["closeUp"]


def test_a_disparity_on_the_curve_has_its_window_and_its_cost(
    seen: dict[str, Any], explorer: MatchingExplorer
) -> None:
    chosen = int((0.5 * 320 - 50) / 258 * LONGEST)
    cost = explorer.costs[chosen] / 81
    found = seen["curve"]
    assert found["chosen"] == f"{chosen} px: {cost:,.0f} per pixel"
    check_box(found["boxes"][3], 220 - chosen, 30, 9)
    assert found["captions"][1:3] == [f"at {chosen} px", f"SSD {cost:,.0f}"]
    assert seen["keys"]["chosen"] == f"1 px: {explorer.costs[1] / 81:,.0f} per pixel"


def test_a_place_is_one_press_away(seen: dict[str, Any], explorer: MatchingExplorer) -> None:
    values = compute(explorer, pixel=list(POLE))
    assert seen["place"]["pixel"] == list(POLE)
    assert seen["saves"] == 1
    assert seen["place"]["values"]["costs"] == values["costs"]
    sides = [
        side for side, error in zip(range(3, 32, 2), values["errors_px"], strict=True) if error <= 1
    ]
    assert seen["place"]["right"] == sides
    assert 0 < len(sides) < 10


def test_the_page_shows_and_matches_the_noise_that_labutils_adds(
    seen: dict[str, Any], explorer: MatchingExplorer
) -> None:
    explorer.move(noise=7)
    left, right = explorer.view.make_pictures()
    explorer.move(noise=0)
    shown_left, strip = seen["pictures"]
    np.testing.assert_array_equal(shown_left["gray"], left.ravel())
    first = POLE[1] - 30
    np.testing.assert_array_equal(strip["gray"], right[first : first + 60].ravel())
    values = compute(explorer, noise=7, search=20, pixel=list(POLE))
    assert seen["noisy"]["values"]["costs"] == values["costs"]


def test_a_window_beyond_the_picture_has_no_match_to_show(seen: dict[str, Any]) -> None:
    edge = seen["edge"]
    assert edge["text"] == "Pixel (2, 3): the window reaches beyond the picture."
    assert edge["values"]["disparity"] is None
    assert edge["boxes"][2] is None
    assert edge["search"] is False
    assert edge["captions"][:3] == ["none"] * 3
    assert edge["closeUp"].endswith("no window")
