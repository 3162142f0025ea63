"""Bundle the script of the first screen: ``book/_hero`` and the modules of the explorers it uses.

esbuild makes one script of them (its WebAssembly build, the same on every machine), because a page
that was opened from a file cannot import. It goes to ``_build/hero``, which ``book/_ext/hero.py``
serves.

Usage: ``python -m tools.vendor.page_hero``; ``tools/build/book.py`` runs it before every build.
"""

import hashlib
import re
import subprocess
import sys
from pathlib import Path

from tools import ROOT
from tools.vendor import npm
from tools.vendor.page_python import BUNDLER

ENTRY = ROOT / "book" / "_hero" / "hero.js"
BUNDLE = ROOT / "_build" / "hero" / "hero.js"
OPTIONS = (
    "--bundle",
    "--minify",
    "--format=iife",
    "--target=es2022",
    "--charset=utf8",
    "--log-level=warning",
)
IMPORT = re.compile(r'from "(\./[^"]+|\.\./[^"]+)"')


def main() -> int:
    """Bring the bundle up to date; return the exit code."""
    try:
        print(f"first screen: {bundle()}")
    except npm.VendorError as error:
        print(f"first screen: {error}", file=sys.stderr)
        return 1
    return 0


def bundle() -> str:
    """Bundle the script where it is missing or outdated; return what was done.

    Raises
    ------
    tools.vendor.npm.VendorError
        If the bundler is not there, or says no.
    """
    sources = list_sources()
    wanted = _fingerprint(sources)
    if BUNDLE.exists() and npm.read_stamp(BUNDLE.parent) == wanted:
        return "up to date"
    npm.install()
    BUNDLE.parent.mkdir(parents=True, exist_ok=True)
    bundler = npm.get_package(BUNDLER) / "bin" / "esbuild"
    command = [*npm.find_node(), str(bundler), str(ENTRY), *OPTIONS, f"--outfile={BUNDLE}"]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        raise npm.VendorError(f"it could not be bundled: {done.stderr.strip()}")
    (BUNDLE.parent / npm.STAMP).write_text(wanted, encoding="utf-8")
    return f"bundled {len(sources)} modules"


def list_sources() -> list[Path]:
    """List the modules of the bundle: the entry, what it imports, and so on."""
    found: list[Path] = []
    waiting = [ENTRY]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.append(path)
            imported = IMPORT.findall(path.read_text(encoding="utf-8"))
            waiting += [(path.parent / one).resolve() for one in imported]
    return sorted(found)


def _fingerprint(sources: list[Path]) -> str:
    digest = hashlib.sha256(repr((OPTIONS, npm.get_checksum(BUNDLER))).encode())
    for path in sources:
        digest.update(path.read_bytes())
    return digest.hexdigest()


if __name__ == "__main__":
    sys.exit(main())
