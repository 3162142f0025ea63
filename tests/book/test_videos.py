"""A figure of the class plays a video on the screen, and shows its poster elsewhere."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from docutils import nodes

from tests.helpers.scripts import load_script

HOOK = load_script("book/_ext/videos.py")


def make_app(folder: Path, builder: str = "html") -> Any:
    """Make what the hook asks of Sphinx."""

    class App:
        srcdir = str(folder)

    App.builder = type("Builder", (), {"format": builder})  # type: ignore[attr-defined]
    return App


def make_tree(*classes: str) -> nodes.section:
    """Make a page with one figure."""
    image = nodes.image(uri="book/_static/some.webp", alt='A "fine" motion')
    return nodes.section("", nodes.figure("", image, nodes.caption("", "text"), classes=[*classes]))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A source folder with a video."""
    static = tmp_path / "book" / "_static"
    static.mkdir(parents=True)
    (static / "some.webm").touch()
    return tmp_path


def test_a_player_stands_before_its_poster_and_waits_to_be_asked(folder: Path) -> None:
    tree = make_tree("video")
    HOOK.add_players(make_app(folder), tree, "book/page")
    player, image, caption = tree.children[0].children
    text = player.astext()
    assert 'src="../_static/some.webm"' in text
    assert 'poster="../_static/some.webp"' in text
    assert 'preload="none"' in text
    assert " controls " in text
    assert 'aria-label="A &quot;fine&quot; motion"' in text
    assert HOOK.POSTER_CLASS in image["classes"]
    assert isinstance(caption, nodes.caption)


def test_other_figures_and_other_formats_stay_as_they_are(folder: Path) -> None:
    for tree, builder in ((make_tree(), "html"), (make_tree("video"), "latex")):
        HOOK.add_players(make_app(folder, builder), tree, "book/page")
        assert len(tree.children[0].children) == 2


def test_a_poster_without_its_video_is_told(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"book/page: expected a video some\.webm beside"):
        HOOK.add_players(make_app(tmp_path), make_tree("video"), "book/page")
