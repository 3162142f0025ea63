"""The shell that `get_ipython` returns: what goes wrong in a callback is shown by it."""

from __future__ import annotations

import sys
import traceback
from typing import TYPE_CHECKING, Any

# these lie beside this package in the page
import page_cells  # type: ignore[import-not-found]
import page_errors  # type: ignore[import-not-found]
import page_outputs  # type: ignore[import-not-found]

from ._sinks import publish

if TYPE_CHECKING:
    from types import TracebackType


class Events:
    """Nobody listens to the events of a cell here."""

    def trigger(self, event: str, *arguments: Any) -> None:
        """Do nothing."""

    def register(self, event: str, function: Any) -> None:
        """Do nothing."""

    def unregister(self, event: str, function: Any) -> None:
        """Do nothing."""


class DisplayFormatter:
    """Make of an object the forms in which it can be shown."""

    def format(self, obj: Any, **_options: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the forms by MIME type, and no metadata."""
        return page_outputs.make_bundle(obj), {}


class Shell:
    """The one shell of the page."""

    def __init__(self) -> None:
        self.events = Events()
        self.display_formatter = DisplayFormatter()

    @classmethod
    def instance(cls) -> Shell:
        """Return the one there is."""
        return _shell

    def showtraceback(
        self,
        exc_tuple: tuple[type[BaseException], BaseException, TracebackType | None] | None = None,
        **_options: Any,
    ) -> None:
        """Show an exception, by default the one that is being handled."""
        error = exc_tuple[1] if exc_tuple else sys.exception()
        if error is not None:
            publish(make_error(error))


def make_error(error: BaseException) -> dict[str, Any]:
    """Return an exception of a callback as an output, told as that of a cell."""
    cells = page_cells.SESSION.cells
    frames = [one.filename for one in traceback.extract_tb(error.__traceback__)]
    own = [name for name in frames if name in cells]
    text = page_errors.describe(error, own[-1] if own else "a callback", cells)
    kind = type(error).__name__
    return {"output_type": "error", "ename": kind, "evalue": str(error), "traceback": [text]}


_shell = Shell()


def get_ipython() -> Shell:
    """Return the shell."""
    return _shell
