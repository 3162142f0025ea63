"""Run the code of an exercise cell and check it, as a notebook would.

The worker of the page imports this inside Pyodide; it needs nothing of the browser, so tests run
it anywhere. It speaks JSON, because nothing else crosses the border unchanged.
"""

from __future__ import annotations

import io
import json
import warnings
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Any

import page_cells
import page_outputs
from labutils import check, hint, report
from labutils.checks.progress_rules import FILE_NAME
from page_errors import add_source, describe, find_line
from page_outputs import MAX_PRINTED, TOO_MUCH

if TYPE_CHECKING:
    from collections.abc import Callable

#: What a traceback calls the reader's code.
FILE = "your code"


class Printed(io.StringIO):
    """Keep what is printed, up to a limit, and tell it at once: code may be stopped later."""

    def __init__(self, on_text: Callable[[str], object] | None) -> None:
        super().__init__()
        self.is_full = False
        self._on_text = on_text

    def write(self, text: str) -> int:
        """Write, or drop what is beyond the limit."""
        if self.is_full or not text:
            return len(text)
        kept = text[: MAX_PRINTED - self.tell()]
        if self.tell() + len(kept) >= MAX_PRINTED:
            self.is_full = True
            kept += TOO_MUCH
        super().write(kept)
        if self._on_text is not None:
            self._on_text(kept)
        return len(text)


def run(code: str, name: str, progress: str, on_text: Callable[[str], object] | None = None) -> str:
    """Run code in a namespace of its own, check the function in it, and tell what happened.

    Parameters
    ----------
    code : str
        The reader's.
    name : str
        The exercise, which is the name of the function to check.
    progress : str
        Content of the progress file before; empty for none.
    on_text : callable, optional
        Hears what is printed, while the code runs.

    Returns
    -------
    str
        JSON: ``result`` ("passed", "failed", "not checked" or "error"), ``headline``, ``html`` of
        the verdict, ``printed``, ``error``, the ``progress`` file after, the ``line`` of the
        code at which it stopped, and ``missing``: a name that the code asks for and that nothing
        has made, for which the page may run its set-up.
    """
    said: dict[str, Any] = {
        "result": "error",
        "headline": "",
        "html": "",
        "error": "",
        "line": None,
    }
    path = Path.cwd() / FILE_NAME
    path.unlink(missing_ok=True)
    if progress:
        path.write_text(progress, encoding="utf-8")
    printed = Printed(on_text)
    page_outputs.current.begin()  # what the code shows belongs to Run, and is not kept here
    with redirect_stdout(printed), redirect_stderr(printed), warnings.catch_warnings():
        namespace, error = run_cell(code)
        if error:
            said["error"] = describe(error, FILE) + page_cells.SESSION.advise(error, code)
            said["line"] = find_line(error, FILE)
            said["missing"] = error.name if isinstance(error, NameError) else None
        if not said["error"] and not callable(namespace.get(name)):
            said["error"] = f"Your code has no function {name}: keep its name as it was."
        if not said["error"]:
            verdict = check(name, namespace[name])
            said |= {
                "result": verdict.result,
                "headline": verdict.headline,
                "html": verdict._repr_html_(),
                "line": verdict.line,
            }
    said["printed"] = printed.getvalue()
    said["progress"] = path.read_text(encoding="utf-8") if path.is_file() else ""
    return json.dumps(said)


def run_cell(code: str) -> tuple[dict[str, Any], BaseException | None]:
    """Run code; return its namespace and what stopped it, if anything did."""
    given = page_cells.SESSION.given
    namespace = {**given, "__name__": "__main__", "check": check, "hint": hint, "report": report}
    # tracebacks, and the verdict, show the reader's line
    add_source(code, FILE)
    try:
        exec(compile(code, FILE, "exec", dont_inherit=True), namespace)  # noqa: S102 - its purpose
    except BaseException as error:  # noqa: BLE001 - SystemExit must not end the worker either
        return namespace, error
    return namespace, None
