"""Packages that a page does not bring with it, and that it loads where a reader imports them."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from tools.vendor.page_wheels import CDN, RemoteWheel

if TYPE_CHECKING:
    from pathlib import Path

#: What a reader may import, by its name in Python and in Pyodide's lock file.
OPTIONAL = ("matplotlib",)
#: What the page has already.
PRESENT = frozenset({"numpy"})


def find_optional(lock_file: Path, version: str) -> dict[str, list[dict[str, str]]]:
    """Find the official wheels of every optional package, and of all that it needs.

    Parameters
    ----------
    lock_file : Path
        Pyodide's own lock file; packages that it does not know are left out.
    version : str
        Of Pyodide.

    Returns
    -------
    dict
        Name of a package to its wheels: name, address and checksum of each.
    """
    packages = json.loads(lock_file.read_text(encoding="utf-8"))["packages"]
    return {
        name: [vars(_locate(one, packages[one], version)) for one in _list_needs(name, packages)]
        for name in OPTIONAL
        if name in packages
    }


def _list_needs(name: str, packages: dict[str, dict[str, list[str]]]) -> list[str]:
    """List a package and what it depends on, in a fixed order."""
    found: set[str] = set()
    left = [name]
    while left:
        one = left.pop()
        if one not in found and one not in PRESENT:
            found.add(one)
            left += packages[one]["depends"]
    return sorted(found)


def _locate(name: str, entry: dict[str, str], version: str) -> RemoteWheel:
    url = CDN.format(version=version, file_name=entry["file_name"])
    return RemoteWheel(name, url, entry["sha256"])
