"""Every explorer on every page says what labutils computes, wherever its controls stand."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from math import inf
from pathlib import Path
from typing import Any

import pytest

from labutils import explorers
from tests.helpers import browser
from tests.helpers.chapters import ROOT, find_widgets
from tools.explorer_views import find_pages, read_views

#: JavaScript and NumPy round the same formulas in another order.
RTOL = 1e-6
ATOL = 1e-9


PAGES = find_pages()


@pytest.fixture(scope="module", params=browser.PROTOCOLS)
def protocol(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture(scope="module", params=PAGES)
def page(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture(scope="module")
def used(
    protocol: str,
    page: str,
    request: pytest.FixtureRequest,
    chromium: Callable[..., Any],
    once: Callable[..., Any],
) -> dict[str, Any]:
    """What the explorers of a page said while they were used."""
    site = request.getfixturevalue(f"{protocol}_site")
    seen = once(f"explorers-{protocol}", lambda: chromium("explorers.mjs", site, *PAGES))[page]
    assert seen["explorers"], "or the tests below would pass by finding nothing"
    return seen


def agree(expected: Any, found: Any) -> bool:
    """Compare values from Python with values that came as JSON."""
    if isinstance(expected, dict):
        return expected.keys() == found.keys() and all(agree(expected[k], found[k]) for k in found)
    if isinstance(expected, list | tuple):
        return len(expected) == len(found) and all(map(agree, expected, found))
    if isinstance(expected, float) and isinstance(found, int | float):
        if abs(expected) == inf:
            return expected == found
        return found == pytest.approx(expected, rel=RTOL, abs=ATOL)
    return type(expected) is type(found) and expected == found


def test_every_control_changes_the_readout_to_what_labutils_computes(
    page: str, used: dict[str, Any], student_pages: Path
) -> None:
    views = read_views((student_pages / f"{page}.html").read_text(encoding="utf-8"))
    assert len(views) == len(used["explorers"]) > 0
    for view, explorer in zip(views, used["explorers"], strict=True):
        for said in (explorer["first"], *explorer["moves"], explorer["reset"]):
            for name, value in said["parameters"].items():
                setattr(view, name, value)
            expected = json.loads(json.dumps(view.compute()))
            assert agree(expected, said["values"]), (said, expected)


def test_every_control_moves_its_value(used: dict[str, Any]) -> None:
    for explorer in used["explorers"]:
        controls = {move["control"] for move in explorer["moves"]}
        assert controls, "an explorer without a control"
        for control in controls:
            moves = [move for move in explorer["moves"] if move["control"] == control]
            for move in moves:
                if "shown" in move:
                    flat = [v for one in move["parameters"].values() for v in flatten(one)]
                    flat += flatten(move.get("near", []))
                    # the handle rounds what it shows to the digits of its read-out
                    assert any(abs(v - move["shown"]) < 0.006 for v in flat), move
                assert move.get("pressed", "true") == "true", move
            if moves[0]["step"] == "min":
                seen = [json.dumps(move["parameters"], sort_keys=True) for move in moves]
                # one handle of a range ends where the other stands, which may be the middle
                steps = 2 if control.endswith((", low", ", high")) else 3
                assert len(set(seen)) >= steps, (control, seen)


def flatten(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]


def test_reset_brings_the_first_values_back(used: dict[str, Any]) -> None:
    for explorer in used["explorers"]:
        # not equal: a slider keeps percents, and turns 45 into 45.00000000000001
        assert agree(explorer["first"], explorer["reset"])
        assert any(
            move["parameters"] != explorer["first"]["parameters"] for move in explorer["moves"]
        )


def test_a_screen_reader_hears_the_result_and_every_name(used: dict[str, Any]) -> None:
    for explorer in used["explorers"]:
        assert explorer["spoken"] == explorer["readout"] != ""
        assert explorer["unnamed"] == 0


def test_a_screen_reader_hears_values_as_they_are_written_with_their_unit(
    used: dict[str, Any],
) -> None:
    # a slider by itself says the place in its list, or 45.00000000000001
    for explorer in used["explorers"]:
        for move in explorer["moves"]:
            if "said" in move:
                unit = re.search(r" \(([^)]+)\)", move["control"])
                end = re.escape(f" {unit[1]}") if unit else ""
                assert re.fullmatch(rf"\u2212?[\d,]+(\.\d{{1,5}})?{end}", move["said"]), move


def test_on_paper_and_without_scripts_a_poster_stands_in(used: dict[str, Any]) -> None:
    count = len(used["explorers"])
    assert used["printed"] == {"posters": count, "explorers": 0}
    assert used["withoutScripts"] == {"posters": count, "explorers": 0}


def test_using_explorers_asks_no_other_host_and_raises_no_error(used: dict[str, Any]) -> None:
    assert used["complaints"] == []


def test_every_explorer_is_used_on_some_page() -> None:
    text = "".join((ROOT / page).with_suffix(".md").read_text("utf-8") for page in PAGES)
    assert len(find_widgets()) > 5
    for name in find_widgets():
        assert f"explore_{name}(" in text
        assert f"explore_{name}" in explorers.__all__
