"""Keep a picture beside every explorer, for print and for readers without scripts.

An explorer gives its poster as PNG next to the widget. Of the two, myst-nb shows the widget only;
here the picture stays too. ``explorers.css`` hides it where the explorer itself is drawn, and keeps
the explorer's place by the class that names it.
"""

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

WIDGET = "application/vnd.jupyter.widget-view+json"
PICTURE = "image/png"
POSTER_CLASS = "explorer-poster"
CALL = re.compile(r"\bexplore_(\w+)\(")


class KeepPosters(SphinxPostTransform):
    """Copy the picture of a widget behind it."""

    default_priority = 3  # before myst-nb keeps the best form of each output, at 4
    formats = ("html",)

    def run(self, **_options: Any) -> None:
        """Look at every output that comes in both forms."""
        for bundle in list(self.document.findall(_is_output)):
            forms = {form["mime_type"]: form for form in bundle.children}
            if WIDGET not in forms or PICTURE not in forms:
                continue
            copies = [child.deepcopy() for child in forms[PICTURE].children]
            for picture in (one for child in copies for one in child.findall(nodes.image)):
                picture["classes"] += [POSTER_CLASS, *_name_explorer(bundle)]
            bundle.parent.insert(bundle.parent.index(bundle) + 1, copies)


def _name_explorer(bundle: nodes.Element) -> list[str]:
    """Return the class that names the explorer which the cell of an output makes."""
    cell = bundle.parent
    while cell is not None and "cell" not in cell.get("classes", ()):
        cell = cell.parent
    called = CALL.findall(cell.astext()) if cell is not None else []
    return [f"{POSTER_CLASS}-{called[-1].replace('_', '-')}"] if called else []


def _is_output(node: nodes.Node) -> bool:
    return isinstance(node, nodes.container) and node.get("nb_element") == "mime_bundle"


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hook to Sphinx."""
    app.add_post_transform(KeepPosters)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
