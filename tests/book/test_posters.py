"""Every explorer leaves a picture for print and for readers without scripts."""

from __future__ import annotations

from types import SimpleNamespace

from docutils import nodes
from docutils.utils import new_document

from tests.helpers.scripts import load_script

HOOK = load_script("book/_ext/posters.py")


def keep_posters(*mime_types: str) -> list[nodes.Node]:
    """Run the hook on one output with these forms; return what follows the output."""
    document = new_document("page")
    bundle = nodes.container(nb_element="mime_bundle")
    for one in mime_types:
        child = nodes.image(uri="poster.png") if one == HOOK.PICTURE else nodes.raw("", "<script>")
        bundle += nodes.container("", child, mime_type=one)
    document += bundle
    document += nodes.paragraph("", "after")
    document.settings.env = SimpleNamespace()
    HOOK.KeepPosters(document).run()
    assert document[0] is bundle
    return document[1:-1]


def test_the_picture_of_a_widget_follows_it() -> None:
    (poster,) = keep_posters(HOOK.WIDGET, HOOK.PICTURE)
    assert poster["uri"] == "poster.png"
    assert poster["classes"] == [HOOK.POSTER_CLASS]


def test_other_outputs_stay_as_they_are() -> None:
    assert keep_posters(HOOK.PICTURE) == []
    assert keep_posters(HOOK.WIDGET) == []


def test_a_poster_says_which_explorer_it_stands_for() -> None:
    document = new_document("page")
    bundle = nodes.container(nb_element="mime_bundle")
    bundle += nodes.container("", nodes.raw("", "<script>"), mime_type=HOOK.WIDGET)
    bundle += nodes.container("", nodes.image(uri="poster.png"), mime_type=HOOK.PICTURE)
    code = nodes.literal_block("", "explorer = explore_depth_range(depth)")
    document += nodes.container("", code, nodes.container("", bundle), classes=["cell"])
    document.settings.env = SimpleNamespace()
    HOOK.KeepPosters(document).run()
    (poster,) = (one for one in document.findall(nodes.image) if one["classes"])
    assert poster["classes"] == [HOOK.POSTER_CLASS, f"{HOOK.POSTER_CLASS}-depth-range"]
