"""The page's Python, started once for all tests of this folder and all test processes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tests.helpers import browser, page
from tools.vendor import npm, page_python

INSIDE = Path(__file__).parent / "inside"
#: In the order in which they run: the last one breaks the engine down.
FILES = (
    "names",
    "arrays",
    "objects",
    "errors",
    "rays",
    "parity",
    "exercises",
    "recordings",
    "memory",
)


@pytest.fixture(scope="session")
def shared_folder(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Path:
    """The folder that all test processes of this run share."""
    folder = tmp_path_factory.getbasetemp()
    return folder if worker_id == "master" else folder.parent


@pytest.fixture(scope="session")
def page_said(shared_folder: Path) -> dict[str, Any]:
    """What the functions in ``inside`` said in the page: {file: {function: {value, error}}}."""
    try:
        page_python.vendor()
    except npm.VendorError as error:
        browser.give_up(f"Python in the page is missing: {error}")
    wheels = page.find_wheels()
    if not wheels.files:
        # as for the browser tests: without wheels the pages are as they should be, only untested
        pytest.skip("no wheels for Python in the page; CAMERA_LAB_WHEELS names their folder")
    assets, out = shared_folder / "page-assets", shared_folder / "page-out"

    def run() -> dict[str, Any]:
        page.write_assets(assets, wheels, page.collect_extras())
        out.mkdir()
        return page.run_files(assets, out, *(INSIDE / f"{name}.py" for name in FILES))

    said: dict[str, Any] = json.loads(
        json.dumps(browser.once(shared_folder / "page-said.json", run))
    )
    return said
