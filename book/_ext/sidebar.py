"""Group the sidebar: each chapter with its exercises below it, always open.

The theme folds what stands below a page, behind a button that has no name and is one more stop of
the keyboard. With twelve short lines nothing needs to be folded. Beside the exercises is a place
for the count of those that are solved, which ``path.js`` fills.
"""

from typing import TYPE_CHECKING, Any

from bs4 import BeautifulSoup
from sphinx.application import Sphinx

from content.chapters import list_taught
from labutils.checks.table import read_words

if TYPE_CHECKING:
    from collections.abc import Callable

PRIORITY = 900  # after the theme has made its function


def unfold(soup: BeautifulSoup) -> None:
    """Take the folds out of a sidebar; what they hold stays."""
    for details in soup.select("li.has-children > details"):
        if details.summary is not None:
            details.summary.decompose()
        details.unwrap()


def add_counts(soup: BeautifulSoup, names: dict[str, list[str]]) -> None:
    """Put a place for a count into the links to exercise pages.

    Parameters
    ----------
    soup : BeautifulSoup
        The sidebar.
    names : dict of str to list of str
        The exercises of a page, by the link to it.
    """
    for link in soup.select("a.reference"):
        if exercises := names.get(str(link["href"])):
            place = soup.new_tag("span", attrs={"class": "path-count", "hidden": ""})
            place["data-exercises"] = " ".join(exercises)
            link.append(place)


def list_exercises() -> dict[str, list[str]]:
    """List the exercises of every exercise page, in order."""
    pages = {one.short: one.exercises for one in list_taught()}
    found: dict[str, list[str]] = {}
    for name, words in read_words().items():
        found.setdefault(pages[words["chapter"]], []).append(name)
    return found


def group_sidebar(
    _app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Wrap the function by which the theme's template makes the sidebar."""
    make: Callable[..., Any] | None = context.get("generate_toctree_html")
    if make is None:
        return
    names = {context["pathto"](page): of_page for page, of_page in list_exercises().items()}

    def make_grouped(kind: str, **options: Any) -> Any:
        made = make(kind, **options)
        if kind != "sidebar" or not isinstance(made, BeautifulSoup):
            return made
        unfold(made)
        add_counts(made, names)
        return made

    context["generate_toctree_html"] = make_grouped


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", group_sidebar, priority=PRIORITY)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
