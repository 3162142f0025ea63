"""Draw the index of terms, functions and errors: the directive ``book-index``.

What it shows is found in the pages by ``content/book_index.py``. Its body is shown only where
nobody knows the directive, in a notebook. So that the index can lead to them, the sections "Common
errors" get a label here: the name of their page and ``-errors``.
"""

from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

import labutils
from content import ROOT, book_index

HEADING = "Common errors"


class BookIndex(SphinxDirective):
    """Draw one table of the index."""

    required_arguments = 1  # which table
    has_content = True  # for readers of notebooks, see above
    option_spec: ClassVar[dict[str, Any]] = {}

    def run(self) -> list[nodes.Node]:
        """Return the table."""
        # Sphinx reads the page again when another page or the reader of pages changes
        for source in (*sorted((ROOT / "book").glob("*.md")), Path(book_index.__file__)):
            self.env.note_dependency(str(source))
        names = [name for name in labutils.__all__ if not name[0].isupper()]
        tables = book_index.make_index(names)
        (asked,) = self.arguments
        if asked not in tables:
            raise self.error(f"book-index: expected one of {[*tables]}, got {asked!r}")
        holder = nodes.Element()
        lines = StringList(tables[asked].splitlines(), self.get_source_info()[0])
        self.state.nested_parse(lines, 0, holder)
        return list(holder.children)


def label_errors(app: Sphinx, tree: nodes.document) -> None:
    """Give the section of common errors of a page a label."""
    known = app.env.get_domain("std").data
    name = app.env.docname
    for section in tree.findall(nodes.section):
        if section[0].astext() == HEADING:
            label = book_index.ERRORS.format(page=Path(name).name)
            place = section["ids"][0]
            known["labels"][label] = (name, place, HEADING)
            known["anonlabels"][label] = (name, place)  # for links with words of their own


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the directive and the hook to Sphinx."""
    app.add_directive("book-index", BookIndex)
    app.connect("doctree-read", label_errors)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
