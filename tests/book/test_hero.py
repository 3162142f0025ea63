"""The data of the first screen are what the library computes, and its script what is imported."""

from __future__ import annotations

import base64
import json
import re
from typing import Any

import cv2
import numpy as np
import pytest
from docutils import nodes

from tests.helpers.scripts import load_script
from tests.helpers.tolerances import CLOUD_P99_MM
from tools.draw import hero
from tools.vendor import page_hero

HOOK = load_script("book/_ext/hero.py")


@pytest.fixture(scope="module")
def stored() -> dict[str, Any]:
    """What the page gets."""
    text = hero.DATA.read_text(encoding="utf-8")
    return {
        key: json.loads(value)
        for key, value in re.findall(r"^    (\w+): (.+),$", text, re.MULTILINE)
    }


def decode(text: str) -> np.ndarray:
    values = np.frombuffer(base64.b64decode(text), np.uint8)
    image = cv2.imdecode(values, cv2.IMREAD_UNCHANGED)
    assert image is not None
    return image


def test_the_stored_depth_is_what_the_camera_renders(stored: dict[str, Any]) -> None:
    _, depth = hero.render_picture(hero.CLOUD_SIZE)
    steps = decode(stored["depth_png"])
    seen = steps > 0
    off = np.abs(steps * stored["depth_step"] - depth)[seen]
    assert seen.mean() > 0.9
    # half a step; another driver may draw outlines by a pixel elsewhere
    assert np.percentile(off, 99) <= stored["depth_step"] / 2 + 1e-6


def test_the_stored_errors_lead_from_depth_to_the_truth(stored: dict[str, Any]) -> None:
    _, depth = hero.render_picture(hero.CLOUD_SIZE)
    errors, things, names = hero.measure_errors(depth)
    found = (decode(stored["error_png"]).astype(float) - stored["error_zero"]) * stored[
        "error_step"
    ]
    seen = np.isfinite(errors)
    assert np.percentile(np.abs(found - errors)[seen], 99) <= stored["error_step"]
    assert np.percentile(np.abs(found[seen]), 99) * 1000 < CLOUD_P99_MM
    assert names == stored["names"]
    assert np.mean(decode(stored["thing_png"]) == things) > 0.99


def test_everything_on_the_table_has_a_name(stored: dict[str, Any]) -> None:
    assert stored["names"][0] == hero.NOTHING
    assert {"red ball", "table", "wall", "blue bottle", "cyan mug"} <= set(stored["names"])
    assert not [name for name in stored["names"] if "_" in name]


def test_photo_and_data_are_light() -> None:
    assert hero.PHOTO.stat().st_size < 30e3
    assert hero.DATA.stat().st_size < 60e3


def test_a_figure_of_the_class_gets_its_buttons_before_the_caption() -> None:
    figure = nodes.figure("", nodes.image(), nodes.caption("", "text"), classes=["hero"])
    tree = nodes.section("", figure, nodes.figure("", nodes.image(), nodes.caption("", "other")))

    class App:
        class builder:  # noqa: N801 - Sphinx's name
            format = "html"

    HOOK.add_bar(App, tree, "book/index")
    image, bar, caption = figure.children
    assert isinstance(image, nodes.image)
    assert isinstance(caption, nodes.caption)
    assert bar.astext().count("<button") == len(HOOK.BUTTONS)
    assert 'role="status"' in bar.astext()
    assert len(tree.children[1].children) == 2


def test_the_bundle_follows_every_import() -> None:
    names = {path.name for path in page_hero.list_sources()}
    assert {"hero.js", "scene.js", "view.js", "_cloud_gl.js", "_splat.js", "_camera.js"} <= names
    assert page_hero.bundle().startswith(("up to date", "bundled"))
    assert b"import" not in page_hero.BUNDLE.read_bytes().split(b"(", 1)[0]
