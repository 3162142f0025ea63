"""The first screen: a photo that lifts into 3-D with one gesture and tells true distances."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from PIL import Image

from labutils import (
    get_camera_intrinsics,
    get_camera_pose,
    make_renderer,
    make_scene,
    pixels_to_points,
    render_camera,
)
from labutils.raycast import raycast_points
from tests.helpers import browser

SIZE = (640, 320)
READING = re.compile(
    r"(.+): ([\d.]+) m from the camera\. Truth: ([\d.]+) m\. Error: ([\d.]+) mm\.( This pixel .*)?"
)
#: A click may take the pixel beside the one that was meant: on the table that is 3 mm away.
NEIGHBOR_M = 0.006
#: Levels of 255 by which cloud and photo differ on average: one is drawn of squares.
MEAN_DIFFERENCE = 6.0


@pytest.fixture(scope="module", params=browser.PROTOCOLS)
def used(
    request: pytest.FixtureRequest, chromium: Callable[..., Any], once: Callable[..., Any]
) -> dict[str, Any]:
    site = request.getfixturevalue(f"{request.param}_site")
    return once(f"hero-{request.param}", lambda: chromium("hero.mjs", site))


@pytest.fixture(scope="module")
def distances() -> tuple[np.ndarray, np.ndarray]:
    """Distances from the camera as labutils computes them, from depth and from rays: (H, W)."""
    model, data = make_scene()
    with make_renderer(model, SIZE[1], SIZE[0]) as renderer:
        _, depth = render_camera(model, data, renderer, "head_camera")
    K, _ = get_camera_intrinsics(model, "head_camera", *SIZE)
    v, u = np.indices(depth.shape)
    points = pixels_to_points(np.stack([u.ravel(), v.ravel()], axis=-1), depth.ravel(), K)
    truth = raycast_points(model, data, "head_camera", *SIZE)
    center = get_camera_pose(model, data, "head_camera")[:3, 3]
    measured = np.linalg.norm(points, axis=-1).reshape(depth.shape)
    return measured, np.linalg.norm(truth - center, axis=-1)


def test_it_opens_as_a_photo_under_the_title(used: dict[str, Any]) -> None:
    assert used["mouse"]["flat"]["state"] == "flat"
    for screen in used["screens"]:
        before = screen["before"]
        assert before["state"] == "flat"
        assert 0 <= before["stage"]["top"] - before["titleBottom"] < 40
        assert before["tooWide"] <= 0


def test_on_every_screen_all_of_the_photo_is_in_the_first_view(used: dict[str, Any]) -> None:
    for screen in used["screens"]:
        assert screen["before"]["stage"]["bottom"] <= screen["viewport"]["height"]


def test_where_to_go_is_in_the_first_view(used: dict[str, Any]) -> None:
    for screen in used["screens"]:
        if screen["viewport"]["height"] > 400:  # a phone on its side shows the photo alone
            assert screen["before"]["linksBottom"] <= screen["viewport"]["height"]


def test_the_photo_is_as_wide_as_there_is_room(used: dict[str, Any]) -> None:
    laptop, phone, _, large = used["screens"]
    assert phone["before"]["stage"]["width"] == phone["viewport"]["width"]
    assert large["before"]["stage"]["width"] == pytest.approx(large["before"]["article"], abs=2)
    assert laptop["before"]["stage"]["width"] > 640
    for screen in (laptop, large):
        stage = screen["before"]["stage"]
        assert stage["width"] / stage["height"] >= 16 / 9


def test_one_drag_lifts_it_and_nothing_jumps(used: dict[str, Any]) -> None:
    for screen in used["screens"]:
        assert screen["complaints"] == []
        assert screen["after"].pop("state") == "lifted"
        assert screen["before"].pop("state") == "flat"
        assert screen["after"] == screen["before"]


def test_a_click_reads_distance_and_truth_as_labutils_computes_them(
    used: dict[str, Any], distances: tuple[np.ndarray, np.ndarray]
) -> None:
    measured, truth = distances
    for thing, digits in (("ball", 2.0), ("table", 0.0)):
        click = used["mouse"]["clicks"][thing]
        found = READING.fullmatch(click["text"])
        assert found is not None, click["text"]
        u, v = click["pixel"]
        assert thing in found[1].lower()
        assert float(found[2]) == pytest.approx(measured[v, u], abs=NEIGHBOR_M)
        assert float(found[3]) == pytest.approx(truth[v, u], abs=NEIGHBOR_M)
        assert float(found[4]) <= digits  # the drawn ball has corners, the table has none
        assert found[5] is None
    assert used["mouse"]["stillFlat"]["state"] == "flat"


def test_where_depth_says_nothing_it_says_so(used: dict[str, Any]) -> None:
    assert used["mouse"]["clicks"]["sky"]["text"].startswith("The sky")
    assert used["mouse"]["nothing"].startswith("No point there")


def test_from_the_camera_the_cloud_is_the_photo(used: dict[str, Any]) -> None:
    photo, cloud = (
        np.asarray(Image.open(io.BytesIO(base64.b64decode(used["mouse"][name]))).convert("RGB"))
        for name in ("photo", "cloud")
    )
    assert photo.shape == cloud.shape
    # all but the sky in the window, which has no depth
    below = slice(photo.shape[0] // 4, None)
    difference = np.abs(photo[below].astype(float) - cloud[below])
    assert difference.mean() < MEAN_DIFFERENCE
    shifted = np.abs(photo[below, 8:].astype(float) - cloud[below, :-8])
    assert shifted.mean() > 1.5 * difference.mean()  # it would not pass beside its place


def test_reset_brings_the_photo_back(used: dict[str, Any]) -> None:
    assert used["mouse"]["lifted"]["painter"] == "webgl2"
    assert used["mouse"]["turned"] != used["mouse"]["start"]["orbit"]
    for name, value in used["mouse"]["start"]["orbit"].items():
        assert used["mouse"]["reset"][name] == pytest.approx(value)
    assert used["mouse"]["complaints"] == []


def test_keys_do_all_that_a_mouse_does(used: dict[str, Any]) -> None:
    keys = used["keys"]
    assert "Arrow keys" in keys["name"]
    assert keys["afterKeys"]["state"] == "lifted"
    left, up, nearer, farther = keys["orbits"].values()
    assert left["azimuth_deg"] != pytest.approx(keys["home"]["azimuth_deg"])
    assert up["elevation_deg"] > left["elevation_deg"]
    assert nearer["distance"] < up["distance"]
    assert farther["distance"] == pytest.approx(up["distance"])
    found = READING.fullmatch(keys["ball"])
    assert found is not None, keys["ball"]
    assert found[1] == "Red ball"
    assert keys["role"] == "status"


def test_who_asks_for_less_motion_is_there_at_once(used: dict[str, Any]) -> None:
    turn = used["keys"]["lifted"]["azimuth_deg"] - used["keys"]["home"]["azimuth_deg"]
    assert turn > 20
    degrees = used["smooth"]
    assert len(set(degrees)) > 2  # others see places on the way
    assert degrees == sorted(degrees)
    assert degrees[-1] == pytest.approx(used["keys"]["lifted"]["azimuth_deg"])


def test_without_webgl_a_canvas_draws_it(used: dict[str, Any]) -> None:
    assert used["plain"] == {"state": "lifted", "painter": "2d", "complaints": []}


def test_without_scripts_photo_caption_and_links_stand_there(used: dict[str, Any]) -> None:
    plain = used["withoutScripts"]
    assert (plain["images"], plain["captions"], plain["buttons"]) == (1, 1, 0)
    assert plain["drawn"] == 1280
    assert "red ball" in plain["alt"]
    assert plain["links"] == [
        "step1_camera.html",
        "../exercises/step2_intrinsics.html#exercise-intrinsics-matrix",
    ]


def test_on_paper_the_photo_stands_even_where_it_was_lifted(used: dict[str, Any]) -> None:
    paper = used["paper"]
    assert (paper["images"], paper["opacity"], paper["canvases"]) == (1, "1", 0)
    assert (paper["captions"], paper["buttons"]) == (1, 0)
