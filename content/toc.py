"""Read the table of contents: which pages the book has, in order."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from content import ROOT

TOC = Path("_toc.yml")


@dataclass(frozen=True)
class Entry:
    """One page: its name from the repository on, without an ending, and the part it stands in."""

    page: str
    caption: str = ""


def read_toc(root: Path = ROOT) -> dict[str, Any]:
    """Read the file as it is."""
    return dict(yaml.safe_load((root / TOC).read_text(encoding="utf-8")))


def list_entries(toc: dict[str, Any]) -> list[Entry]:
    """List every page in order; the first page stands in no part."""
    found = [Entry(toc["root"])] if "root" in toc else []

    def visit(caption: str, nodes: list[dict[str, Any]]) -> None:
        for node in nodes:
            if "file" in node:  # else an address outside of the book
                found.append(Entry(node["file"], caption))
            visit(caption, node.get("sections", []))

    for part in toc.get("parts", []):
        visit(part.get("caption", ""), part["chapters"])
    return found


def list_pages(root: Path = ROOT) -> list[str]:
    """List the names of all pages, in order."""
    return [entry.page for entry in list_entries(read_toc(root))]
