"""Environments of their own for what the book is compared with, and for other versions.

Each has a name and two files here: ``NAME.in`` says by hand what it holds, ``NAME.txt`` locks every
version with its hashes (``make lock`` writes it). The first line of ``NAME.in`` names its Python,
as in ``# python 3.12``. Nothing of this is installed by ``make book`` or ``make test``.

Usage: ``python -m tools.environments NAME`` makes one and prints its Python.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from tools import ROOT
from tools.file_lock import locked

ROOM = Path(__file__).resolve().parent
MADE = ROOT / "_build" / "environments"

_PYTHON = re.compile(r"# python (\d+\.\d+)\s*\n")


class NoEnvironmentError(RuntimeError):
    """An environment cannot be made on this machine; the message says what is missing."""


def list_environments() -> list[str]:
    """Name every environment that has a file here."""
    return sorted(path.stem for path in ROOM.glob("*.in"))


def make_environment(name: str) -> Path:
    """Make an environment, or find it made, and return its Python.

    Parameters
    ----------
    name : str
        One of `list_environments`.

    Returns
    -------
    pathlib.Path
        The interpreter; its environment lies under ``_build/environments``.

    Raises
    ------
    ValueError
        If there is no such environment.
    NoEnvironmentError
        If its Python is not to be had, or a package cannot be installed.
    """
    if name not in list_environments():
        raise ValueError(f"expected one of {', '.join(list_environments())}, got {name!r}")
    lock = ROOM / f"{name}.txt"
    folder = MADE / name
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    wanted = hashlib.sha256(lock.read_bytes() + read_python(name).encode()).hexdigest()
    stamp = folder / ".ready"
    with locked(MADE / f"{name}.lock"):
        if stamp.is_file() and stamp.read_text(encoding="ascii") == wanted:
            return python
        shutil.rmtree(folder, ignore_errors=True)
        print(f"environments: making {name}", file=sys.stderr, flush=True)
        _run_uv("venv", "--quiet", "--python", find_python(read_python(name)), str(folder))
        _run_uv(
            *("pip", "install", "--quiet", "--python", str(python)),
            *("--require-hashes", "--no-deps", "-r", str(lock)),
        )
        stamp.write_text(wanted, encoding="ascii")
    return python


def read_python(name: str) -> str:
    """Read which Python an environment is for, such as "3.12"."""
    found = _PYTHON.match((ROOM / f"{name}.in").read_text(encoding="utf-8"))
    if found is None:
        raise ValueError(f"{name}.in: expected a first line such as '# python 3.12'")
    return found.group(1)


def find_python(wanted: str) -> str:
    """Return what to call a Python by: the path of one that is installed, or its version.

    uv finds what lies on the path, and fetches what does not where it may. Those of pyenv are not
    on the path unless somebody chose them.
    """
    if sys.version_info[:2] == tuple(map(int, wanted.split("."))):
        return sys.executable
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    installed = sorted(pyenv.glob(f"{wanted}.*/bin/python"))
    return str(installed[-1]) if installed else wanted


def lock_environments() -> None:
    """Write every ``NAME.txt`` anew from its ``NAME.in``."""
    for name in list_environments():
        overrides = ROOM / f"{name}.overrides"
        _run_uv(
            *("pip", "compile", str(ROOM / f"{name}.in"), "--python-version", read_python(name)),
            *(
                "--generate-hashes",
                "--no-annotate",
                "--no-header",
                "--quiet",
                "--no-emit-index-url",
            ),
            *(("--overrides", str(overrides)) if overrides.is_file() else ()),
            *("-o", str(ROOM / f"{name}.txt")),
        )


def _run_uv(*arguments: str) -> None:
    command = [sys.executable, "-m", "uv", *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        words = done.stderr.strip().splitlines()[-3:]
        raise NoEnvironmentError(f"uv {arguments[0]} failed: {' '.join(words)}")
