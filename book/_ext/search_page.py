"""Put the book's own search in the place of Sphinx's.

Sphinx orders pages roughly, and fetches its excerpts, which browsers forbid to a page that was
opened from a file. Here the search page alone loads an index (``search_index.py``), MiniSearch
(``tools/vendor/frontend.py``) and the scripts that ask it; all pages load ``search_marks.js``,
which marks on the page what was searched for.
"""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from sphinx.application import Sphinx

if TYPE_CHECKING:
    from sphinx.builders.html import StandaloneHTMLBuilder

PAGE = "search"
# in this order: what comes later finds what came before
SCRIPTS = ("minisearch/index.js", "search_index.js", "search_engine.js", "search_page.js")
MARKS = "search_marks.js"
#: What Sphinx brings for its own search.
SPHINX_FILES = ("searchtools.js", "language_data.js", "sphinx_highlight.js")
TAGS = re.compile(
    r'\s*<script src="[^"]*(?:_static/searchtools|_static/language_data|searchindex)\.js"></script>'
)


def switch_off(app: Sphinx) -> None:
    """Let Sphinx make neither index nor search page, and load our marks on every page."""
    if app.builder.name == "html":
        cast("StandaloneHTMLBuilder", app.builder).search = False
        app.add_js_file(MARKS, defer="defer")


def add_page(app: Sphinx) -> Iterator[tuple[str, dict[str, Any], str]]:
    """Name the search page, which no source file stands for."""
    if app.builder.name == "html":
        yield PAGE, {}, "search.html"


def load_scripts(
    app: Sphinx, pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Load what searches where it is needed, and Sphinx's marks nowhere."""
    if pagename == PAGE:
        for script in SCRIPTS:
            app.add_js_file(script, defer="defer")
    if (scripts := context.get("script_files")) is not None:
        scripts[:] = [one for one in scripts if not _belongs_to_sphinx(one)]


def _belongs_to_sphinx(script: object) -> bool:
    return Path(str(getattr(script, "filename", script))).name in SPHINX_FILES


def drop_files(app: Sphinx, exception: Exception | None) -> None:
    """Remove what Sphinx has copied for its own search, and the tags that the theme has written."""
    if exception or app.builder.name != "html":
        return
    for name in SPHINX_FILES:
        Path(app.outdir, "_static", name).unlink(missing_ok=True)
    for path in Path(app.outdir).rglob("*.html"):
        html = path.read_text(encoding="utf-8")
        if (lean := TAGS.sub("", html)) != html:
            path.write_text(lean, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.connect("builder-inited", switch_off)
    app.connect("html-collect-pages", add_page)
    # before Sphinx writes the tags, after it has listed its own scripts
    app.connect("html-page-context", load_scripts, priority=900)
    app.connect("build-finished", drop_files)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
