"""Say what went wrong in code that a reader wrote: its own lines, the message, what it means."""

from __future__ import annotations

import linecache
import traceback
from typing import TYPE_CHECKING

from labutils.checks.exceptions import explain

if TYPE_CHECKING:
    from collections.abc import Collection


def add_source(code: str, name: str) -> None:
    """Let tracebacks and verdicts show the lines of code that stands in no file."""
    linecache.cache[name] = (len(code), None, code.splitlines(keepends=True), name)


def describe(error: BaseException, name: str, others: Collection[str] = ()) -> str:
    """Format an exception with the reader's own lines only, and say what it means.

    Parameters
    ----------
    error : BaseException
        What the code raised.
    name : str
        What a traceback calls the code that has just run.
    others : collection of str
        The same of code that ran before, from which functions may stem.

    Returns
    -------
    str
        Lines as in a traceback, and one more with advice where there is some.
    """
    own = {name, *others}
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename in own]
    lines = traceback.format_exception_only(error)
    if frames:
        title = f"In {name}:\n"
        lines = [title, *(_describe_frame(frame, name) for frame in frames), *lines]
    text = "".join(lines).replace(f'File "{name}", line', "line").strip("\n")
    advice = explain(error, name)
    return f"{text}\n{advice}" if advice else text


def find_line(error: BaseException, name: str) -> int | None:
    """Find the line of a piece of code at which it stopped.

    Parameters
    ----------
    error : BaseException
        What the code raised.
    name : str
        What a traceback calls the code.

    Returns
    -------
    int or None
        The deepest of its lines; None where the error came from elsewhere.
    """
    if isinstance(error, SyntaxError) and error.filename == name:
        return error.lineno
    frames = traceback.extract_tb(error.__traceback__)
    return next((frame.lineno for frame in reversed(frames) if frame.filename == name), None)


def _describe_frame(frame: traceback.FrameSummary, name: str) -> str:
    place = "" if frame.filename == name else f"{frame.filename}, "
    function = "" if frame.name == "<module>" else f" in {frame.name}"
    return f"  {place}line {frame.lineno}{function}: {frame.line}\n"
