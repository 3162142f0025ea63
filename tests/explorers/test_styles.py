"""Every view brings the style of everything it draws, and no two views fight over a name."""

from __future__ import annotations

import re

import pytest

from labutils.explorers._base import View
from tests.helpers.node import STATIC
from tools.explorer_views import find_view_classes

CLASS = re.compile(r"explorer-[a-z][a-z-]*")
SHEETS = {path.stem: path.read_text("utf-8") for path in STATIC.glob("*.css")}


VIEWS = find_view_classes()


def test_every_script_of_a_view_has_its_view() -> None:
    scripts = {path.stem for path in STATIC.glob("*.js") if not path.stem.startswith("_")}
    assert {view.__module__.rpartition(".")[2] for view in VIEWS} == scripts


@pytest.mark.parametrize("view", VIEWS, ids=lambda view: view.__name__)
def test_a_view_is_styled_where_another_view_styles_the_same_part(view: type[View]) -> None:
    used = set(CLASS.findall(view._esm))
    brought = set(CLASS.findall(view._css))
    elsewhere = set(CLASS.findall("".join(SHEETS.values())))
    assert used & elsewhere <= brought


@pytest.mark.parametrize("name", SHEETS)
def test_sheets_stay_small(name: str) -> None:
    assert len(SHEETS[name].splitlines()) <= 300
