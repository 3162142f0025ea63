"""Remember what the pages were made from, and forget what no longer holds.

Three questions are asked, from the outside in. Has anything changed at all since the last build?
Where not, there is nothing to do. Does the look of every page depend on what has changed? Then all
are drawn again. Do the outputs of all cells depend on it? Then all are run again. What is left are
changes of single pages, which Sphinx and the cache of executed pages see by themselves.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from tools import ROOT

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from tools.build.edition import Edition

# What the outputs of cells depend on besides the cells: Sphinx and jupyter-cache see
# changes of the pages only, so a change here has to empty their memories.
CELL_SOURCES = ("labutils", "assets", "requirements.txt")
CELL_VARIABLES = ("MUJOCO_GL",)
CELL_MEMORY = (".jupyter_cache", ".doctrees", "jupyter_execute")
# What the look of every page depends on, but not its numbers. Sphinx does not even copy
# a changed style sheet while no page has changed, and pages name it by its checksum.
PAGE_SOURCES = (
    "book/_ext",
    "book/_hero",
    "book/_static",
    "_build/page_python.json",  # names every asset of Python in the page
    "book/_templates",
    "content",
    "_config.yml",
    "_toc.yml",
    "package-lock.json",
)
PAGE_MEMORY = (".doctrees", "html")

# Of the repository, what no page is made from. All else counts: rather one build too many.
NO_SOURCES = {"_build", "outputs", "node_modules", "tests", "__pycache__"}
MADE_BY_BUILDS = ("solutions/pages",)
OUTSIDE = "CAMERA_LAB_WHEELS"  # names a folder of wheels that pages carry


class Memory:
    """What an edition was built from.

    Parameters
    ----------
    edition : Edition
        The book it is about.
    """

    def __init__(self, edition: Edition) -> None:
        self.edition = edition
        self.stamps = edition.build / "stamps.json"
        self.built = edition.build / "built.json"
        # before the build: what changes while it runs has to be seen by the next one
        self.sources = digest_sources()

    def is_up_to_date(self) -> bool:
        """Whether the last build succeeded, from the same sources, and its pages still stand."""
        built = _read(self.built)
        return built.get("sources") == self.sources and built.get("pages") == self._list_pages()

    def note_built(self) -> None:
        """Remember that the pages stand, and what they were made from."""
        noted = {"sources": self.sources, "pages": self._list_pages()}
        self.built.write_text(json.dumps(noted), encoding="utf-8")

    def forget_what_changed(self) -> str:
        """Empty the memories whose sources have changed; return what was done, in words."""
        old, built = _read(self.stamps), _read(self.built)
        self.built.unlink(missing_ok=True)
        new = {
            "cells": make_cell_stamp(os.environ),
            "pages": digest((*PAGE_SOURCES, *self.edition.sources)),
        }
        done = []
        if old.get("cells") != new["cells"]:
            self._remove(CELL_MEMORY)
            done.append("all run again, because the library, the scene or the environment changed")
        if old.get("pages") != new["pages"]:
            self._remove(PAGE_MEMORY)
            done.append("all drawn again, because the configuration changed")
        elif built and built["pages"] != self._list_pages():
            self._remove(PAGE_MEMORY)
            done.append("all drawn again, because they are not as they were left")
        self.stamps.write_text(json.dumps(new), encoding="utf-8")
        if not old:
            return "none yet"
        return "; ".join(done) or "kept where the page is unchanged"

    def forget_pages(self) -> None:
        """Let the next build read every page: Sphinx would not repeat the warnings of one."""
        self._remove(PAGE_MEMORY)

    def _remove(self, names: Iterable[str]) -> None:
        for name in names:
            shutil.rmtree(self.edition.build / name, ignore_errors=True)

    def _list_pages(self) -> str:
        """Name every file beside the pages, its size and its time."""
        return hashlib.sha256(_list_times(self.edition.html.rglob("*"))).hexdigest()


def make_cell_stamp(environment: Mapping[str, str]) -> str:
    """Hash what the outputs of cells depend on besides the cells, in an environment."""
    variables = [f"{name}={environment.get(name, '')}" for name in CELL_VARIABLES]
    return digest(CELL_SOURCES, [sys.version, *variables])


def digest_sources() -> str:
    """Hash whatever a build may read: the repository, and what variables add to it."""
    # by what they say: times would call a fresh checkout a change, and miss a quick edit
    found = hashlib.sha256(sys.version.encode())
    for name in (*CELL_VARIABLES, OUTSIDE):
        found.update(f"{name}={os.environ.get(name, '')}\0".encode())
    for path in _walk(ROOT):
        found.update(path.relative_to(ROOT).as_posix().encode() + b"\0")
        found.update(hashlib.sha256(path.read_bytes()).digest())
    if folder := os.environ.get(OUTSIDE):
        found.update(_list_times(Path(folder).glob("*")))
    return found.hexdigest()


def digest(names: Iterable[str], extra: Iterable[str] = ()) -> str:
    """Hash the contents of files and folders, and some text."""
    found = hashlib.sha256("\0".join(extra).encode())
    for name in names:
        path = ROOT / name
        files = sorted(path.rglob("*")) if path.is_dir() else [path]
        for file in files:
            if file.is_file() and file.suffix != ".pyc":
                found.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return found.hexdigest()


def _list_times(paths: Iterable[Path]) -> bytes:
    """Name files, their sizes and their times: quicker than what they say, for files not ours."""
    states = [(path, path.stat()) for path in sorted(paths) if path.is_file()]
    return "".join(f"{path}\0{now.st_size}\0{now.st_mtime_ns}\0" for path, now in states).encode()


def _walk(folder: Path) -> Iterator[Path]:
    """List the files that a build may read, sorted."""
    for path in sorted(folder.iterdir()):
        skipped = path.name.startswith(".") or path.name in NO_SOURCES
        if skipped or path.suffix in (".egg-info", ".pyc"):
            continue
        if path.relative_to(ROOT).as_posix() in MADE_BY_BUILDS:
            continue
        if path.is_dir():
            yield from _walk(path)
        elif path.is_file():
            yield path


def _read(path: Path) -> dict[str, str]:
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
