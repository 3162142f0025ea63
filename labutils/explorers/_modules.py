"""Join the ES modules of a view, and its style sheets, into the one text that anywidget takes.

A view and what it imports are ordinary ES modules, so that Node can test each by itself. The page
gets them as one text: a module cannot import its neighbor from a text, nor from a file opened
without a server.
"""

from __future__ import annotations

import re
from pathlib import Path

#: Where the modules and the style sheet lie.
STATIC = Path(__file__).with_name("static")

_IMPORT = re.compile(r'^import \{[^}]*\} from "\./(?P<name>\w+)\.js";\n', re.MULTILINE)
_ANY_IMPORT = re.compile(r"^import\b.*$", re.MULTILINE)
_EXPORT = re.compile(r"^export (?!default\b)", re.MULTILINE)


def join_modules(name: str) -> str:
    """Return the module `name` behind everything it imports.

    All names of all modules share one scope, so no two modules may use the same name at their top
    level, nor rename what they import.

    Parameters
    ----------
    name : str
        A file in ``static`` without its ending.

    Returns
    -------
    str
        One ES module; its default export is the view's.

    Raises
    ------
    ValueError
        If an import is written in another form than ``import { a, b } from "./name.js";``.
    """
    order: list[str] = []

    def visit(module: str, above: tuple[str, ...] = ()) -> None:
        if module in above:
            raise ValueError(f"modules: expected no circle, got {' -> '.join((*above, module))}")
        if module in order:
            return
        for found in _IMPORT.finditer(_read(module)):
            visit(found["name"], (*above, module))
        order.append(module)

    visit(name)
    return "\n".join(_strip(module) for module in order)


def join_styles(*names: str) -> str:
    """Return the style sheet of all explorers, and those of the parts a view shows."""
    return "\n".join((STATIC / f"{one}.css").read_text("utf-8") for one in ("explorer", *names))


def _read(name: str) -> str:
    return (STATIC / f"{name}.js").read_text(encoding="utf-8")


def _strip(name: str) -> str:
    """Take out the imports, which have become neighbors, and the word export."""
    text = _EXPORT.sub("", _IMPORT.sub("", _read(name)))
    if left := _ANY_IMPORT.search(text):
        raise ValueError(f'{name}.js: expected import {{ a, b }} from "./name.js"; got {left[0]!r}')
    return text
