"""Where outputs go: to the page, or to whoever has asked for them meanwhile."""

from __future__ import annotations

import io
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from typing import TYPE_CHECKING, Any, TypeAlias

import page_outputs

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

#: An output as notebooks keep it, or {"output_type": "clear_output", "wait": bool}.
Output: TypeAlias = dict[str, Any]

_sinks: list[Callable[[Output], None]] = []


def publish(output: Output) -> None:
    """Hand an output to who asked last, else to the page."""
    if _sinks:
        _sinks[-1](output)
    else:
        page_outputs.publish(output)


@contextmanager
def redirect(sink: Callable[[Output], None]) -> Iterator[None]:
    """Give a function what is displayed and printed meanwhile."""
    _sinks.append(sink)
    try:
        with redirect_stdout(_Stream("stdout")), redirect_stderr(_Stream("stderr")):
            yield
    finally:
        _sinks.pop()


class OutputList:
    """Keep outputs as a cell does: text that follows text is one, and a clearing clears."""

    def __init__(self) -> None:
        self.outputs: list[Output] = []
        self._clears_next = False

    def add(self, output: Output) -> None:
        """Take one output more."""
        if output["output_type"] == "clear_output":
            self._clears_next = output["wait"]
            if not output["wait"]:
                self.outputs = []
            return
        if self._clears_next:
            self.outputs, self._clears_next = [], False
        last = self.outputs[-1] if self.outputs else {}
        if output["output_type"] == "stream" and last.get("name") == output["name"]:
            self.outputs[-1] = {**last, "text": last["text"] + output["text"]}
        else:
            self.outputs.append(output)


class _Stream(io.TextIOBase):
    """What is printed, as outputs."""

    def __init__(self, name: str) -> None:
        self._name = name

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        if text:
            publish({"output_type": "stream", "name": self._name, "text": text})
        return len(text)
