"""Keep the built book self-contained: no page asks another host for anything.

The front-end files lie in ``_build/vendor`` (see ``tools/vendor/frontend.py``).
"""

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

VENDOR = Path("_build", "vendor")  # below the source folder


def add_vendor_folder(app: Sphinx) -> None:
    """Serve the vendored files as static files.

    Done here and not in ``html_static_path`` of ``_config.yml``, because Jupyter
    Book may turn every script of a folder named there into a tag on every page.
    """
    app.config.html_static_path.append(str(Path(app.srcdir) / VENDOR))


def drop_thebe(
    _app: Sphinx, _pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Take out the scripts of sphinx-thebe, which nobody here uses.

    Jupyter Book loads the extension and so does the theme: the second copy declares
    the same constant again, which is an error in the console of every page.
    """
    scripts = context.get("script_files")
    if scripts is not None:
        scripts[:] = [script for script in scripts if not _belongs_to_thebe(script)]


def _belongs_to_thebe(script: object) -> bool:
    body = getattr(script, "attributes", {}).get("body") or ""
    name = str(getattr(script, "filename", script))
    return "THEBE_JS_URL" in body or "sphinx-thebe" in name


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.connect("builder-inited", add_vendor_folder)
    # after the theme (default priority 500) has added its scripts
    app.connect("html-page-context", drop_thebe, priority=900)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
