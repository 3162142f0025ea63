"""Prepare the first screen: buttons below the photo, and the script that lifts it into 3-D.

The figure of the class ``hero`` stays a photo with its caption, for notebooks, paper and readers
without scripts. ``tools/vendor/page_hero.py`` bundles the script.
"""

from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

BUNDLE = Path("_build", "hero")  # below the source folder
SHEET, SCRIPT = "hero.css", "hero.js"
DATA = "hero_data.js"  # which the script loads
#: What a button does (`HeroActions` in book/_hero/_types.d.ts), and what it says.
BUTTONS = {
    "lift": "Lift it into 3-D",
    "ball": "Measure the ball",
    "reset": "Reset",
}
HELP = "Drag the photo to walk around in it. Click any point to read its distance."


def add_bar(app: Sphinx, tree: nodes.document, _page: str) -> None:
    """Put the buttons and the reading between a photo and its caption."""
    if app.builder.format != "html":
        return
    for figure in find_heroes(tree):
        place = next(i for i, node in enumerate(figure) if isinstance(node, nodes.caption))
        figure.insert(place, nodes.raw("", make_bar(), format="html"))


def find_heroes(tree: nodes.document) -> list[nodes.figure]:
    """Find the figures of the class."""
    return [node for node in tree.findall(nodes.figure) if "hero" in node["classes"]]


def make_bar() -> str:
    """Return the buttons; without scripts the theme hides them."""
    buttons = "".join(
        f'<button type="button" value="{value}">{text}</button>' for value, text in BUTTONS.items()
    )
    return (
        f'<div class="hero-bar pst-js-only">{buttons}'
        f'<p class="hero-reading" role="status">{HELP}</p></div>'
    )


def add_files(
    app: Sphinx, _page: str, _template: str, _context: dict[str, Any], tree: nodes.document | None
) -> None:
    """Load script and style on the page that has the photo, and on no other."""
    if tree is not None and find_heroes(tree):
        app.add_css_file(SHEET)
        app.add_js_file(SCRIPT, defer="defer")


def serve_bundle(app: Sphinx) -> None:
    """Serve the bundle as a static file."""
    app.config.html_static_path.append(str(Path(app.srcdir) / BUNDLE))


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.connect("builder-inited", serve_bundle)
    app.connect("doctree-resolved", add_bar)
    app.connect("html-page-context", add_files)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
