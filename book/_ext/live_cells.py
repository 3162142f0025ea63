"""Make the code cells of the pages live: load what runs them, and tell it what it has to know.

Only pages with code cells load the scripts of ``book/_page_python``; Python itself comes on the
first click. Without scripts, or without ``tools/vendor/pack_python.py``, the cells are plain.
"""

import json
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

PACKED = Path("_build", "page_python")  # below the source folder, like the manifest
MANIFEST = Path("_build", "page_python.json")
FOLDER = "_static/python"
# in this order: what comes later finds what came before in `cameraLab`
SCRIPTS = (
    "elements.js",
    "assets.js",
    "python.js",
    "cell_edits.js",
    "cell_outputs.js",
    "session.js",
    "cell_result.js",
    "cells.js",
)
LAST_SCRIPTS = ("cells_bar.js",)
# the editor brings its own name
EXERCISE_SCRIPTS = (
    "editor.js",
    "progress_rules.js",
    "progress.js",
    "verdicts.js",
    "exercise_buttons.js",
    "exercise_tabs.js",
    "exercise_way_on.js",
    "exercises.js",
    "exercise_bar.js",
)


def add_packed_folder(app: Sphinx) -> None:
    """Serve the scripts and assets; see ``offline.py`` for why not in ``_config.yml``."""
    if read_manifest(app) is not None:
        app.config.html_static_path.append(str(Path(app.srcdir) / PACKED))


def read_manifest(app: Sphinx) -> dict[str, Any] | None:
    """Return what the packer has written down, or None where it has not packed."""
    path = Path(app.srcdir) / MANIFEST
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None


def has_code(tree: nodes.document) -> bool:
    """Tell whether a page has code cells."""
    return any("cell_input" in node["classes"] for node in tree.findall(nodes.container))


def add_scripts(
    app: Sphinx,
    pagename: str,
    _templatename: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Load the scripts, and give them what they have to know, on pages with code cells."""
    manifest = read_manifest(app)
    if doctree is None or manifest is None or not has_code(doctree):
        return
    known = ("version", "parts", "remote", "optional", "lock")
    data = {key: manifest[key] for key in known}
    data |= {"base": context["pathto"](f"{FOLDER}/", 1), "page": pagename}
    context["body"] += make_json_element("python-data", data)
    exercise_scripts = EXERCISE_SCRIPTS if doctree.get("exercises") else ()
    for script in (*SCRIPTS, *exercise_scripts, *LAST_SCRIPTS):
        app.add_js_file(f"{FOLDER.removeprefix('_static/')}/{script}", defer="defer")


def make_json_element(name: str, data: dict[str, Any]) -> str:
    """Return an element that holds data for scripts."""
    # "</" would end the element
    text = json.dumps(data, sort_keys=True, separators=(",", ":")).replace("</", "<\\/")
    return f'<script type="application/json" id="{name}">{text}</script>\n'


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.connect("builder-inited", add_packed_folder)
    app.connect("html-page-context", add_scripts)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
