"""Fold away what only the curious need: sections whose heading begins with "For the curious".

The heading and the first paragraph, which says what the rest is good for, stay. The rest becomes a
``details`` element of HTML: it opens without a script, a search in the page and a link into it open
it too, and on paper it is open. A notebook and other builders show the section as it stands.
"""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.writers.html5 import HTML5Translator

BEGINS = "For the curious"
SUMMARY = "Show this part"


# docutils has no types
class Folded(nodes.General, nodes.Element):  # type: ignore[misc]
    """What is folded away."""


def fold_sections(_app: Sphinx, tree: nodes.document, docname: str) -> None:
    """Fold the sections of a page.

    Raises
    ------
    ExtensionError
        If such a section does not begin with a paragraph, or nothing is left to fold.
    """
    for section in list(tree.findall(nodes.section)):
        if not section[0].astext().startswith(BEGINS):
            continue
        first, *rest = section.children[1:] or [None]
        if not isinstance(first, nodes.paragraph) or not rest:
            raise ExtensionError(
                f"{docname}, {section[0].astext()!r}: expected a paragraph that stays, then more"
            )
        for child in rest:
            section.remove(child)
        section.append(Folded("", *rest))


def open_fold(translator: HTML5Translator, _node: Folded) -> None:
    """Begin the element."""
    translator.body.append(f'<details class="curious">\n<summary>{SUMMARY}</summary>\n')


def close_fold(translator: HTML5Translator, _node: Folded) -> None:
    """End the element."""
    translator.body.append("</details>\n")


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx, after those that look at the sections of a page."""
    app.add_node(Folded, html=(open_fold, close_fold))
    app.connect("doctree-resolved", fold_sections, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
