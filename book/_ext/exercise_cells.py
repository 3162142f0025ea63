"""Prepare the exercise cells of a page for Python in the page.

A cell tagged ``exercise`` is followed by its check and by a box that tells how to ask for a hint.
They are marked, and an empty element is put before them, which ``exercises.js`` fills with an
editor. Exercises that need MuJoCo get a note instead: no browser has it. Only pages with exercises
load the scripts; without these, or without ``tools/vendor/pack_python.py``, they are plain.
"""

import json
import re
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

from labutils.checks.table import load_table, read_words

if TYPE_CHECKING:
    from sphinx.domains.std import StandardDomain

PACKED = Path("_build", "page_python")  # below the source folder, like the manifest
MANIFEST = Path("_build", "page_python.json")
FOLDER = "_static/python"
# in this order; the editor brings its own name, the others share `cameraLab`
SCRIPTS = (
    "editor.js",
    "progress_rules.js",
    "progress.js",
    "python.js",
    "exercises.js",
    "exercise_bar.js",
)
CHECK = re.compile(r'check\("(\w+)", (\w+)\)')

NEEDS_MUJOCO = (
    '<p class="exercise-note">This exercise needs MuJoCo, which no browser has. Work on it in a '
    'notebook: <a href="{notebook}" download>download this page as a notebook</a>, or use the '
    'launch button at the top. How to run it is in <a href="{start}">Start here</a>.</p>'
)


def add_packed_folder(app: Sphinx) -> None:
    """Serve the scripts and assets; see ``offline.py`` for why not in ``_config.yml``."""
    if (Path(app.srcdir) / MANIFEST).is_file():
        app.config.html_static_path.append(str(Path(app.srcdir) / PACKED))


def find_cells(
    tree: nodes.document,
) -> Iterator[tuple[nodes.Element, ...]]:
    """Find every exercise: its cell, the cell of its check, and its hint."""
    for cell in list(tree.findall(nodes.container)):
        if "tag_exercise" in cell["classes"]:
            place = cell.parent.index(cell)
            following = [
                node
                for node in cell.parent.children[place + 1 :]
                if not isinstance(node, nodes.comment)
            ]
            yield cell, *following[:2]


def mark_cells(app: Sphinx, tree: nodes.document, page: str) -> None:
    """Mark the parts of every exercise on a page, and put in what the scripts fill."""
    if app.builder.format != "html":
        return
    names = []
    for cell, check, hint in find_cells(tree):
        name = get_name(check, page)
        names.append(name)
        parent = cell.parent
        if load_table(name).needs_mujoco:
            parent.insert(parent.index(cell), nodes.raw("", make_note(app, page), format="html"))
            continue
        for part, node in (("source", cell), ("check", check), ("hint", hint)):
            node["classes"] += [f"exercise-{part}", f"exercise-{part}-{name}"]
        mount = f'<div class="exercise" data-exercise="{name}" hidden></div>'
        parent.insert(parent.index(cell), nodes.raw("", mount, format="html"))
    if names:
        bar = nodes.raw("", '<div class="exercise-bar" hidden></div>', format="html")
        top = next(tree.findall(nodes.section))
        first = next(i for i, node in enumerate(top.children) if isinstance(node, nodes.section))
        top.insert(first, bar)
    tree["exercises"] = names


def get_name(check: nodes.Element, page: str) -> str:
    """Read which exercise a check cell is of.

    Raises
    ------
    ExtensionError
        If what follows an exercise cell is not its check.
    """
    found = CHECK.search(check.astext())
    if not found or found[1] != found[2] or found[1] not in read_words():
        raise ExtensionError(
            f'{page}: expected check("name", name) after a cell tagged exercise, '
            f"got {check.astext()[:60]!r}"
        )
    return found[1]


def make_note(app: Sphinx, page: str) -> str:
    """Return the note of an exercise that a page cannot check."""
    up = "../" * page.count("/")
    notebook = escape(f"{up}_sources/{page}.ipynb")
    return NEEDS_MUJOCO.format(
        notebook=notebook, start=app.builder.get_relative_uri(page, "book/start")
    )


def add_scripts(
    app: Sphinx,
    _pagename: str,
    _templatename: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Load the scripts, and give them what they have to know, on pages with exercises."""
    names = doctree["exercises"] if doctree is not None and "exercises" in doctree else []
    manifest_file = Path(app.srcdir) / MANIFEST
    if not names or not manifest_file.is_file():
        return
    manifest = json.loads(manifest_file.read_text(encoding="utf-8"))
    data = make_data(manifest, names, context["pathto"](f"{FOLDER}/", 1))
    data["titles"] = get_titles(app, names)
    # "</" would end the element
    text = json.dumps(data, sort_keys=True).replace("</", "<\\/")
    context["body"] += f'<script type="application/json" id="exercise-data">{text}</script>\n'
    for script in SCRIPTS:
        app.add_js_file(f"{FOLDER.removeprefix('_static/')}/{script}", defer="defer")


def make_data(manifest: dict[str, Any], names: list[str], base: str) -> dict[str, Any]:
    """Choose what the scripts of one page have to know."""
    words = read_words()
    tables = {name: manifest["tables"][name] for name in names if name in manifest["tables"]}
    shared = {key: manifest[key] for key in ("version", "assets", "bytes", "remote", "lock")}
    exercises = {name: {"hints": words[name]["hints"]} for name in names}
    return {**shared, "base": base, "tables": tables, "exercises": exercises}


def get_titles(app: Sphinx, names: list[str]) -> dict[str, str]:
    """Return the headings of the places that the verdicts of exercises link to.

    Raises
    ------
    ExtensionError
        If the book has no such section.
    """
    domain = cast("StandardDomain", app.env.get_domain("std"))
    titles = {}
    for name in names:
        words = read_words()[name]
        for link in (words["section"], *words["links"].values()):
            label = link.partition("#")[2]
            if label not in domain.anonlabels:
                raise ExtensionError(f"{name}: its check links to {link}, which is nowhere")
            # a place that is no heading has no title of its own
            page = domain.anonlabels[label][0]
            known = domain.labels.get(label)
            titles[link] = known[2] if known else app.env.titles[page].astext()
    return titles


def setup(app: Sphinx) -> dict[str, Any]:
    """Connect the hooks to Sphinx."""
    app.connect("builder-inited", add_packed_folder)
    app.connect("doctree-resolved", mark_cells)
    app.connect("html-page-context", add_scripts)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
