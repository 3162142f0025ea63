"""Run the code cells of a page in one session, as a notebook would.

The worker of the page imports this inside Pyodide; it needs nothing of the browser, so tests run
it anywhere. It speaks JSON, because nothing else crosses the border unchanged.
"""

from __future__ import annotations

import ast
import base64
import builtins
import contextlib
import importlib.util
import io
import json
import re
import sys
import warnings
from typing import TYPE_CHECKING, Any

import page_outputs
from page_errors import add_source, find_line

if TYPE_CHECKING:
    from collections.abc import Callable

#: Commands of IPython and of a shell, which are no Python.
_COMMAND = re.compile(r"^[ \t]*[%!]", re.MULTILINE)

NO_COMMANDS = (
    "Lines that begin with % or ! are commands of IPython, which the page does not have: "
    "take them out, or run the notebook."
)
NOT_LOADED = (
    "{} is no part of this page, and its files did not come: {}. "
    "Draw with labutils.figures, or run the notebook."
)
NO_INPUT = "input() has nobody to ask on a page: write the value into the cell."


class Session:
    """The names that the cells of a page share."""

    def __init__(self) -> None:
        self.names: dict[str, Any] = {"__name__": "__main__"}
        #: What the set-up cells of a page have made; code that is checked finds no more than that.
        self.given: dict[str, Any] = {}
        #: Packages that could not be loaded, and why.
        self.missing: dict[str, str] = {}

    def run(
        self, code: str, name: str, on_text: Callable[[str], None] | None = None
    ) -> list[dict[str, Any]]:
        """Run a cell.

        Parameters
        ----------
        code : str
            What stands in the cell.
        name : str
            What tracebacks call it.
        on_text : callable, optional
            Hears what is printed, while the cell runs.

        Returns
        -------
        list of dict
            The outputs, as in a notebook; an error is the last one, and has its ``line``.
        """
        page_outputs.current.begin(on_text)
        if name in page_outputs.names:
            page_outputs.names.remove(name)
        page_outputs.names.append(name)
        add_source(code, name)
        with (
            contextlib.redirect_stdout(page_outputs.Stream("stdout")),
            contextlib.redirect_stderr(page_outputs.Stream("stderr")),
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("default")
            try:
                self._execute(code, name)
                publish_figures()
            except BaseException as error:  # noqa: BLE001 - SystemExit must not end the worker either
                page_outputs.publish(self._make_error(error, code, name))
        return page_outputs.current.outputs

    def _execute(self, code: str, name: str) -> None:
        tree = ast.parse(code, name)
        last = tree.body[-1] if tree.body else None
        if not isinstance(last, ast.Expr) or code.rstrip().endswith(";"):
            self._run_statements(tree, name)
            return
        tree.body.pop()
        self._run_statements(tree, name)
        expression = compile(ast.Expression(last.value), name, "eval", dont_inherit=True)
        value = eval(expression, self.names)  # noqa: S307 - its purpose
        if value is not None:
            self.names["_"] = value
            result = {"output_type": "execute_result", "metadata": {}}
            page_outputs.publish({**result, "data": page_outputs.make_bundle(value)})

    def _run_statements(self, tree: ast.Module, name: str) -> None:
        code = compile(tree, name, "exec", dont_inherit=True)
        exec(code, self.names)  # noqa: S102 - its purpose

    def _make_error(self, error: BaseException, code: str, name: str) -> dict[str, Any]:
        output = page_outputs.make_error(error)
        text = output["traceback"][0] + self.advise(error, code)
        return {**output, "traceback": [text], "line": find_line(error, name)}

    def advise(self, error: BaseException, code: str) -> str:
        """Say what a page lacks, where that is why code stopped: a line, or nothing."""
        if isinstance(error, SyntaxError) and _COMMAND.search(code):
            return f"\n{NO_COMMANDS}"
        if isinstance(error, ModuleNotFoundError) and error.name in self.missing:
            return f"\n{NOT_LOADED.format(error.name, self.missing[error.name])}"
        return ""


def publish_figures() -> None:
    """Show the figures of Matplotlib that a cell has made, and close them, as notebooks do."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is None:
        return
    for number in pyplot.get_fignums():
        buffer = io.BytesIO()
        pyplot.figure(number).savefig(buffer, format="png", bbox_inches="tight")
        pyplot.close(number)
        data = {"image/png": base64.b64encode(buffer.getvalue()).decode("ascii")}
        data["text/plain"] = "a figure of Matplotlib"
        page_outputs.publish({"output_type": "display_data", "data": data, "metadata": {}})


def refuse_input(_prompt: object = "") -> str:
    """Stand for `input`."""
    raise RuntimeError(NO_INPUT)


#: The session of the page.
SESSION = Session()


def run(
    code: str,
    name: str,
    on_text: Callable[[str], None] | None,
    is_setup: bool,  # noqa: FBT001 - JavaScript calls this, by position
) -> str:
    """Run a cell in the session of the page; return its outputs as JSON."""
    outputs = SESSION.run(code, name, on_text)
    if is_setup:
        SESSION.given = dict(SESSION.names)
    return json.dumps(outputs)


def list_missing(code: str, optional: str) -> str:
    """List the packages that a cell imports, that are not here, and that can be loaded.

    Parameters
    ----------
    code : str
        What stands in the cell.
    optional : str
        JSON: an object whose keys are the packages that can be loaded.

    Returns
    -------
    str
        JSON: a list of names.
    """
    try:
        imported = _find_imports(ast.parse(code))
    except SyntaxError:
        imported = set()
    wanted = sorted(imported & json.loads(optional).keys())
    return json.dumps([name for name in wanted if importlib.util.find_spec(name) is None])


def _find_imports(tree: ast.AST) -> set[str]:
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module)
    return {name.partition(".")[0] for name in found}


def note_missing(name: str, reason: str) -> None:
    """Remember why a package could not be loaded; an import of it that fails will say so."""
    SESSION.missing[name] = reason


def prepare() -> None:
    """Give cells what a notebook has built in: `display`, and no `input`."""
    display = importlib.import_module("IPython.display").display  # the page's, see ipython/
    vars(builtins).update(display=display, input=refuse_input)
