"""Every name of MuJoCo that the book, the library and the exercises use is there in the page."""

from __future__ import annotations

import re
from typing import Any

import pytest

from tools import ROOT

#: Where learners and the library take names from.
PLACES = (
    "book/*.md",
    "exercises/*.md",
    "exercises/_generated/*.py",
    "labutils/**/*.py",
    "solutions/**/*.py",
)
USE = re.compile(r"\bmujoco\.((?:mj|Mj|GL|Renderer|Fatal)\w*)(?:\.(\w+))?")

#: What is used where OpenGL draws, and nowhere else: `labutils.renderers.opengl`.
OPENGL = {"GLContext", "MjrContext", "MjrRect", "mjr_readPixels", "mjr_render", "mjr_setBuffer"}
#: In words, not in code: names of other libraries' tutorials, and a family of functions.
WORDS = {"mj_", "mjr_", "mju_", "mjv_"}


def find_used() -> dict[str, set[str]]:
    """Return the names that are used, and what is taken from them, such as a member of an enum."""
    found: dict[str, set[str]] = {}
    for pattern in PLACES:
        for path in ROOT.glob(pattern):
            for name, part in USE.findall(path.read_text(encoding="utf-8")):
                found.setdefault(name, set()).add(part)
    return found


@pytest.fixture(scope="module")
def known(page_said: dict[str, Any]) -> dict[str, list[str]]:
    names: dict[str, list[str]] = page_said["names"]["list_names"]["value"]
    return names


def test_every_name_that_is_used_is_there(known: dict[str, list[str]]) -> None:
    used = find_used()
    assert len(used) > 25
    assert set(used) - set(known) - WORDS == OPENGL


def test_every_member_of_an_enum_that_is_used_is_there(known: dict[str, list[str]]) -> None:
    for name, parts in find_used().items():
        if name.startswith("mjt"):
            assert {part for part in parts if part.startswith("mj")} <= set(known[name]), name


def test_nothing_but_what_is_meant_is_public(known: dict[str, list[str]]) -> None:
    own = re.compile(r"mj|Mj|__|Renderer$|FatalError$|UnexpectedError$")
    assert [name for name in known if not own.match(name)] == []
