"""The shell that `get_ipython` returns: what goes wrong in a callback is shown by it."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import page_outputs

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
            page_outputs.publish(page_outputs.make_error(error))


_shell = Shell()


def get_ipython() -> Shell:
    """Return the shell."""
    return _shell
