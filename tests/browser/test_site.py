"""What all pages share works, as a file and from a server: theme, skip link, print."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from tests.helpers import browser


@pytest.fixture(scope="module", params=browser.PROTOCOLS)
def used(
    request: pytest.FixtureRequest, chromium: Callable[..., Any], once: Callable[..., Any]
) -> dict[str, Any]:
    """What happened when a reader used the site."""
    site = request.getfixturevalue(f"{request.param}_site")
    return once(f"site-{request.param}", lambda: chromium("site.mjs", site))


def test_the_theme_switch_darkens_the_page_and_is_remembered(used: dict[str, Any]) -> None:
    theme = used["theme"]
    assert theme["before"]["theme"] == "light"
    assert theme["after"]["theme"] == "dark"
    assert theme["after"]["paper"] != theme["before"]["paper"]
    assert theme["reloaded"] == theme["after"]
    assert theme["elsewhere"] == theme["after"]
    assert theme["complaints"] == []


def test_the_first_stop_of_the_keyboard_skips_to_the_content(used: dict[str, Any]) -> None:
    assert used["skip"] == {"first": "Skip to main content", "inMain": True}


def test_paper_is_white_and_carries_the_whole_text_and_nothing_else(used: dict[str, Any]) -> None:
    assert used["paper"] == {
        "sidebars": False,
        "article": True,
        "unfolded": True,
        "color": "rgb(0, 0, 0)",
        "backgroundColor": "rgb(255, 255, 255)",
        "missing": 0,
    }
