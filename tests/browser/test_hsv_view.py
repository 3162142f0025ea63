"""The HSV view on a page of its own: the ring turns, and the reader's picture stays on the page."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import pytest

from labutils.explorers import explore_hsv
from tests.helpers.view_page import write_view_page

RED = ((170, 120, 50), (6, 255, 255))


@pytest.fixture(scope="module")
def scene() -> np.ndarray:
    """Draw a red square on gray, wider than high."""
    picture = np.full((120, 160, 3), 90, np.uint8)
    picture[20:60, 30:70] = (200, 20, 30)
    return picture


@pytest.fixture(scope="module")
def own() -> np.ndarray:
    """Draw a red disc, higher than wide: it fits into the scene's place as it is."""
    picture = np.full((110, 60, 3), 240, np.uint8)
    cv2.circle(picture, (25, 70), 18, (180, 10, 20), -1)
    return picture


@pytest.fixture(scope="module")
def used(
    scene: np.ndarray,
    own: np.ndarray,
    chromium: Callable[..., Any],
    tmp_path_factory: pytest.TempPathFactory,
) -> dict[str, Any]:
    """What happened while the view was used from a file."""
    folder = tmp_path_factory.mktemp("hsv")
    write_view_page(explore_hsv(scene, RED).view, folder / "hsv.html")
    cv2.imwrite(str(folder / "own.png"), own[..., ::-1])
    return chromium("hsv.mjs", folder.as_uri() + "/", "hsv", folder / "own.png")


def test_the_view_alone_tells_what_labutils_computes(
    used: dict[str, Any], scene: np.ndarray
) -> None:
    assert used["first"]["values"] == explore_hsv(scene, RED).values


def test_overlay_mask_and_picture_show_what_is_selected_and_a_cross(used: dict[str, Any]) -> None:
    red, gray, dim = [200, 20, 30, 255], [90, 90, 90, 255], [36, 36, 36, 255]
    white, black = [255] * 4, [0, 0, 0, 255]
    assert used["drawn"] == [
        [red, dim, dim, white],
        [white, black, black, white],
        [red, gray, gray, white],
    ]


@pytest.mark.parametrize(
    ("step", "hues"),
    [
        ("start", (170, 6)),
        ("ArrowRight", (171, 6)),
        ("ArrowUp", (172, 6)),
        ("PageUp", (2, 6)),  # hue is a circle
        ("Home", (0, 6)),
        ("ArrowLeft", (179, 6)),
        ("PageDown", (169, 6)),
        ("End", (179, 6)),
        ("x", (179, 6)),
        ("drag the inner end", (179, 100)),
        ("move on", (179, 100)),
        ("click on the ring", (165, 100)),
        ("click in the middle", (165, 100)),
    ],
)
def test_the_ring_moves_both_hues_by_keyboard_and_by_pointer(
    used: dict[str, Any], step: str, hues: tuple[int, int]
) -> None:
    low, high = hues
    lit = high - low + 1 if low <= high else 180 - low + high + 1
    assert used["ring"][step] == {"traits": [low, high], "ends": [low, high], "lit": lit}


@pytest.mark.parametrize("way", ["file", "dropped", "pasted"])
def test_a_picture_of_the_reader_is_segmented_as_labutils_would(
    used: dict[str, Any], own: np.ndarray, way: str
) -> None:
    seen = used["own"][way]
    assert (seen["picture"], seen["size"]) == ("own", [60, 110])
    assert seen["values"] == explore_hsv(own, RED).values
    assert seen["message"] == "This is your picture."
    assert seen["buttons"] == ["Open picture", "Camera", "Back to scene"]


def test_a_file_that_is_no_picture_is_named_and_changes_nothing(used: dict[str, Any]) -> None:
    broken, before = used["own"]["broken"], used["own"]["file"]
    assert broken["message"] == "words.png cannot be read as a picture."
    assert broken["values"] == before["values"]


def test_the_scene_comes_back(used: dict[str, Any]) -> None:
    for seen in (used["own"]["back"], used["last"]):
        assert seen["values"] == used["first"]["values"]
        assert seen["picture"] == "scene"
        assert seen["buttons"] == ["Open picture", "Camera"]
        assert seen["focused"] == "Open picture"  # the button pressed is gone


def test_a_file_over_the_picture_is_expected(used: dict[str, Any]) -> None:
    assert used["own"]["dropping"] == 1


def test_the_camera_gives_a_still_of_the_size_of_the_scene_and_stops(used: dict[str, Any]) -> None:
    camera = used["camera"]
    assert camera["on"]["buttons"] == ["Take the picture", "Cancel"]
    assert camera["on"]["focused"] == "Take the picture"
    assert camera["onTracks"] == ["live"]
    assert (camera["taken"]["picture"], camera["taken"]["size"]) == ("own", [160, 90])
    assert camera["tracks"] == ["ended"] * 3
    assert camera["videos"] == 0
    assert camera["canceled"]["message"] == camera["late"]["message"] == ""
    assert used["picked"]["values"]["pixel_rgb"] == [0, 255, 0]  # the wall that it filmed


def test_a_camera_that_does_not_start_is_explained(used: dict[str, Any]) -> None:
    denied = "The browser did not allow the camera. You can open a picture instead."
    assert used["camera"]["denied"]["message"] == denied
    assert used["camera"]["denied"]["focused"] == "Camera"
    strange = "The camera does not start: no such thing"
    assert used["camera"]["strange"]["message"] == strange


def test_no_picture_of_the_reader_leaves_the_page_or_enters_a_trait(used: dict[str, Any]) -> None:
    assert used["complaints"] == []
    before = used["own"]["before"]["traits"]
    for way in ("file", "dropped", "pasted"):
        assert used["own"][way]["traits"] == before
    assert used["camera"]["taken"]["traits"] == before


def test_no_picture_moves_what_stands_below(used: dict[str, Any]) -> None:
    steps = [used["first"], *(used["own"][way] for way in ("file", "broken", "back", "pasted"))]
    steps += [used["camera"][step] for step in ("on", "taken", "denied")]
    assert len({step["place"] for step in steps}) == 1
