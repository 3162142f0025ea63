"""The tables of the stereo chapter: limits that hold, and numbers that can be measured again."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from labutils import is_gl_available
from labutils.room import make_room
from labutils.room.designs import DESIGNS
from labutils.room.recorder import BASELINES, VIEWS, hash_textures
from tools.measure import stereo, stereo_table

#: Shares that may be missing or off by more than 2 pixels, of what both eyes see.
LIMITS = {stereo.SGBM: 0.05, stereo.SSD: 0.11}
#: How far theory and measurement may be apart, and how much worse the held-out room may be.
DEPTH_LIMIT, HELD_OUT_LIMIT = 0.20, 1.3


@pytest.fixture(scope="module")
def numbers() -> dict[str, Any]:
    return json.loads(stereo_table.NUMBERS.read_text(encoding="utf-8"))


def get_share(room: dict[str, Any], method: str) -> float:
    return room["methods"][method]["regions"][stereo.SEEN]["not_correct"][0]


def assert_limits_hold(rooms: dict[str, Any]) -> None:
    """What the chapter promises; the held-out room may be a little worse, or better."""
    for method, limit in LIMITS.items():
        assert get_share(rooms["room"], method) <= limit
        assert get_share(rooms["held_out"], method) <= HELD_OUT_LIMIT * get_share(
            rooms["room"], method
        )
    for name, room in rooms.items():
        ratios = [row["rmse"][0] / row["theory"][0] for row in room["baselines"]]
        worst = max(abs(ratio - 1) for ratio in ratios)
        assert worst <= DEPTH_LIMIT * (HELD_OUT_LIMIT if name == "held_out" else 1)


def test_the_numbers_keep_to_the_limits(numbers: dict[str, Any]) -> None:
    assert_limits_hold(numbers["rooms"])
    assert numbers["views"] == len(VIEWS) >= 6
    assert numbers["seeds"] == len(stereo.SEEDS) >= 5
    for room in numbers["rooms"].values():
        assert [row["baseline"] for row in room["baselines"]] == list(BASELINES)


def test_the_page_shows_these_numbers(numbers: dict[str, Any]) -> None:
    assert stereo_table.TABLE.read_text(encoding="utf-8") == stereo_table.make_page(numbers)


def test_the_numbers_are_those_of_this_script_and_these_rooms(numbers: dict[str, Any]) -> None:
    again = "measure again: python -m tools.measure.stereo_table"
    assert numbers["script_sha256"] == stereo_table.hash_script(), again
    found = {name: hash_textures(make_room(name)[0]) for name in DESIGNS}
    assert numbers["textures_sha256"] == found, again


def test_regions_tell_what_fails_where(numbers: dict[str, Any]) -> None:
    regions = numbers["rooms"]["room"]["methods"][stereo.SSD]["regions"]
    share = {name: score["not_correct"][0] for name, score in regions.items()}
    assert share["textured, no edge near"] < 0.03
    for hard in ("no texture (panel)", "repeated texture (wallpaper)", "near edges"):
        assert share[hard] > 10 * share["textured, no edge near"], hard
    assert share["hidden from the right eye"] > 0.8


def test_every_disparity_up_to_the_nearest_thing_is_searched() -> None:
    assert stereo.count_disparities(433.0, 0.10) == 112  # 96.2, and OpenCV wants sixteens
    assert stereo.count_disparities(433.0, 0.02) == 32


def test_a_spread_is_a_mean_and_a_deviation() -> None:
    assert stereo_table.spread({0: 1.0, 1: 3.0}) == [2.0, pytest.approx(math.sqrt(2), rel=1e-5)]
    assert stereo_table.spread({7: 0.5}) == [0.5, 0.0]


@pytest.mark.parametrize("method", [stereo.match_bm, stereo.match_sgbm])
def test_widened_pictures_lose_no_column(method: stereo.Matcher) -> None:
    rng = np.random.default_rng(1)
    right = rng.integers(0, 256, (60, 200), np.uint8)
    left = np.roll(right, 5, axis=1)
    found = method(left, right, 32)
    assert found.shape == left.shape
    assert np.isfinite(found[20:40, 12:32]).mean() > 0.8
    assert np.nanmedian(found) == pytest.approx(5, abs=0.1)
    assert np.isnan(stereo.match_sgbm_narrow(left, right, 32)[:, :32]).all()


def collect_leaves(value: Any, path: str = "") -> Iterator[tuple[str, float]]:
    """List all numbers of nested lists and dictionaries by their places."""
    if isinstance(value, dict):
        for key, below in value.items():
            yield from collect_leaves(below, f"{path}/{key}")
    elif isinstance(value, list):
        for number, below in enumerate(value):
            yield from collect_leaves(below, f"{path}/{number}")
    else:
        yield path, float(value)


def is_far(path: str, before: float, after: float) -> bool:
    """Tell whether a mean has moved; a little is normal, where another driver draws edges."""
    is_deviation = path.endswith("/1")
    is_length = "/rmse/" in path or "/theory/" in path
    return not is_deviation and abs(after - before) > 0.1 * before + (0 if is_length else 0.01)


@pytest.mark.slow
@pytest.mark.skipif(not is_gl_available(), reason="needs OpenGL: the ray caster draws no textures")
def test_measuring_again_gives_the_same_numbers(
    request: pytest.FixtureRequest, numbers: dict[str, Any]
) -> None:
    found = stereo_table.measure()
    assert_limits_hold(found["rooms"])
    before = dict(collect_leaves(numbers["rooms"]))
    after = dict(collect_leaves(found["rooms"]))
    assert before.keys() == after.keys()
    far = {
        path: (value, after[path])
        for path, value in before.items()
        if is_far(path, value, after[path])
    }
    assert not far
    if request.config.getoption("--record-slow"):
        stereo_table.write(found)
