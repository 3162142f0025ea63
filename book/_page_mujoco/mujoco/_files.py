"""Scenes and the files that they name, handed to the engine, which cannot read files itself."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pyodide.ffi import to_js

from ._engine import ask, engine

if TYPE_CHECKING:
    from collections.abc import Mapping

#: Newer than the engine's parser: which geoms cast shadows, which no picture by rays shows.
_CASTSHADOW = re.compile(r"(<geom\b[^>]*?)\s+castshadow=(\"\w+\"|'\w+')")

#: What scenes name: nothing else of a folder is read.
_ASSETS = {".png", ".obj", ".stl", ".msh", ".xml", ".mjcf", ".skn", ".bin", ".hdr", ".ktx"}


def adapt(xml: str) -> str:
    """Leave out what the engine's parser does not know yet and no picture by rays shows."""
    if not isinstance(xml, str):
        raise TypeError(f"xml: expected text, got {type(xml).__name__}")
    return _CASTSHADOW.sub(r"\1", xml)


def read_scene(filename: str) -> tuple[str, dict[str, bytes]]:
    """Read a scene, and the files in its folder and below that it may name.

    Raises
    ------
    ValueError
        If there is no such file.
    """
    path = Path(filename)
    if not path.is_file():
        raise ValueError(f"ParseXML: Error opening file '{filename}'")
    beside = (one for one in sorted(path.parent.rglob("*")) if one.suffix.lower() in _ASSETS)
    files = {
        one.relative_to(path.parent).as_posix(): one.read_bytes()
        for one in beside
        if one.is_file() and one != path
    }
    return path.read_text(encoding="utf-8"), files


def make_vfs(assets: Mapping[str, bytes | str]) -> Any:
    """Make a file system of the engine that holds some files; the caller deletes it."""
    vfs = engine.MjVFS.new()
    for name, content in assets.items():
        data = content.encode() if isinstance(content, str) else content
        ask(vfs.addBuffer, name, to_js(data), otherwise=ValueError)
    return vfs
