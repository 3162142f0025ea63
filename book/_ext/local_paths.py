"""Take the folder of the repository out of the pages.

A traceback that a page shows on purpose names files by their full path, which is
different on every machine. From the repository on, it is the same everywhere.
"""

import os
from html import escape
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx


def shorten_paths(
    app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Write paths below the repository relative to it."""
    if "body" not in context:
        return
    for folder in _spellings(Path(app.srcdir)):
        context["body"] = context["body"].replace(escape(folder + os.sep), "")


def _spellings(folder: Path) -> list[str]:
    """Return the folder as written in full and, as IPython does, from the home on."""
    spellings = [str(folder)]
    if folder.is_relative_to(Path.home()):
        spellings.append(str(Path("~", folder.relative_to(Path.home()))))
    return spellings


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", shorten_paths)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
