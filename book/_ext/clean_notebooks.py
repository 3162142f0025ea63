"""Offer each page as a notebook that has not been run.

The theme copies the notebook of a page for its download button. What that copy holds
depends on whether the page was just executed or came from the cache, and its cell ids
are random; without outputs and with numbered ids it is the same in every build.
"""

from pathlib import Path
from typing import Any

import nbformat
from sphinx.application import Sphinx


def clean(notebook: nbformat.NotebookNode) -> None:
    """Take out outputs, counts and random ids, in place."""
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number}"
        if cell.cell_type == "code":
            cell.outputs = []
            cell.execution_count = None
    notebook.metadata = {
        key: value for key, value in notebook.metadata.items() if key in ("kernelspec", "jupytext")
    }


def clean_download(
    app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Clean the notebook that the theme has just put beside the sources."""
    if name := context.get("ipynb_source"):
        path = Path(app.outdir, "_sources", name)
        notebook = nbformat.read(path, as_version=4)
        clean(notebook)
        nbformat.write(notebook, path)


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx, after the theme's (priority 500 and 501)."""
    app.connect("html-page-context", clean_download, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
