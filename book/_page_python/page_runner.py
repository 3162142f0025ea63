"""Run the code of an exercise cell and check it, as a notebook would.

The worker of the page imports this inside Pyodide; it needs nothing of the browser, so tests run
it anywhere. It speaks JSON, because nothing else crosses the border unchanged.
"""

from __future__ import annotations

import io
import json
import linecache
import traceback
import warnings
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

from labutils import check, hint, report
from labutils.checks.exceptions import explain
from labutils.checks.progress_rules import FILE_NAME

#: What a traceback calls the reader's code.
FILE = "your code"

#: A loop that prints would fill the memory before anybody can press Stop.
MAX_PRINTED = 20_000


class Printed(io.StringIO):
    """Keep what is printed, up to a limit."""

    is_full = False

    def write(self, text: str) -> int:
        """Write, or drop what is beyond the limit."""
        if not self.is_full:
            super().write(text[: MAX_PRINTED - self.tell()])
            if self.tell() >= MAX_PRINTED:
                self.is_full = True
                super().write("\n... (more was printed than can be shown)")
        return len(text)


def run(code: str, name: str, progress: str) -> str:
    """Run code in a namespace of its own, check the function in it, and tell what happened.

    Parameters
    ----------
    code : str
        The reader's.
    name : str
        The exercise, which is the name of the function to check.
    progress : str
        Content of the progress file before; empty for none.

    Returns
    -------
    str
        JSON: ``result`` ("passed", "failed", "not checked" or "error"), ``headline``, ``html`` of
        the verdict, ``printed``, ``error`` and the ``progress`` file after.
    """
    said: dict[str, Any] = {"result": "error", "headline": "", "html": "", "error": ""}
    path = Path.cwd() / FILE_NAME
    path.unlink(missing_ok=True)
    if progress:
        path.write_text(progress, encoding="utf-8")
    printed = Printed()
    with redirect_stdout(printed), redirect_stderr(printed), warnings.catch_warnings():
        namespace, said["error"] = run_cell(code)
        if not said["error"] and not callable(namespace.get(name)):
            said["error"] = f"Your code has no function {name}: keep its name as it was."
        if not said["error"]:
            verdict = check(name, namespace[name])
            said |= {
                "result": verdict.result,
                "headline": verdict.headline,
                "html": verdict._repr_html_(),
            }
    said["printed"] = printed.getvalue()
    said["progress"] = path.read_text(encoding="utf-8") if path.is_file() else ""
    return json.dumps(said)


def run_cell(code: str) -> tuple[dict[str, Any], str]:
    """Run code; return its namespace and, where it stops, what a traceback says in short."""
    namespace = {"__name__": "__main__", "check": check, "hint": hint, "report": report}
    # tracebacks, and the verdict, show the reader's line
    linecache.cache[FILE] = (len(code), None, code.splitlines(keepends=True), FILE)
    try:
        exec(compile(code, FILE, "exec", dont_inherit=True), namespace)  # noqa: S102 - its purpose
    except BaseException as error:  # noqa: BLE001 - SystemExit must not end the worker either
        return namespace, describe(error)
    return namespace, ""


def describe(error: BaseException) -> str:
    """Format an exception with the reader's own lines only, and say what it means."""
    frames = [
        frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename == FILE
    ]
    lines = traceback.format_exception_only(error)
    if frames:
        lines = ["In your code:\n", *(_describe_frame(frame) for frame in frames), *lines]
    text = "".join(lines).replace(f'File "{FILE}", line', "line").strip("\n")
    advice = explain(error, FILE)
    return f"{text}\n{advice}" if advice else text


def _describe_frame(frame: traceback.FrameSummary) -> str:
    place = "" if frame.name == "<module>" else f" in {frame.name}"
    return f"  line {frame.lineno}{place}: {frame.line}\n"
