"""Collect what a cell prints and shows, in the form of a notebook's outputs.

`publish`, `make_bundle` and `make_error` are what the page's IPython and its comms build on. Nothing
here needs a browser, so tests run it anywhere.
"""

from __future__ import annotations

import base64
import io
from typing import TYPE_CHECKING, Any

from page_errors import describe

if TYPE_CHECKING:
    from collections.abc import Callable

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

#: The outputs of the running cell; a cell starts with none.
outputs: list[dict[str, Any]] = []

#: What tracebacks call the cells that have run, the last one last.
names: list[str] = []

_clears_next = False
_printed = 0
_on_text: Callable[[str], None] | None = None


def begin(on_text: Callable[[str], None] | None = None) -> None:
    """Forget the outputs of the cell before.

    Parameters
    ----------
    on_text : callable, optional
        Hears every text as it is printed, so that the page knows it where the cell never ends.
    """
    global _printed, _on_text, _clears_next
    outputs.clear()
    _clears_next = False
    _printed, _on_text = 0, on_text


def publish(output: dict[str, Any]) -> None:
    """Add an output in the notebook's form (``output_type`` and what belongs to it), or clear."""
    global _clears_next
    if output["output_type"] == "clear_output":
        _clears_next = output["wait"]
        if not _clears_next:
            outputs.clear()
        return
    if _clears_next:
        outputs.clear()
        _clears_next = False
    outputs.append(output)


def make_error(error: BaseException) -> dict[str, Any]:
    """Return an exception as an output, with the reader's own lines."""
    text = describe(error, names[-1] if names else "", names)
    kind = type(error).__name__
    return {"output_type": "error", "ename": kind, "evalue": str(error), "traceback": [text]}


def make_bundle(thing: Any) -> dict[str, Any]:
    """Return the forms of an object: kind of content to text; binary content in base64.

    A form that fails is left out, as in a notebook; plain text is always there.
    """
    bundle: dict[str, Any] = {}
    whole = getattr(thing, "_repr_mimebundle_", None)
    if callable(whole) and not isinstance(thing, type):
        # explorers draw their poster for those who have no widgets: not here
        made = whole(exclude={"image/png"}) if hasattr(thing, "_model_id") else whole()
        bundle = dict((made[0] if isinstance(made, tuple) else made) or {})
    for method, form in _FORMS.items():
        function = getattr(thing, method, None)
        if form not in bundle and callable(function) and not isinstance(thing, type):
            content = function()
            if content is not None:
                bundle[form] = content[0] if isinstance(content, tuple) else content
    bundle.setdefault("text/plain", repr(thing))
    return {form: _to_text(content) for form, content in bundle.items()}


def _to_text(content: Any) -> Any:
    if isinstance(content, (bytes, bytearray, memoryview)):
        return base64.b64encode(content).decode("ascii")
    return content


class Stream(io.TextIOBase):
    """Where a cell prints to: output or errors."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name = name

    def writable(self) -> bool:
        """Tell that one may write."""
        return True

    def write(self, text: str) -> int:
        """Keep a text, up to the limit of a cell."""
        global _printed
        left = MAX_PRINTED - _printed
        _printed += len(text)
        if left > 0:
            self._add(text if len(text) <= left else text[:left] + TOO_MUCH)
        return len(text)

    def _add(self, text: str) -> None:
        last = outputs[-1] if outputs and not _clears_next else {}
        if last.get("output_type") == "stream" and last["name"] == self.name:
            last["text"] += text
        else:
            publish({"output_type": "stream", "name": self.name, "text": text})
        if _on_text is not None:
            _on_text(text)
