"""Show objects below the cell that runs, in the form that says most."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar

import page_outputs

__all__ = ["HTML", "SVG", "Image", "Latex", "Markdown", "clear_output", "display"]


def display(*objs: Any, **_options: Any) -> None:
    """Show objects, one below the other."""
    for obj in objs:
        data = page_outputs.make_bundle(obj)
        page_outputs.publish({"output_type": "display_data", "data": data, "metadata": {}})


def clear_output(wait: bool = False) -> None:  # noqa: FBT001, FBT002 - IPython's signature
    """Take away what the cell has shown, now or with the next output."""
    page_outputs.publish({"output_type": "clear_output", "wait": wait})


class _Text:
    """A text of one MIME type."""

    MIME: ClassVar[str]

    def __init__(self, data: str) -> None:
        self.data = data

    def _repr_mimebundle_(self, **_options: Any) -> dict[str, Any]:
        return {self.MIME: self.data, "text/plain": repr(self)}

    def __repr__(self) -> str:
        return f"<{type(self).__name__} object>"


class HTML(_Text):
    """Show a text as HTML."""

    MIME = "text/html"


class Markdown(_Text):
    """Show a text as Markdown."""

    MIME = "text/markdown"


class Latex(_Text):
    """Show a text as a formula."""

    MIME = "text/latex"


class SVG(_Text):
    """Show a text as a drawing."""

    MIME = "image/svg+xml"


class Image:
    """Show the bytes of a PNG or JPEG file.

    Raises
    ------
    ValueError
        If they are neither.
    """

    _KINDS: ClassVar = {b"\x89PNG": "image/png", b"\xff\xd8\xff": "image/jpeg"}

    def __init__(self, data: bytes | str | None = None, filename: str | None = None) -> None:
        name = filename or (data if isinstance(data, str) else None)
        self.data = Path(name).read_bytes() if name else data
        head = self.data[:4] if isinstance(self.data, bytes) else b""
        kinds = [mime for start, mime in self._KINDS.items() if head.startswith(start)]
        if not kinds:
            raise ValueError(f"data: expected the bytes of a PNG or JPEG file, got {head!r}")
        self.mime = kinds[0]

    def _repr_mimebundle_(self, **_options: Any) -> dict[str, Any]:
        return {self.mime: self.data, "text/plain": repr(self)}

    def __repr__(self) -> str:
        return "<Image object>"
