"""Draw the pipeline strip at the top of each step: scene > RGB-D > K > ... > view.

The strip is a navigation landmark: every stage is a link, the stage of the page
carries ``aria-current="step"``.
"""

from collections.abc import Callable, Collection
from html import escape
from typing import Any

from sphinx.application import Sphinx

from content.chapters import READING, load_chapters

STAGES = tuple((one.strip, one.page) for one in load_chapters() if one.strip)
#: The scene is where the strip starts, but its page carries none.
PAGES = {one.page for one in load_chapters() if one.strip and one.kind != READING}


def strip_html(current: str, pages: Collection[str], link_to: Callable[[str], str]) -> str:
    """Return the strip for one page.

    Parameters
    ----------
    current : str
        Name of the page that is drawn.
    pages : collection of str
        Names of the pages in the book; a stage without its page is plain text.
    link_to : callable
        Turns a page name into a relative link.
    """
    items = []
    for label, page in STAGES:
        text = escape(label)
        if page not in pages:
            items.append(f"<li><span>{text}</span></li>")
            continue
        mark = ' aria-current="step"' if page == current else ""
        items.append(f'<li><a href="{escape(link_to(page))}"{mark}>{text}</a></li>')
    return (
        '<nav class="pipeline-strip" aria-label="Pipeline"><ol role="list">'
        + "".join(items)
        + "</ol></nav>\n"
    )


def add_strip(
    app: Sphinx, pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Put the strip above the title of a chapter."""
    if pagename in PAGES and "body" in context:
        strip = strip_html(pagename, app.env.found_docs, context["pathto"])
        context["body"] = strip + context["body"]


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", add_strip)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
