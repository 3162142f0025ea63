"""Prepare the exercise cells of a page for Python in the page.

A cell tagged ``exercise`` is followed by its check and by a box that tells how to ask for a hint;
a completion, which is tagged ``completion`` too, by its check only. They are marked, and an empty
element is put before them, which ``exercises.js`` fills with an editor. Without scripts, or without
``tools/vendor/pack_python.py``, the cells are plain.
"""

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, cast

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

from labutils.checks.table import find_words, load_table, read_completions, read_words
from live_cells import make_json_element, read_manifest

if TYPE_CHECKING:
    from sphinx.domains.std import StandardDomain

CHECK = re.compile(r'check\("(\w+)", (\w+)\)')


def find_cells(
    tree: nodes.document,
) -> Iterator[tuple[nodes.Element, ...]]:
    """Find every exercise: its cell, the cell of its check, and its hint, if it has one."""
    for cell in list(tree.findall(nodes.container)):
        if "tag_exercise" in cell["classes"]:
            place = cell.parent.index(cell)
            following = [
                node
                for node in cell.parent.children[place + 1 :]
                if not isinstance(node, nodes.comment)
            ]
            yield cell, *following[: 1 if "tag_completion" in cell["classes"] else 2]


def mark_cells(app: Sphinx, tree: nodes.document, page: str) -> None:
    """Mark the parts of every exercise on a page, and put in what the scripts fill."""
    if app.builder.format != "html":
        return
    names = []
    for cell, check, *hints in find_cells(tree):
        name = get_name(check, page)
        names.append(name)
        parent = cell.parent
        for part, node in (("source", cell), ("check", check), *(("hint", one) for one in hints)):
            node["classes"] += [f"exercise-{part}", f"exercise-{part}-{name}"]
        kind = " is-completion" if not hints else ""
        mount = f'<div class="exercise{kind}" data-exercise="{name}" hidden></div>'
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
    known = {*read_words(), *read_completions()}
    if not found or found[1] != found[2] or found[1] not in known:
        raise ExtensionError(
            f'{page}: expected check("name", name) after a cell tagged exercise, '
            f"got {check.astext()[:60]!r}"
        )
    return found[1]


def add_data(
    app: Sphinx,
    _pagename: str,
    _templatename: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Tell the scripts of a page what its exercises are; ``live_cells.py`` loads the scripts."""
    names = doctree["exercises"] if doctree is not None and "exercises" in doctree else []
    manifest = read_manifest(app)
    if not names or manifest is None:
        return
    first = next(name for name in names if name not in read_completions())
    context["first_exercise"] = f"exercise-{first.replace('_', '-')}"
    data = make_data(manifest["tables"], names) | {"titles": get_titles(app, names)}
    context["body"] += make_json_element("exercise-data", data)


def make_data(tables: dict[str, Any], names: list[str]) -> dict[str, Any]:
    """Choose what the scripts of one page have to know."""
    exercises = {
        name: {
            "hints": find_words(name)["hints"],
            "example": find_words(name)["example"],
            "parts": ["simulator"] if load_table(name).needs_mujoco else [],
            "isCompletion": name in read_completions(),
        }
        for name in names
    }
    return {"tables": {name: tables[name] for name in names}, "exercises": exercises}


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
        words = find_words(name)
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
    app.connect("doctree-resolved", mark_cells)
    app.connect("html-page-context", add_data)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
