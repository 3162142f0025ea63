"""Leave out what the theme brings and no page uses.

Files: source maps, translations, the fonts and the script that ``icons.py`` replaces.
Tags: the settings of Thebe.
"""

import re
import shutil
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

UNUSED = (
    "locales",
    "scripts/*.map",
    "scripts/fontawesome.js*",
    "styles/*.map",
    "vendor/fontawesome",
    "*macros.html",
    "sphinx-thebe.*",
)
THEBE = re.compile(
    r'\s*<script type="text/x-thebe-config">.*?</script>\s*<script>kernelName = [^<]*</script>',
    re.DOTALL,
)


def drop_tags(
    _app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Take the settings of Thebe out of a page, and its style sheet."""
    if "body" in context:
        context["body"] = THEBE.sub("", context["body"])
    if (sheets := context.get("css_files")) is not None:
        sheets[:] = [sheet for sheet in sheets if "sphinx-thebe" not in str(sheet.filename)]


def drop_files(app: Sphinx, exception: Exception | None) -> None:
    """Remove what the theme has copied."""
    if exception or app.builder.name != "html":
        return
    for pattern in UNUSED:
        for path in Path(app.outdir, "_static").glob(pattern):
            shutil.rmtree(path) if path.is_dir() else path.unlink()


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx, after those that add to a page and read the files."""
    app.connect("html-page-context", drop_tags, priority=900)
    app.connect("build-finished", drop_files, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
