"""Build the book: what `make book` runs once the environment stands.

Fetches the front-end files, drops executed pages that no longer hold, runs Jupyter
Book with warnings as errors, and prints one line per stage. The whole log goes to
``_build/book.log``; of a failure the part that matters is printed.

Usage: ``python tools/build_book.py``. The environment of the call is passed on to the
cells (``MUJOCO_GL``, ``EDITION``).
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path

import vendor_frontend

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "_build"
LOG = BUILD / "book.log"
STAMPS = BUILD / "stamps.json"

# What the outputs of cells depend on besides the cells: Sphinx and jupyter-cache see
# changes of the pages only, so a change here has to empty their memories.
CELL_SOURCES = ("labutils", "assets", "requirements.txt")
CELL_VARIABLES = ("MUJOCO_GL", "EDITION")
CELL_MEMORY = (".jupyter_cache", ".doctrees", "jupyter_execute")
# What the look of every page depends on, but not its numbers. Sphinx does not even copy
# a changed style sheet while no page has changed, and pages name it by its checksum.
PAGE_SOURCES = ("book/_ext", "book/_static", "_config.yml", "_toc.yml", "package-lock.json")
PAGE_MEMORY = (".doctrees", "html")

COLOR_CODES = re.compile(r"\x1b\[[0-9;]*m")
CELL_ERROR = re.compile(
    r"^nbclient\.exceptions\.\w+: .*?(?=^The above exception was|\Z)", re.MULTILINE | re.DOTALL
)
COMPLAINT = re.compile(r"\b(WARNING|ERROR|CRITICAL)\b")
HARMLESS = "Kernel is running over TCP without encryption"  # ipykernel, on the loopback
LAST_LINES = 40
JUPYTER_BOOK = "from jupyter_book.cli.main import main; main()"  # it has no __main__


def main() -> int:
    """Build; return the exit code."""
    started = time.monotonic()
    BUILD.mkdir(exist_ok=True)
    if code := vendor_frontend.main([]):
        return code
    print(f"executed pages: {_forget_what_changed()}", flush=True)
    code, log = _run_jupyter_book()
    executed = log.count("Executed notebook in")
    read = len(set(re.findall(r"^reading sources\.\.\. \[ *\d+%\] (\S+)", log, re.MULTILINE)))
    seconds = time.monotonic() - started
    if code:
        # Sphinx would not repeat the warnings of a page it has already read
        _remove(PAGE_MEMORY)
        print(_what_went_wrong(log), file=sys.stderr)
        print(f"book: failed after {seconds:.0f} s; the whole log is {LOG}", file=sys.stderr)
        return code
    print(f"book: {read} pages read, {executed} executed, no warnings, {seconds:.0f} s")
    print(f"open {(BUILD / 'html' / 'index.html').as_uri()}")
    return 0


def _forget_what_changed() -> str:
    """Empty the memories whose sources have changed; return what was done, in words."""
    old = json.loads(STAMPS.read_text()) if STAMPS.exists() else {}
    variables = [f"{name}={os.environ.get(name, '')}" for name in CELL_VARIABLES]
    new = {
        "cells": _digest(CELL_SOURCES, [sys.version, *variables]),
        "pages": _digest(PAGE_SOURCES),
    }
    done = []
    if old.get("cells") != new["cells"]:
        _remove(CELL_MEMORY)
        done.append("all run again, because the library, the scene or the environment changed")
    if old.get("pages") != new["pages"]:
        _remove(PAGE_MEMORY)
        done.append("all drawn again, because the configuration changed")
    STAMPS.write_text(json.dumps(new))
    if not old:
        return "none yet"
    return "; ".join(done) or "kept where the page is unchanged"


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


def _remove(names: Iterable[str]) -> None:
    for name in names:
        shutil.rmtree(BUILD / name, ignore_errors=True)


def _run_jupyter_book() -> tuple[int, str]:
    """Run the build; return its exit code and its log without colors."""
    command = [sys.executable, "-c", JUPYTER_BOOK, "build", str(ROOT)]
    command += ["-W", "-n", "--keep-going"]
    environment = os.environ | {
        "IPYTHONDIR": str(BUILD / "ipython"),  # not the reader's own profile and start-up files
        "JUPYTER_PREFER_ENV_PATH": "1",  # the kernel of this environment, not one of the user
        "PYDEVD_DISABLE_FILE_VALIDATION": "1",
        "PYTHONHASHSEED": "0",  # the same order of sets in every build
        "PYTHONUNBUFFERED": "1",
    }
    lines = []
    with (
        LOG.open("w", encoding="utf-8") as file,
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
