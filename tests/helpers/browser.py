"""Drive a real browser over the built pages: find it, serve the pages, run a script.

The scripts lie in ``tests/browser`` and run in the Node that the environment brings. Each
prints one JSON value. Where something is missing, a test is skipped with the reason;
with ``REQUIRE_BROWSER=1`` in the environment it fails instead, so that CI cannot go
green by testing nothing.
"""

from __future__ import annotations

import json
import os
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, NoReturn

import pytest

from tests.helpers.chapters import get_toc_pages
from tools import headless
from tools.file_lock import locked
from tools.headless import CHROMIUM_NAMES, FIREFOX_NAMES, STUDENT_PAGES, find_browser
from tools.vendor import npm

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "tests" / "browser"
#: Ways to open the pages. A file is the stricter one: it may read no other file by a script.
PROTOCOLS = ["file", pytest.param("http", marks=pytest.mark.slow)]


def give_up(reason: str) -> NoReturn:
    """Skip the test, or fail it where a browser is required."""
    if os.environ.get("REQUIRE_BROWSER") == "1":
        pytest.fail(f"{reason} (REQUIRE_BROWSER=1)", pytrace=False)
    pytest.skip(reason)


def require_chromium() -> str:
    """Return the path of Chromium; without one, say what to do."""
    return find_browser("CHROMIUM", CHROMIUM_NAMES) or give_up(
        "no Chromium found; install it or set CHROMIUM"
    )


def require_firefox() -> str:
    """Return the path of Firefox; without one, say what to do."""
    return find_browser("FIREFOX", FIREFOX_NAMES) or give_up(
        "no Firefox found; install it or set FIREFOX"
    )


def require_pages() -> Path:
    """Return the folder of the pages; where they are not built, say what to do."""
    if not (STUDENT_PAGES / "index.html").is_file():
        give_up("the book is not built; run `make book` first")
    return STUDENT_PAGES


def require_packages() -> None:
    """Fetch the browser drivers, once, however many processes run tests."""
    try:
        npm.install()
    except npm.VendorError as error:
        give_up(f"the browser drivers are missing: {error}")


def names_of_pages() -> list[str]:
    """List every page of the table of contents, and what Sphinx adds, without ``.html``."""
    return [*(page.as_posix() for page in get_toc_pages()), "genindex", "search"]


def run_script(name: str, *arguments: object, variables: Mapping[str, str] | None = None) -> Any:
    """Run a script of ``tests/browser`` in Node; return what it printed, read as JSON."""
    return headless.run_script(SCRIPTS / name, *arguments, variables=variables)


@contextmanager
def serve(folder: Path) -> Iterator[str]:
    """Serve a folder on a free port of this machine; give its address, with a slash."""
    handler = partial(_QuietHandler, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}/"
        finally:
            server.shutdown()
            thread.join()


def once(path: Path, make: Callable[[], Any]) -> Any:
    """Return what `make` returns, made by the first process that asks and kept in a file."""
    with locked(path.with_suffix(".lock")):
        if not path.exists():
            path.write_text(json.dumps(make()), encoding="utf-8")
    return json.loads(path.read_text(encoding="utf-8"))


class _QuietHandler(SimpleHTTPRequestHandler):
    """A file server that keeps connections open and writes no log."""

    protocol_version = "HTTP/1.1"

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - named by the base
        """Say nothing: the browser reports what failed."""
