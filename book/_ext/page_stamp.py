"""Say under each executed page which versions computed it.

No dates and no machine names: the same commit builds the same pages.
"""

from importlib.metadata import PackageNotFoundError, version
from typing import Any

from sphinx.application import Sphinx

PACKAGES = (("MuJoCo", "mujoco"), ("OpenCV", "opencv-python-headless"), ("NumPy", "numpy"))


def stamp_html() -> str:
    """Return the line with the versions of this environment."""
    parts = []
    for name, package in PACKAGES:
        try:
            parts.append(f"{name}&nbsp;{version(package)}")
        except PackageNotFoundError:
            continue  # a build without the package runs no cell that needs it
    versions = ", ".join(parts)
    return f'<p class="page-stamp">Every number on this page was computed with {versions}.</p>\n'


def add_stamp(
    app: Sphinx, pagename: str, _templatename: str, context: dict[str, Any], _doctree: object
) -> None:
    """Append the stamp to pages that ran code."""
    is_executed = "kernelspec" in app.env.metadata.get(pagename, {})
    if is_executed and "body" in context:
        context["body"] += stamp_html()


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.connect("html-page-context", add_stamp)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
