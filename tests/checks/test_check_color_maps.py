"""Any map from blue to red is right, and only what follows the depth along one is a map."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import pytest

from labutils.checks import judge
from labutils.checks.calls import collect_answers
from labutils.checks.gates import find_failure
from labutils.checks.table import load_table
from tests.helpers.hidden_cases import make_hidden_table

Map = Callable[[np.ndarray], np.ndarray]


def hue_wheel(share: np.ndarray) -> np.ndarray:
    """Draw hues from blue to red, in whole degrees of OpenCV."""
    hue = (120 - np.floor(120 * share)).astype(np.uint8)
    full = np.full_like(hue, 255)
    return cv2.cvtColor(np.stack([hue, full, full], axis=-1), cv2.COLOR_HSV2BGR)


def through_white(share: np.ndarray) -> np.ndarray:
    """Draw blue, white, red, as maps for differences do."""
    low, high = np.clip(2 * share, 0, 1), np.clip(2 - 2 * share, 0, 1)
    return np.round(255 * np.stack([high, np.minimum(low, high), low], axis=-1)).astype(np.uint8)


def through_gray(share: np.ndarray) -> np.ndarray:
    """Draw a dull ramp that is never quite blue nor quite red."""
    return (np.stack([200 - 150 * share, 60 + 0 * share, 50 + 150 * share], axis=-1)).astype(
        np.uint8
    )


def interpolated(code: int) -> Map:
    """Draw a map of OpenCV with the colors between its levels."""
    table = cv2.applyColorMap(np.arange(256, dtype=np.uint8)[:, None], code)[:, 0].astype(float)
    stops = np.linspace(0, 1, 256)
    return lambda share: (
        np.stack([np.interp(share, stops, table[:, k]) for k in range(3)], axis=-1)
        .round()
        .astype(np.uint8)
    )


def pure_colors(share: np.ndarray) -> np.ndarray:
    """Draw blue, cyan, yellow, red: colors that all lie on COLORMAP_JET, but elsewhere."""
    stops = np.linspace(0, 1, 4)
    planes = ([255, 255, 0, 0], [0, 255, 255, 0], [0, 0, 255, 255])
    return np.stack([np.interp(share, stops, one) for one in planes], axis=-1).astype(np.uint8)


def of_opencv(code: int) -> Map:
    return lambda share: cv2.applyColorMap((255 * share).astype(np.uint8), code)


RIGHT = {
    "hues": hue_wheel,
    "through white": through_white,
    "dull": through_gray,
    "rainbow backward": lambda share: of_opencv(cv2.COLORMAP_RAINBOW)(1 - share),
    "turbo": of_opencv(cv2.COLORMAP_TURBO),
    "turbo, interpolated": interpolated(cv2.COLORMAP_TURBO),
    "pure colors": pure_colors,
    "jet": of_opencv(cv2.COLORMAP_JET),
}
WRONG = {
    "red is close": lambda share: hue_wheel(1 - share),
    "viridis": of_opencv(cv2.COLORMAP_VIRIDIS),
    "hot": of_opencv(cv2.COLORMAP_HOT),
    "gray": lambda share: np.repeat((255 * share).astype(np.uint8)[..., None], 3, axis=-1),
    "two colors": lambda share: hue_wheel(np.asarray(np.round(share))),
    "few steps": lambda share: hue_wheel(np.asarray(np.floor(8 * share) / 8)),
}


def make_function(color_map: Map, *, clips: bool = True, scales: bool = True) -> Any:
    def visualize_depth(depth_metric: np.ndarray, max_depth: float = 5.0) -> np.ndarray:
        seen = np.isfinite(depth_metric) & (depth_metric > 0)
        limit = max_depth if scales else float(depth_metric[seen].max())
        share = np.where(seen, depth_metric, 0) / limit
        picture = color_map(np.clip(share, 0, 1) if clips else share % 1.0)
        picture[~seen] = 0
        return picture

    return visualize_depth


@pytest.mark.parametrize("name", RIGHT)
def test_any_map_from_blue_to_red_is_right(name: str) -> None:
    function = make_function(RIGHT[name])
    verdict = judge(load_table("visualize_depth"), function)
    assert verdict.passed, verdict.message


@pytest.mark.parametrize("name", ["hues", "through white", "dull"])
@pytest.mark.parametrize("seed", range(8))
def test_it_is_right_in_the_hidden_cases_too(name: str, seed: int) -> None:
    table = make_hidden_table("visualize_depth", seed)
    assert find_failure(table, collect_answers(table, make_function(RIGHT[name]))) is None


@pytest.mark.parametrize("name", WRONG)
def test_what_does_not_lead_from_blue_to_red_is_wrong(name: str) -> None:
    assert not judge(load_table("visualize_depth"), make_function(WRONG[name])).passed


@pytest.mark.parametrize("name", ["hues", "through white"])
def test_an_unlisted_map_hides_no_other_mistake(name: str) -> None:
    table = load_table("visualize_depth")
    for wrong in (
        make_function(RIGHT[name], clips=False),
        make_function(RIGHT[name], scales=False),
    ):
        assert not judge(table, wrong).passed


def test_the_message_says_what_was_seen() -> None:
    message = judge(load_table("visualize_depth"), make_function(WRONG["viridis"])).message
    assert "do not follow the depth along one map" in message
