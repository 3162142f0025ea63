"""Play a video where its poster stands.

A figure of the class ``video`` shows a poster; the video has the same name and lies beside it in
``_static``. On the page a player takes the place of the picture, which loads nothing before it is
asked to. In notebooks and on paper the picture stays. A page with no such figure loads nothing.
"""

import html
from pathlib import Path, PurePosixPath
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

SHEET = "video.css"
CLASS, POSTER_CLASS = "video", "video-poster"
VIDEO_SUFFIX = ".webm"
STATIC = "_static"  # below the page's folder in the source, beside it on the site


def add_players(app: Sphinx, tree: nodes.document, page: str) -> None:
    """Put a player before each poster, and mark the poster as what paper shows."""
    if app.builder.format != "html":
        return
    for figure in find_videos(tree):
        image = next(figure.findall(nodes.image))
        poster = PurePosixPath(image["uri"])
        video = Path(app.srcdir, poster.with_suffix(VIDEO_SUFFIX))
        if not video.is_file():
            raise FileNotFoundError(f"{page}: expected a video {video.name} beside {poster.name}")
        up = "../" * page.count("/")
        player = make_player(
            f"{up}{STATIC}/{video.name}", f"{up}{STATIC}/{poster.name}", image["alt"]
        )
        image["classes"].append(POSTER_CLASS)
        figure.insert(figure.index(image), nodes.raw("", player, format="html"))


def find_videos(tree: nodes.document) -> list[nodes.figure]:
    """Find the figures of the class."""
    return [node for node in tree.findall(nodes.figure) if CLASS in node["classes"]]


def make_player(video: str, poster: str, words: str) -> str:
    """Return a player with the browser's own buttons, which keys reach."""
    named = html.escape(words, quote=True)
    return (
        f'<video class="video-player" controls preload="none" playsinline muted '
        f'src="{video}" poster="{poster}" aria-label="{named}"></video>'
    )


def add_sheet(
    app: Sphinx, _page: str, _template: str, _context: dict[str, Any], tree: nodes.document | None
) -> None:
    """Load the style on pages that have a video, and on no other."""
    if tree is not None and find_videos(tree):
        app.add_css_file(SHEET)


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.connect("doctree-resolved", add_players)
    app.connect("html-page-context", add_sheet)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
