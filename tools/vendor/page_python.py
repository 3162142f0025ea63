"""Make what Python in the page consists of: the core of Pyodide, and the editor as one script.

Both come from npm like the other front-end files (see ``npm.py``). The editor is CodeMirror with
everything it depends on, bundled by esbuild (its WebAssembly build, the same on every machine)
from ``tools/vendor/editor/editor.js``, with the names it offers (``library_names.py``).

``tools/vendor/pack_python.py`` calls this, and makes of it what the pages load.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

from tools import ROOT
from tools.vendor import npm
from tools.vendor.frontend import copy_files
from tools.vendor.library_names import list_names

if TYPE_CHECKING:
    from collections.abc import Iterable

VENDOR = ROOT / "_build" / "vendor_python"
ENTRY = Path(__file__).parent / "editor" / "editor.js"
STAMP = "stamp"

EDITOR_PACKAGES = ("codemirror", "@codemirror/lang-python")
BUNDLER = "esbuild-wasm"
PYODIDE = "pyodide"
CORE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")
LOCK = "pyodide-lock.json"

BUNDLE_OPTIONS = (
    "--bundle",
    "--minify",
    "--format=iife",
    "--global-name=cameraLabEditor",
    "--target=es2020",
    "--legal-comments=none",  # their licenses are shipped whole, see EDITOR_LICENSES
    "--log-level=warning",
)
EDITOR, EDITOR_LICENSES = "editor.js", "editor-licenses.txt"
NAMES = "library-names"  # what the editor's scripts call the list


def vendor() -> str:
    """Fill ``_build/vendor_python`` where it is missing or outdated; return what was done.

    Raises
    ------
    tools.vendor.npm.VendorError
        If there is nothing yet and npm cannot be reached, or the editor cannot be bundled.
    """
    wanted = _fingerprint()
    stamp = VENDOR / STAMP
    present = stamp.read_text(encoding="utf-8") if stamp.exists() else ""
    if present == wanted:
        return "up to date"
    try:
        npm.install()
    except npm.VendorError as error:
        if not present:
            raise
        return f"{error}; going on with the older files"
    new = VENDOR.with_name("vendor_python.new")
    shutil.rmtree(new, ignore_errors=True)
    copy_files(npm.get_package(PYODIDE), (*CORE, LOCK), new)
    packages = npm.list_closure(EDITOR_PACKAGES)
    bundle_editor(new)
    licenses = "\n".join(map(_read_license, packages))
    (new / EDITOR_LICENSES).write_text(licenses, encoding="utf-8")
    (new / STAMP).write_text(wanted, encoding="utf-8")
    npm.put_in_place(new, VENDOR)
    return f"took {PYODIDE}, bundled the editor ({len(packages)} packages)"


def bundle_editor(target: Path) -> None:
    """Write the editor as one script.

    Raises
    ------
    tools.vendor.npm.VendorError
        If the bundler says no.
    """
    bundler = npm.get_package(BUNDLER) / "bin" / "esbuild"
    names = target.resolve() / f"{NAMES}.json"
    names.write_text(json.dumps(list_names()), encoding="utf-8")
    command = [*npm.find_node(), str(bundler), str(ENTRY), *BUNDLE_OPTIONS]
    command += [f"--alias:{NAMES}={names}", f"--outfile={(target / EDITOR).resolve()}"]
    packages = {"NODE_PATH": str(npm.FOLDER / "node_modules")}  # beside the entry are none
    done = subprocess.run(
        command, env=os.environ | packages, capture_output=True, encoding="utf-8", check=False
    )
    if done.returncode:
        raise npm.VendorError(f"the editor could not be bundled: {done.stderr.strip()}")


def minify_scripts(scripts: Iterable[Path], target: Path) -> None:
    """Write our own scripts without comments and blanks: pages load them, whoever reads.

    Raises
    ------
    tools.vendor.npm.VendorError
        If the bundler says no.
    """
    bundler = npm.get_package(BUNDLER) / "bin" / "esbuild"
    options = ("--minify-whitespace", "--minify-syntax", "--charset=utf8", "--log-level=warning")
    command = [*npm.find_node(), str(bundler), *map(str, scripts), *options, f"--outdir={target}"]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        raise npm.VendorError(f"the scripts could not be minified: {done.stderr.strip()}")


def _read_license(package: str) -> str:
    text = (npm.get_package(package) / "LICENSE").read_text(encoding="utf-8")
    return f"{package}\n{'=' * len(package)}\n{text.strip()}\n"


def _fingerprint() -> str:
    """Name what `_build/vendor_python` should hold: packages, options and our own scripts."""
    names = [PYODIDE, BUNDLER, *npm.list_closure(EDITOR_PACKAGES)]
    checksums = [npm.get_checksum(name) for name in names]
    scripts = [path.read_text("utf-8") for path in sorted(ENTRY.parent.glob("*.js"))]
    content = json.dumps([names, checksums, CORE, BUNDLE_OPTIONS, scripts, list_names()])
    return hashlib.sha256(content.encode()).hexdigest()
