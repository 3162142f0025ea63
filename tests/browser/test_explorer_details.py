"""One ray in two pictures, goals, names that stay at their curves, own pictures of any shape."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import pytest

SHAPES = {"dot.png": (1, 1), "line.png": (2000, 20), "pole.png": (20, 2000), "long.png": (9000, 3)}
RED = (200, 30, 20)  # selected by the limits of the page
FOV_X = 2 * math.atan(math.tan(math.radians(45 / 2)) * 4 / 3)


@pytest.fixture(scope="module")
def seen(
    chromium: Callable[..., Any], file_site: str, tmp_path_factory: pytest.TempPathFactory
) -> dict[str, Any]:
    """What followed while the explorers were used."""
    folder = tmp_path_factory.mktemp("pictures")
    for name, (width, height) in SHAPES.items():
        cv2.imwrite(str(folder / name), np.full((height, width, 3), RED[::-1], np.uint8))
    return chromium("explorer_details.mjs", file_site, folder)


def angle_of(ray: str) -> float:
    """Read how far a drawn ray leans to the right, in degrees."""
    from_x, from_y, to_x, to_y = (float(one) for one in re.findall(r"-?[\d.]+", ray))
    return math.degrees(math.atan2(to_x - from_x, from_y - to_y))


def test_a_pixel_that_is_pointed_at_is_a_ray_in_the_drawing_and_in_words(
    seen: dict[str, Any],
) -> None:
    first, pointed = seen["ray"]["first"], seen["ray"]["picture"]
    assert (first["ray"], first["column"], first["mark"]) == ("", False, False)
    right = math.degrees(math.atan(-0.5 * math.tan(FOV_X / 2)))  # a quarter from the left
    assert angle_of(pointed["ray"]) == pytest.approx(right, abs=0.3)
    found = re.search(r"Pixel \((\d+), (\d+)\) looks ([\d.]+)° to the left", pointed["told"])
    assert found
    assert int(found[1]) == pytest.approx(160, abs=2)
    assert int(found[2]) == pytest.approx(360, abs=2)
    assert float(found[3]) == pytest.approx(-right, abs=0.3)


def test_the_same_pixel_is_another_ray_at_another_angle(seen: dict[str, Any]) -> None:
    narrow, wide = seen["ray"]["picture"], seen["ray"]["wider"]
    assert wide["column"] == narrow["column"]
    assert angle_of(wide["ray"]) < angle_of(narrow["ray"])


def test_a_direction_in_the_drawing_is_a_column_of_the_picture(seen: dict[str, Any]) -> None:
    drawing = seen["ray"]["drawing"]
    assert float(drawing["column"].rstrip("%")) == pytest.approx(50, abs=1)
    assert drawing["mark"] is False  # seen from above a ray has no row
    assert "Column 3" in drawing["told"]


def test_nothing_is_marked_when_nothing_is_pointed_at_and_keys_point_too(
    seen: dict[str, Any],
) -> None:
    away, keys = seen["ray"]["away"], seen["ray"]["keys"]
    assert (away["ray"], away["column"], away["mark"]) == ("", False, False)
    assert angle_of(keys["ray"]) > 0
    assert "Pixel (336, 240)" in keys["told"]


def test_a_goal_says_how_far_it_is_that_it_is_reached_and_that_it_was(seen: dict[str, Any]) -> None:
    steps = seen["goal"]["seen"]
    assert [one["state"] for one in steps] == ["open", "open", "reached", "before", "reached"]
    assert [one["mark"] for one in steps] == ["", "", "Reached", "Reached before", "Reached"]
    widths = [float(one["bar"].rstrip("%")) for one in steps]
    assert 0 == widths[0] < widths[1] < widths[2] == 100 > widths[3]
    assert re.fullmatch(r"angle to spare 4\.6° \(0\.0 to 1\.0\)", steps[0]["told"])


def test_a_goal_is_announced_once_and_moves_nothing(seen: dict[str, Any]) -> None:
    steps = seen["goal"]["seen"]
    assert [bool(one["spoken"]) for one in steps] == [False, False, True, True, True]
    assert len({one["spoken"] for one in steps[2:]}) == 1
    assert len({one["height"] for one in steps}) == 1
    assert seen["goal"]["without"] is False  # an empty goal is none


def test_dragging_the_point_selects_no_text(seen: dict[str, Any]) -> None:
    assert seen["convention"]["selected"] == ""


@pytest.mark.parametrize("planes", ["0.02 to 12", "1 to 2", "0.2 to 100"])
def test_every_name_stays_at_its_curve(seen: dict[str, Any], planes: str) -> None:
    found = seen["convention"]["planes"][planes]
    assert set(found) == {"true", "linear", "reversed"}
    for name, place in found.items():
        assert place["distance"] < 0.06, name
        assert place["inside"], name


@pytest.mark.parametrize("name", SHAPES)
def test_an_own_picture_of_any_shape_is_seen_and_moves_nothing(
    seen: dict[str, Any], name: str
) -> None:
    scene, own = seen["own"]["scene"], seen["own"][name]
    assert own["color"] == [*RED, 255]
    for side, room in zip(own["shown"], scene["place"], strict=True):
        assert 0.14 * room < side <= room + 1
    assert (own["place"], own["box"]) == (scene["place"], scene["box"])
    assert math.prod(own["pixels"]) <= 640 * 480


def test_of_a_long_picture_the_short_side_keeps_its_pixels(seen: dict[str, Any]) -> None:
    assert seen["own"]["line.png"]["pixels"] == [2000, 20]
    assert seen["own"]["pole.png"]["pixels"] == [20, 2000]


def test_a_tiny_picture_shows_its_pixels_as_squares(seen: dict[str, Any]) -> None:
    assert seen["own"]["dot.png"]["rendering"] == "pixelated"
    assert seen["own"]["scene"]["rendering"] == "auto"


def test_only_the_scene_has_a_goal_because_only_its_truth_is_known(seen: dict[str, Any]) -> None:
    own = seen["own"]
    for place in ("scene", "back"):
        assert own[place]["isGoalShown"]
        assert 0 < own[place]["iou"] < 1
    assert not own["dot.png"]["isGoalShown"]
    assert own["dot.png"]["iou"] is None


def test_using_them_raises_no_error(seen: dict[str, Any]) -> None:
    assert [one["complaints"] for one in seen.values()] == [[]] * 4
