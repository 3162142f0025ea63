"""What the book says about other robots is what `make foreign` found, and all of it is right."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.foreign import report
from tests.foreign.views import VIEWS, View
from tests.helpers.chapters import ROOT

TABLE = ROOT / "book" / "_generated" / "foreign.md"


def test_the_page_shows_the_table() -> None:
    page = (ROOT / "book" / "evidence.md").read_text(encoding="utf-8")
    assert f"```{{include}} {TABLE.relative_to(ROOT / 'book').as_posix()}\n```" in page


def test_the_table_has_the_cameras_that_there_are_and_no_pixel_that_differs() -> None:
    text = TABLE.read_text(encoding="utf-8")
    assert text.startswith(report.MADE_BY)
    assert report.read_table(text) == dict.fromkeys(VIEWS, 0), "run `make foreign`"


def test_rows_are_read_back_with_the_peer_of_their_table() -> None:
    row = "| `b.c-v5` `d_e` | tracking | 12 | 0.1 | 0.1 | 0.1 | 0.0 % | same |"
    text = f":::{{table}} a: 1 cameras\n{row}\n:::\n\n:::{{table}} Clouds\n| `b` `d` | 0.1 |\n:::\n"
    assert report.read_table(text) == {View("a", "b.c-v5", "d_e"): 12}


def test_the_room_is_collected_in_its_own_environment_only(request: pytest.FixtureRequest) -> None:
    room = ROOT / "tests" / "foreign"
    assert not [item for item in request.session.items if item.path.is_relative_to(room)]
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "tests/foreign"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == pytest.ExitCode.USAGE_ERROR
    assert "tests/foreign needs dm_control, robosuite and gymnasium: run `make foreign`" in (
        done.stdout + done.stderr
    )
