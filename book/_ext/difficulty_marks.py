"""Hide the dots of a difficulty from screen readers: the word beside them says the same."""

from typing import Any

from sphinx.application import Sphinx

from content.difficulty import LEVELS


def wrap_marks(body: str) -> str:
    """Wrap the dots in the HTML of a page."""
    for level in LEVELS:
        mark = f'<span class="difficulty" aria-hidden="true">{level.mark}</span>'
        body = body.replace(level.mark, mark)
    return body


def mark_page(
    _app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Wrap the dots of a page."""
    if "body" in context:
        context["body"] = wrap_marks(context["body"])


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", mark_page)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
