"""What all explorers share: pictures that lose nothing, linked controls, the poster."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import cv2
import ipywidgets
import numpy as np
import pytest
import traitlets

from labutils.explorers import _base
from labutils.explorers._base import Explorer
from labutils.explorers._goal import Goal, GoalPart
from tests.helpers.node import run_node


class Doubler(_base.View):
    """The smallest view there is."""

    PARAMETERS = ("amount",)
    amount = traitlets.Int(3).tag(sync=True)

    def compute(self) -> dict[str, int]:
        return {"double": 2 * self.amount}

    def describe(self) -> str:
        return f"Twice {self.amount}"

    def draw_poster(self) -> np.ndarray:
        return np.full((4, 6, 3), 128, np.uint8)


@pytest.fixture
def explorer() -> Explorer:
    return _base.Explorer(Doubler(), {"amount": _base.make_slider("amount", (0, 10), 1, unit="m")})


def test_a_control_starts_at_the_value_of_the_view_and_names_its_unit(explorer: Explorer) -> None:
    slider = explorer.controls["amount"].widget
    assert (slider.value, slider.description) == (3, "amount (m)")


def test_control_and_view_are_linked_in_the_browser(explorer: Explorer) -> None:
    slider = explorer.controls["amount"].widget
    (link,) = explorer.links
    assert (link.source, link.target) == ((slider, "value"), (explorer.view, "amount"))


def test_values_follow_what_python_moves(explorer: Explorer) -> None:
    explorer.move(amount=5)
    assert explorer.values == {"double": 10}
    assert explorer.controls["amount"].widget.value == 5
    assert explorer.view.start == {"amount": 3}  # where Reset leads


def test_moving_an_unknown_control_names_the_known_ones(explorer: Explorer) -> None:
    with pytest.raises(ValueError, match="control: expected one of amount, got 'speed'"):
        explorer.move(speed=1)


def test_a_goal_is_set_and_taken_away_from_python(explorer: Explorer) -> None:
    explorer.goal = Goal("Double it to ten", GoalPart("double", "double", low=10))
    reached = []
    for amount in (4, 5):
        explorer.move(amount=amount)
        reached.append(explorer.goal_is_reached)
    assert reached == [False, True]
    explorer.goal = None
    assert explorer.view.goal == {}


def test_without_a_goal_nothing_can_be_reached(explorer: Explorer) -> None:
    assert explorer.goal is None
    with pytest.raises(ValueError, match="goal: expected one to reach, got None"):
        _ = explorer.goal_is_reached


def test_a_viewer_without_widgets_gets_the_poster_and_the_sentence(explorer: Explorer) -> None:
    bundle = explorer._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in bundle
    assert bundle["text/plain"] == "Twice 3"
    assert (_base.decode_rgb(bundle["image/png"]) == 128).all()


def test_a_viewer_that_wants_no_poster_gets_none(explorer: Explorer) -> None:
    bundle = explorer._repr_mimebundle_(exclude={"image/png"})
    assert set(bundle) == {"application/vnd.jupyter.widget-view+json", "text/plain"}


def test_whole_steps_make_a_slider_of_whole_numbers() -> None:
    assert isinstance(_base.make_slider("n", (0, 3), 1), ipywidgets.IntSlider)
    assert isinstance(_base.make_slider("x", (0, 3), 0.5), ipywidgets.FloatSlider)
    assert isinstance(_base.make_range_slider("n", (0, 3), 1), ipywidgets.IntRangeSlider)
    assert isinstance(_base.make_range_slider("x", (0, 3), 0.5), ipywidgets.FloatRangeSlider)


def test_a_choice_gives_its_place_because_pages_know_no_value() -> None:
    widget, attribute = _base.make_choice("size", ["small", "large"])
    setattr(widget, attribute, 1)
    assert widget.value == "large"


def test_depth_survives_the_way_to_the_page_within_half_a_step() -> None:
    rng = np.random.default_rng(5)
    depth = rng.uniform(0.02, 13.0, (30, 40)).astype(np.float32)
    back = _base.decode_depth(_base.encode_depth(depth))
    # half a step, and one rounding of float32 near 13 m
    assert np.abs(back - depth).max() <= _base.DEPTH_STEP / 2 + 1e-6


@pytest.mark.parametrize("value", [np.nan, np.inf, -1.0, 14.0])
def test_what_is_no_depth_becomes_zero(value: float) -> None:
    assert _base.decode_depth(_base.encode_depth(np.array([[value]])))[0, 0] == 0


def test_bytes_that_are_no_png_are_told() -> None:
    with pytest.raises(ValueError, match="expected the bytes of a PNG file, got 4 others"):
        _base.decode_rgb(b"text")


@pytest.mark.parametrize(
    ("channels", "dtype"), [(3, np.uint8), (1, np.uint16), (1, np.uint8), (4, np.uint8)]
)
@pytest.mark.parametrize("smooth", [True, False])
def test_the_page_reads_png_as_opencv_does(
    channels: int, dtype: type[np.integer[Any]], smooth: bool, tmp_path: Path
) -> None:
    # Smooth pictures make the encoder use its predictors, noise makes it use none.
    rng = np.random.default_rng(3)
    v, u = np.mgrid[:33, :47]
    top = np.iinfo(dtype).max
    image = (u * 91 + v * v * 17) % top if smooth else rng.integers(0, top, (33, 47))
    image = np.repeat(image[..., None], channels, axis=2).astype(dtype)
    image[..., -1] += (v % 7).astype(dtype)
    path = tmp_path / "image.png"
    cv2.imwrite(str(path), image.squeeze())
    code = """
    import { readFileSync } from "node:fs";
    const { decodePng } = await load("_png");
    const { width, height, channels, data } = await decodePng(readFileSync(process.argv[1]));
    console.log(JSON.stringify({ width, height, channels, data: [...data] }));
    """
    found = json.loads(run_node(code, str(path)))
    rgb = image[..., [2, 1, 0, 3][:channels]] if channels > 1 else image
    assert (found["width"], found["height"], found["channels"]) == (47, 33, channels)
    np.testing.assert_array_equal(found["data"], rgb.ravel())


@pytest.mark.parametrize(
    ("place", "value", "said"), [(0, 0, "no PNG"), (25, 3, "type 3"), (28, 1, "not supported")]
)
def test_a_png_the_page_cannot_read_is_told(
    place: int, value: int, said: str, tmp_path: Path
) -> None:
    data = bytearray(_base.encode_rgb(np.zeros((2, 2, 3), np.uint8)))
    data[place] = value
    (tmp_path / "image.png").write_bytes(data)
    code = """
    import { readFileSync } from "node:fs";
    const { decodePng } = await load("_png");
    console.log(await decodePng(readFileSync(process.argv[1])).catch((error) => error.message));
    """
    assert said in run_node(code, str(tmp_path / "image.png"))
