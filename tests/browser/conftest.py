"""What every browser test stands on: a browser, its driver, the pages, two ways to open them."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from tests.helpers import browser


@pytest.fixture(scope="session")
def chromium() -> Callable[..., Any]:
    """Run a script of this folder in Chromium: ``chromium("pages.mjs", site, ...)``."""
    path = browser.require_chromium()
    browser.require_packages()
    return partial(browser.run_script, variables={"CHROMIUM": path})


@pytest.fixture(scope="session")
def firefox() -> Callable[..., Any]:
    """Run a script of this folder in Firefox, likewise."""
    path = browser.require_firefox()
    browser.require_packages()
    return partial(browser.run_script, variables={"FIREFOX": path})


@pytest.fixture(scope="session")
def student_pages() -> Path:
    """The folder of the built pages."""
    return browser.require_pages()


@pytest.fixture(scope="session")
def page_python(student_pages: Path) -> dict[str, Any]:
    """What is packed of Python in the page, NumPy and OpenCV included."""
    path = browser.ROOT / "_build" / "page_python.json"
    if not path.is_file() or not (student_pages / "_static" / "python").is_dir():
        browser.give_up("Python in the page is not packed; run `make book` first")
    manifest: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    if manifest["remote"]:
        # not the browser's absence: without wheels the pages are as they should be, only untested
        pytest.skip("no wheels for Python in the page; CAMERA_LAB_WHEELS names their folder")
    return manifest


@pytest.fixture(scope="session")
def file_site(student_pages: Path) -> str:
    """The address of the pages as files, with a slash at its end."""
    return student_pages.as_uri() + "/"


@pytest.fixture(scope="session")
def http_site(student_pages: Path) -> Iterator[str]:
    """The address of the pages on a server of this machine, with a slash at its end."""
    with browser.serve(student_pages) as address:
        yield address


@pytest.fixture(scope="session", params=browser.PROTOCOLS)
def site(request: pytest.FixtureRequest) -> str:
    """Both addresses, one after the other."""
    return request.getfixturevalue(f"{request.param}_site")


@pytest.fixture(scope="session")
def once(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Callable[..., Any]:
    """Run something once for all test processes: ``once(name, function)``."""
    folder = tmp_path_factory.getbasetemp()
    if worker_id != "master":
        folder = folder.parent  # what the processes of pytest-xdist share
    return lambda name, make: browser.once(folder / f"once-{name}.json", make)


@pytest.fixture(scope="session")
def use_python(
    chromium: Callable[..., Any],
    page_python: dict[str, Any],  # noqa: ARG001 - what pages need to run code
    file_site: str,
    once: Callable[..., Any],
) -> Callable[..., Any]:
    """Run a script once over the pages as files, whose Python has all it needs.

    ``use_python("cells", PAGE, ...)`` runs ``cells.mjs`` with the site and what follows.
    """
    return lambda script, *arguments: once(
        f"{script}-in-page", lambda: chromium(f"{script}.mjs", file_site, *arguments)
    )
