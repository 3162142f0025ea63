"""The point cloud explorer in Chromium, with WebGL and without."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from labutils import get_camera_intrinsics, make_renderer, make_scene, render_camera
from labutils.camera_utils import get_camera_pose
from labutils.explorers import explore_cloud
from labutils.explorers._cloud_poster import make_view_transform
from labutils.explorers._cloud_start import turn_to_view
from labutils.explorers.cloud import CloudExplorer
from tests.explorers.test_cloud import FACES
from tests.helpers.view_page import write_view_page

KINDS = ("webgl2", "2d")
#: Share of pixels in which two ways of drawing may differ: a square's edge may round to the next
#: pixel, in one of a thousand here. Without a depth test it is 9 to 17 of a thousand.
MAX_DIFFERENT = 0.004


@pytest.fixture(scope="module")
def explorer() -> CloudExplorer:
    model, data = make_scene()
    with make_renderer(model, 480, 640) as renderer:
        rgb, depth = render_camera(model, data, renderer, "head_camera")
    K, _ = get_camera_intrinsics(model, "head_camera", 640, 480)
    T_world_cam = get_camera_pose(model, data, "head_camera")
    return explore_cloud(rgb, depth, K, T_world_cam, faces=FACES)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("cloud")


@pytest.fixture(scope="module")
def seen(explorer: CloudExplorer, folder: Path, chromium: Callable[..., Any]) -> dict[str, Any]:
    write_view_page(explorer.view, folder / "cloud.html")
    return chromium("cloud.mjs", folder.as_uri() + "/", folder)


def read(folder: Path, kind: str, name: str) -> np.ndarray:
    picture = cv2.imread(str(folder / f"{kind}-{name}.png"))
    assert picture is not None
    return picture.astype(int)


def find_drawn(picture: np.ndarray) -> np.ndarray:
    """Mark what is not the page's white, inside the border."""
    return np.asarray((picture[4:-4, 4:-4] < 250).any(axis=2))


def make_expected(explorer: CloudExplorer, report: dict[str, Any]) -> dict[str, Any]:
    explorer.move(**{name: report[name] for name in ("fov_y_deg", "far", "color", "pixel")})
    return explorer.values


@pytest.mark.parametrize("kind", KINDS)
def test_it_draws_with_what_the_browser_has(seen: dict[str, Any], folder: Path, kind: str) -> None:
    assert seen[kind]["errors"] == []
    assert seen[kind]["painter"] == kind
    assert 0.15 < find_drawn(read(folder, kind, "start")).mean() < 0.8
    near = find_drawn(read(folder, kind, "near")).mean()
    assert 0 < near < find_drawn(read(folder, kind, "camera")).mean()


@pytest.mark.usefixtures("seen")
@pytest.mark.parametrize("name", ["start", "camera", "near", "behind"])
def test_both_ways_of_drawing_show_the_same(folder: Path, name: str) -> None:
    one, other = (read(folder, kind, name) for kind in KINDS)
    assert one.shape == other.shape
    assert (np.abs(one - other).max(axis=2) > 40).mean() < MAX_DIFFERENT


@pytest.mark.usefixtures("seen")
def test_the_cameras_view_is_its_picture(folder: Path, explorer: CloudExplorer) -> None:
    picture = read(folder, "webgl2", "camera")
    rgb = cv2.imdecode(np.frombuffer(explorer.view.rgb_png, np.uint8), cv2.IMREAD_COLOR)
    assert rgb is not None
    height, width = picture.shape[:2]
    share = np.tan(np.radians(22.5)) / np.tan(np.radians(explorer.view.view_fov_deg / 2))
    # the view is as high as the camera's picture makes it, and wider
    size = (round(height * share * rgb.shape[1] / rgb.shape[0]), round(height * share))
    left, top = (width - size[0]) // 2, (height - size[1]) // 2
    shown = picture[top : top + size[1], left : left + size[0]]
    expected = cv2.resize(rgb, size, interpolation=cv2.INTER_AREA).astype(int)
    off = np.abs(shown - expected).max(axis=2)
    # all but the window, through which one sees the page, and edges shifted by up to a pixel
    assert np.median(off) < 6
    assert (off > 40).mean() < 0.15


@pytest.mark.parametrize("kind", KINDS)
def test_the_read_out_tells_what_labutils_computes(
    seen: dict[str, Any], explorer: CloudExplorer, kind: str
) -> None:
    everything = seen[kind]
    reports = [everything["start"], everything["reset"], *everything["settings"]]
    for report in [*reports, *everything["clicks"], everything["pickedByKeys"]]:
        expected = make_expected(explorer, report)
        assert report["values"].keys() == expected.keys()
        for name, value in expected.items():
            if value is None:
                assert report["values"][name] is None
            else:
                np.testing.assert_allclose(report["values"][name], value, rtol=1e-6, atol=1e-9)
        assert f"{expected['points']:,} points" in report["text"]
    assert "no surface closer" not in everything["reset"]["text"]


@pytest.mark.parametrize("kind", KINDS)
def test_a_click_picks_the_point_under_it(
    seen: dict[str, Any], explorer: CloudExplorer, kind: str
) -> None:
    T_view_cam = turn_to_view(np.array(explorer.view.T_world_cam))
    hits = [click for click in seen[kind]["clicks"] if click["pixel"]]
    assert len(hits) == 3  # the last one is beside the cloud
    assert seen[kind]["clicks"][-1]["pixel"] == []
    width, height = (side - 2 for side in seen[kind]["size"])  # without the border
    focal = height / 2 / np.tan(np.radians(explorer.view.view_fov_deg / 2))
    for click in hits:
        eye = make_view_transform(click["orbit"]) @ T_view_cam
        x, y, z, _ = eye @ [*click["values"]["point_camera"], 1]
        found = focal * np.array([x, y]) / z + [width / 2, height / 2]
        wanted = np.array(click["place"]) * seen[kind]["size"] - 1
        assert np.abs(found - wanted).max() < 4  # half the largest square here, and rounding
        assert str(tuple(click["pixel"])) in click["text"]


def test_picks_do_not_depend_on_how_the_cloud_is_drawn(seen: dict[str, Any]) -> None:
    one, other = ([click["pixel"] for click in seen[kind]["clicks"]] for kind in KINDS)
    assert one == other


@pytest.mark.parametrize("kind", KINDS)
def test_the_page_scrolls_unless_the_view_was_clicked(seen: dict[str, Any], kind: str) -> None:
    start = seen[kind]["start"]["orbit"]
    assert seen[kind]["wheelUnasked"]["orbit"] == start
    assert seen[kind]["wheelFocused"]["orbit"]["distance"] < start["distance"]


@pytest.mark.parametrize("kind", KINDS)
def test_a_drag_walks_around_and_picks_nothing(seen: dict[str, Any], kind: str) -> None:
    before, dragged = seen[kind]["wheelFocused"], seen[kind]["dragged"]
    assert dragged["orbit"]["azimuth_deg"] < before["orbit"]["azimuth_deg"] - 10
    assert dragged["orbit"]["elevation_deg"] == before["orbit"]["elevation_deg"]
    assert dragged["pixel"] == before["pixel"]
    # a kernel hears the end of it, not every step
    assert seen[kind]["midDrag"]["saves"] == before["saves"]
    assert dragged["saves"] == before["saves"] + 1


@pytest.mark.parametrize("kind", KINDS)
def test_keys_and_buttons_walk_around(seen: dict[str, Any], kind: str) -> None:
    keys, start = seen[kind]["keys"], seen[kind]["start"]["orbit"]
    left, up, closer, away, home = (keys[key]["orbit"] for key in keys)
    assert left["azimuth_deg"] == seen[kind]["dragged"]["orbit"]["azimuth_deg"] + 5
    assert up["elevation_deg"] == left["elevation_deg"] + 5
    assert closer["distance"] < up["distance"]
    assert away["distance"] == pytest.approx(up["distance"])
    assert home == start
    buttons = {name: report["orbit"] for name, report in seen[kind]["buttons"].items()}
    assert buttons["zoom in"]["distance"] < start["distance"]
    assert buttons["zoom out"]["distance"] == pytest.approx(start["distance"])
    assert buttons["view from above"]["elevation_deg"] == 90
    assert buttons["view from the side"]["elevation_deg"] == 0


@pytest.mark.parametrize("kind", KINDS)
def test_points_can_be_picked_by_keys_in_the_picture(seen: dict[str, Any], kind: str) -> None:
    assert seen[kind]["pickedByKeys"]["pixel"] == [321, 250]  # from the middle: right, ten down


@pytest.mark.parametrize("kind", KINDS)
def test_reset_brings_everything_back(seen: dict[str, Any], kind: str) -> None:
    names = ("fov_y_deg", "far", "color", "pixel", "orbit", "values")
    start, reset = ({name: seen[kind][one][name] for name in names} for one in ("start", "reset"))
    assert reset == start


@pytest.mark.usefixtures("seen")
def test_a_lost_context_falls_back_to_the_canvas(folder: Path) -> None:
    start, lost = (read(folder, "webgl2", name) for name in ("start", "lost"))
    assert (np.abs(start - lost).max(axis=2) > 40).mean() < MAX_DIFFERENT


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_left_when_the_view_goes(seen: dict[str, Any], kind: str) -> None:
    assert seen[kind]["left"] == {"parts": 0, "listeners": 0, "contextLost": True}
