"""Build the book: what `make book` runs once the environment stands.

Fetches the front-end files, drops executed pages that no longer hold, runs Jupyter
Book with warnings as errors, and prints one line per stage. The whole log goes to
``book.log`` beside the pages; of a failure the part that matters is printed.

Usage: ``python -m tools.build.book``. The variable ``EDITION`` chooses what is built:
``student`` (the default) goes to ``_build/html`` and holds no solution; ``instructor``
goes to ``_build/instructor/html`` and adds the pages of ``tools/editions/instructor_pages.py``.
The two share nothing but the front-end files. ``MUJOCO_GL`` is passed on to the cells.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from tools import ROOT
from tools.vendor import frontend, pack_python


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

    @property
    def stamps(self) -> Path:
        """What the memories were made from."""
        return self.build / "stamps.json"


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

# What the outputs of cells depend on besides the cells: Sphinx and jupyter-cache see
# changes of the pages only, so a change here has to empty their memories.
CELL_SOURCES = ("labutils", "assets", "requirements.txt")
CELL_VARIABLES = ("MUJOCO_GL",)
CELL_MEMORY = (".jupyter_cache", ".doctrees", "jupyter_execute")
# What the look of every page depends on, but not its numbers. Sphinx does not even copy
# a changed style sheet while no page has changed, and pages name it by its checksum.
PAGE_SOURCES = (
    "book/_ext",
    "book/_static",
    "_build/page_python.json",  # names every asset of Python in the page
    "book/_templates",
    "_config.yml",
    "_toc.yml",
    "package-lock.json",
)
PAGE_MEMORY = (".doctrees", "html")

COLOR_CODES = re.compile(r"\x1b\[[0-9;]*m")
CELL_ERROR = re.compile(
    r"^nbclient\.exceptions\.\w+: .*?(?=^The above exception was|\Z)", re.MULTILINE | re.DOTALL
)
COMPLAINT = re.compile(r"\b(WARNING|ERROR|CRITICAL)\b")
HARMLESS = "Kernel is running over TCP without encryption"  # ipykernel, on the loopback
LAST_LINES = 40

# What `jupyter-book build -W -n --keep-going` runs; the command itself puts pages nowhere
# but into a folder named _build.
JUPYTER_BOOK = """
import sys
from pathlib import Path
from jupyter_book.sphinx import build_sphinx
source, html, config, toc = map(Path, sys.argv[1:])
code = build_sphinx(
    source, html, noconfig=True, path_config=config, warningiserror=True, keep_going=True,
    confoverrides={
        "external_toc_path": toc.as_posix(), "nitpicky": True, "latex_individualpages": False
    },
)
sys.exit(code if isinstance(code, int) else 1)
"""


def main() -> int:
    """Build the edition that ``EDITION`` names; return the exit code."""
    started = time.monotonic()
    try:
        edition = get_edition(os.environ.get("EDITION", ""))
    except ValueError as error:
        print(f"book: {error}", file=sys.stderr)
        return 2
    edition.build.mkdir(parents=True, exist_ok=True)
    if code := frontend.main([]) or pack_python.main():
        return code
    if edition.name == "instructor":
        # measures every mistake, which only this edition needs
        from tools.editions import instructor_pages  # noqa: PLC0415

        print(f"instructor pages: {instructor_pages.write_pages()}", flush=True)
    print(f"executed pages: {_forget_what_changed(edition)}", flush=True)
    code, log = _run_jupyter_book(edition)
    executed = log.count("Executed notebook in")
    read = len(set(re.findall(r"^reading sources\.\.\. \[ *\d+%\] (\S+)", log, re.MULTILINE)))
    seconds = time.monotonic() - started
    if code:
        # Sphinx would not repeat the warnings of a page it has already read
        _remove(edition, PAGE_MEMORY)
        print(_what_went_wrong(log), file=sys.stderr)
        print(
            f"book: failed after {seconds:.0f} s; the whole log is {edition.log}", file=sys.stderr
        )
        return code
    print(f"book: {read} pages read, {executed} executed, no warnings, {seconds:.0f} s")
    print(f"open {(edition.html / 'index.html').as_uri()}")
    return 0


def get_edition(name: str) -> Edition:
    """Look an edition up; no name means the student's."""
    if (name or "student") not in EDITIONS:
        raise ValueError(f"EDITION: expected one of {', '.join(EDITIONS)}, got {name!r}")
    return EDITIONS[name or "student"]


def _forget_what_changed(edition: Edition) -> str:
    """Empty the memories whose sources have changed; return what was done, in words."""
    old = json.loads(edition.stamps.read_text()) if edition.stamps.exists() else {}
    new = {
        "cells": make_cell_stamp(os.environ),
        "pages": _digest((*PAGE_SOURCES, *edition.sources)),
    }
    done = []
    if old.get("cells") != new["cells"]:
        _remove(edition, CELL_MEMORY)
        done.append("all run again, because the library, the scene or the environment changed")
    if old.get("pages") != new["pages"]:
        _remove(edition, PAGE_MEMORY)
        done.append("all drawn again, because the configuration changed")
    edition.stamps.write_text(json.dumps(new))
    if not old:
        return "none yet"
    return "; ".join(done) or "kept where the page is unchanged"


def make_cell_stamp(environment: Mapping[str, str]) -> str:
    """Hash what the outputs of cells depend on besides the cells, in an environment."""
    variables = [f"{name}={environment.get(name, '')}" for name in CELL_VARIABLES]
    return _digest(CELL_SOURCES, [sys.version, *variables])


def _digest(names: Iterable[str], extra: Iterable[str] = ()) -> str:
    """Hash the contents of files and folders, and some text."""
    digest = hashlib.sha256("\0".join(extra).encode())
    for name in names:
        path = ROOT / name
        files = sorted(path.rglob("*")) if path.is_dir() else [path]
        for file in files:
            if file.is_file() and file.suffix != ".pyc":
                digest.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


def _remove(edition: Edition, names: Iterable[str]) -> None:
    for name in names:
        shutil.rmtree(edition.build / name, ignore_errors=True)


def _run_jupyter_book(edition: Edition) -> tuple[int, str]:
    """Run the build; return its exit code and its log without colors."""
    command = [sys.executable, "-c", JUPYTER_BOOK]
    command += [str(ROOT), str(edition.html), str(ROOT / edition.config), str(ROOT / edition.toc)]
    environment = os.environ | {
        "IPYTHONDIR": str(
            edition.build / "ipython"
        ),  # not the reader's own profile and start-up files
        "JUPYTER_PREFER_ENV_PATH": "1",  # the kernel of this environment, not one of the user
        "PYDEVD_DISABLE_FILE_VALIDATION": "1",
        "PYTHONHASHSEED": "0",  # the same order of sets in every build
        "PYTHONUNBUFFERED": "1",
    }
    lines = []
    with (
        edition.log.open("w", encoding="utf-8") as file,
        subprocess.Popen(
            command,
            cwd=ROOT,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
        ) as process,
    ):
        for raw in process.stdout:
            line = COLOR_CODES.sub("", raw)
            file.write(line)
            lines.append(line)
            if "Executing notebook using" in line:
                print(f"  running {_relative(line).split(': ')[0]}", flush=True)
    return process.returncode, "".join(lines)


def _what_went_wrong(log: str) -> str:
    """Return the part of the log that explains the failure."""
    complaints = [
        _relative(line)
        for line in log.splitlines()
        if COMPLAINT.search(line) and HARMLESS not in line
    ]
    parts = ["", *dict.fromkeys(complaints)]
    if error := CELL_ERROR.search(log):
        parts += ["", _relative(error[0]).strip()]
    elif not complaints:
        parts += log.splitlines()[-LAST_LINES:]
    return "\n".join([*parts, ""])


def _relative(text: str) -> str:
    return text.replace(f"{ROOT}{os.sep}", "")


if __name__ == "__main__":
    sys.exit(main())
