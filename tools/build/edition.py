"""The books that can be built, and where everything of each lies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from tools import ROOT

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class Edition:
    """One of the books that can be built.

    Parameters
    ----------
    name : str
        What ``EDITION`` is set to.
    folder : str
        Where its pages and its memories lie, below the repository.
    sources : tuple of str
        What its pages depend on besides what those of every edition do.
    config, toc : str
        The configuration and the table of contents, likewise.
    """

    name: str
    folder: str
    sources: tuple[str, ...] = ()
    config: str = "_config.yml"
    toc: str = "_toc.yml"

    @property
    def build(self) -> Path:
        """The folder that holds everything of this edition."""
        return ROOT / self.folder

    @property
    def html(self) -> Path:
        """The folder of the pages."""
        return self.build / "html"

    @property
    def log(self) -> Path:
        """Everything the last build said."""
        return self.build / "book.log"


EDITIONS = {
    "student": Edition("student", "_build"),
    "instructor": Edition(
        "instructor",
        "_build/instructor",
        ("solutions", "tools/editions"),
        "_build/instructor/_config.yml",
        "_build/instructor/_toc.yml",
    ),
}


def get_edition(name: str) -> Edition:
    """Look an edition up; no name means the student's."""
    if (name or "student") not in EDITIONS:
        raise ValueError(f"EDITION: expected one of {', '.join(EDITIONS)}, got {name!r}")
    return EDITIONS[name or "student"]
