"""Collect what a cell prints and shows, in the form of a notebook's outputs.

`publish`, `make_bundle` and `make_error` are what the page's IPython and its comms build on.
Nothing here needs a browser, so tests run it anywhere.
"""

from __future__ import annotations

import base64
import io
import math
import traceback
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from typing import TYPE_CHECKING, Any

from page_errors import describe

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

#: A loop that prints would fill the memory before anybody can press Stop.
MAX_PRINTED = 20_000

TOO_MUCH = "\n... (more was printed than can be shown)"

#: Method of an object to the kind of content it returns.
_FORMS = {
    "_repr_html_": "text/html",
    "_repr_svg_": "image/svg+xml",
    "_repr_png_": "image/png",
    "_repr_jpeg_": "image/jpeg",
    "_repr_markdown_": "text/markdown",
    "_repr_latex_": "text/latex",
}

#: What tracebacks call the cells that have run, the last one last.
names: list[str] = []


class CellOutputs:
    """Outputs as a cell keeps them: text that follows text is one, and a clearing clears.

    Parameters
    ----------
    before : sequence of dict
        Outputs to go on from; they stay as they are.
    max_printed : float
        Characters that are kept of what is printed.
    """

    def __init__(
        self, before: Sequence[dict[str, Any]] = (), max_printed: float = math.inf
    ) -> None:
        self.outputs = [dict(output) for output in before]
        self._max_printed = max_printed
        self._clears_next = False
        self._printed = 0
        self._on_text: Callable[[str], None] | None = None

    def begin(self, on_text: Callable[[str], None] | None = None) -> None:
        """Forget the outputs of the cell before.

        Parameters
        ----------
        on_text : callable, optional
            Hears every text as it is printed, so that the page knows it where the cell never ends.
        """
        self.outputs = []
        self._clears_next = False
        self._printed, self._on_text = 0, on_text

    def publish(self, output: dict[str, Any]) -> None:
        """Add an output as notebooks keep it, or clear: now, or with the next one."""
        if output["output_type"] == "clear_output":
            self._clears_next = output["wait"]
            if not output["wait"]:
                self.outputs.clear()
            return
        if self._clears_next:
            self.outputs.clear()
            self._clears_next = False
        self.outputs.append(output)

    def write(self, stream: str, text: str) -> None:
        """Keep what is printed, up to the limit."""
        left = self._max_printed - self._printed
        self._printed += len(text)
        if left > 0 and text:
            self._add(stream, text if len(text) <= left else text[: int(left)] + TOO_MUCH)

    def _add(self, stream: str, text: str) -> None:
        last = self.outputs[-1] if self.outputs and not self._clears_next else {}
        if last.get("output_type") == "stream" and last["name"] == stream:
            last["text"] += text
        else:
            self.publish({"output_type": "stream", "name": stream, "text": text})
        if self._on_text is not None:
            self._on_text(text)


#: Where outputs go: to the cell that runs, or to whoever has asked for them meanwhile.
current = CellOutputs(max_printed=MAX_PRINTED)


def publish(output: dict[str, Any]) -> None:
    """Add an output where outputs go."""
    current.publish(output)


@contextmanager
def redirect(outputs: CellOutputs) -> Iterator[None]:
    """Let others have what is displayed and printed meanwhile."""
    global current  # noqa: PLW0603 - all that shows something looks it up when it does
    before, current = current, outputs
    try:
        with redirect_stdout(Stream("stdout")), redirect_stderr(Stream("stderr")):
            yield
    finally:
        current = before


def make_bundle(thing: Any) -> dict[str, Any]:
    """Return the forms of an object: kind of content to text; binary content in base64.

    Plain text is always among them.
    """
    bundle: dict[str, Any] = {}
    is_object = not isinstance(thing, type)
    whole = getattr(thing, "_repr_mimebundle_", None)
    if callable(whole) and is_object:
        # explorers draw their poster for those who have no widgets: not here
        made = whole(exclude={"image/png"}) if hasattr(thing, "_model_id") else whole()
        bundle = dict((made[0] if isinstance(made, tuple) else made) or {})
    for method, form in _FORMS.items():
        function = getattr(thing, method, None)
        if form not in bundle and callable(function) and is_object:
            content = function()
            if content is not None:
                bundle[form] = content[0] if isinstance(content, tuple) else content
    bundle.setdefault("text/plain", repr(thing))
    return {form: _to_text(content) for form, content in bundle.items()}


def _to_text(content: Any) -> Any:
    if isinstance(content, (bytes, bytearray, memoryview)):
        return base64.b64encode(content).decode("ascii")
    return content


def make_error(error: BaseException) -> dict[str, Any]:
    """Return an exception as an output, with the reader's own lines."""
    frames = [frame.filename for frame in traceback.extract_tb(error.__traceback__)]
    own = [name for name in frames if name in names]
    running = names[-1] if names else ""
    text = describe(error, own[0] if own else running, names)
    kind = type(error).__name__
    return {"output_type": "error", "ename": kind, "evalue": str(error), "traceback": [text]}


class Stream(io.TextIOBase):
    """Where a cell prints to: output or errors."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name = name

    def writable(self) -> bool:
        """Tell that one may write."""
        return True

    def write(self, text: str) -> int:
        """Hand a text to where outputs go."""
        current.write(self.name, text)
        return len(text)
