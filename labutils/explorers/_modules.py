"""Join the ES modules of a view, and its style sheets, into the one text that anywidget takes.

A view and what it imports are ordinary ES modules, so that Node can test each by itself. The page
gets them as one text: a module cannot import its neighbor from a text, nor from a file opened
without a server. In it every module is a function that is called once and hands out its exports,
so that each keeps its names for itself::

    const $_camera = (() => {
    function focalFromFov(...) { ... }
    return { focalFromFov };
    })();
    const $fov = (() => {
    const { focalFromFov: find } = $_camera;  // import { focalFromFov as find } from "./_camera.js"
    ...
"""

from __future__ import annotations

import re
from pathlib import Path

#: Where the modules and the style sheet lie.
STATIC = Path(__file__).with_name("static")
#: What every view has around its own.
_SHEETS = ("explorer", "layout", "controls", "goal")

_IMPORT = re.compile(r'^import \{(?P<names>[^}]*)\} from "\./(?P<module>\w+)\.js";\n', re.MULTILINE)
_EXPORT = re.compile(
    r"^export (?P<kind>(?:async )?function |const )(?P<names>\[[^\]]*\]|\w+)", re.MULTILINE
)
_DEFAULT = re.compile(r"^export default ", re.MULTILINE)
_LEFT = re.compile(r"^(?:import|export)\b.*$", re.MULTILINE)
# for who reads the files, and for TypeScript: a page need not carry it
_DOCS = re.compile(r"^[ \t]*/\*\*.*?\*/\n", re.MULTILINE | re.DOTALL)


def join_modules(name: str) -> str:
    """Return the module `name` behind everything it imports.

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
        If modules import each other, or one imports or exports in another form than
        ``import { a, b as c } from "./name.js";``, ``export function a``, ``export const a``,
        ``export const [a, b]`` and ``export default``.
    """
    order: dict[str, str] = {}

    def visit(module: str, above: tuple[str, ...] = ()) -> None:
        if module in above:
            raise ValueError(f"modules: expected no circle, got {' -> '.join((*above, module))}")
        if module in order:
            return
        text = (STATIC / f"{module}.js").read_text(encoding="utf-8")
        for found in _IMPORT.finditer(text):
            visit(found["module"], (*above, module))
        order[module] = _wrap(module, text)

    visit(name)
    return "\n".join([*order.values(), f"export default ${name}.default;\n"])


def join_styles(*names: str) -> str:
    """Return the style sheets of all explorers, and those of the parts a view shows."""
    return "\n".join((STATIC / f"{one}.css").read_text("utf-8") for one in (*_SHEETS, *names))


def _wrap(module: str, text: str) -> str:
    """Turn a module into a function that takes what it imports and returns what it exports."""
    taken = [
        f"const {{{found['names'].replace(' as ', ': ')}}} = ${found['module']};\n"
        for found in _IMPORT.finditer(text)
    ]
    given = [one for found in _EXPORT.finditer(text) for one in re.findall(r"\w+", found["names"])]
    given += ["default: $default"] * len(_DEFAULT.findall(text))
    body = _IMPORT.sub("", _DOCS.sub("", text))
    body = _DEFAULT.sub("const $default = ", _EXPORT.sub(r"\g<kind>\g<names>", body))
    if left := _LEFT.search(body):
        raise ValueError(
            f'{module}.js: expected import {{ a, b as c }} from "./name.js"; and export before '
            f"function or const; got {left[0]!r}"
        )
    head = f"const ${module} = (() => {{\n{''.join(taken)}"
    return f"{head}{body.strip()}\nreturn {{ {', '.join(given)} }};\n}})();\n"
