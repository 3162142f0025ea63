"""Gather the front-end files that the book carries inside itself.

require.js, MiniSearch and the widget manager come from npm (see ``npm.py``); the anywidget loader
comes from the Python package of the same name, so that both sides always agree. Everything
goes to ``_build/vendor``, from where ``book/_ext/offline.py`` serves it.

Only these packages are needed, not their dependencies: the browser bundles already contain them.

Usage: ``python -m tools.vendor.frontend``.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import sys
from base64 import b64encode
from fnmatch import fnmatch
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from tools import ROOT
from tools.vendor import npm
from tools.vendor.npm import VendorError

if TYPE_CHECKING:
    from collections.abc import Sequence

VENDOR = ROOT / "_build" / "vendor"

# package, folder inside it, file patterns below that folder, folder in the book
FILES = (
    ("requirejs", "", ("require.js",), "widgets"),
    ("@jupyter-widgets/html-manager", "dist", ("embed-amd.js", "*.woff2"), "widgets"),
    ("minisearch", "dist/umd", ("index.js",), "minisearch"),
    ("minisearch", "", ("LICENSE.txt",), "minisearch"),
)


def main() -> int:
    """Bring ``_build/vendor`` up to date; return the exit code."""
    try:
        print(f"front end: {vendor()}")
    except VendorError as error:
        print(f"front end: {error}", file=sys.stderr)
        return 1
    return 0


def vendor() -> str:
    """Fill ``_build/vendor`` where it is missing or outdated; return what was done."""
    wanted = _fingerprint()
    present = npm.read_stamp(VENDOR)
    if present == wanted:
        return "up to date"
    try:
        npm.install()
    except VendorError as error:
        if not present:
            raise
        return f"{error}; going on with the older files"
    new = VENDOR.with_name("vendor.new")
    shutil.rmtree(new, ignore_errors=True)
    count = sum(
        copy_files(npm.get_package(name) / folder, patterns, new / target)
        for name, folder, patterns, target in FILES
    )
    shutil.copyfile(_anywidget_file(), new / "widgets" / "anywidget.js")
    (new / npm.STAMP).write_text(wanted, encoding="utf-8")
    npm.put_in_place(new, VENDOR)
    names = dict.fromkeys(name for name, *_ in FILES)
    return f"took {', '.join(names)} ({count + 1} files)"


def copy_files(source: Path, patterns: Sequence[str], target: Path) -> int:
    """Copy the files below a folder whose paths match, also across slashes; return how many."""
    count = 0
    for path in sorted(source.rglob("*")):
        below = path.relative_to(source)
        if path.is_file() and any(fnmatch(below.as_posix(), pattern) for pattern in patterns):
            (target / below).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, target / below)
            count += 1
    if not count:
        raise VendorError(f"nothing to take from {source.name}: {patterns}")
    return count


def _anywidget_file() -> Path:
    spec = find_spec("anywidget")
    if spec is None or spec.origin is None:
        raise VendorError("anywidget is missing: pip install -r requirements.txt")
    return Path(spec.origin).with_name("nbextension") / "index.js"


def _fingerprint() -> str:
    """Name what `_build/vendor` should hold: versions, checksums and the table above."""
    checksums = [npm.get_checksum(name) for name, *_ in FILES]
    loader = b64encode(hashlib.sha512(_anywidget_file().read_bytes()).digest()).decode()
    content = json.dumps([FILES, checksums, f"sha512-{loader}"])
    return hashlib.sha256(content.encode()).hexdigest()


if __name__ == "__main__":
    sys.exit(main())
