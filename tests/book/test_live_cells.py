"""The code cells of the built pages: plain without scripts, and all that the scripts need."""

from __future__ import annotations

import json
import re
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest

import live_cells

ROOT = Path(__file__).resolve().parents[2]
HTML = ROOT / "_build" / "html"
DATA = re.compile(r'<script type="application/json" id="python-data">(.*?)</script>', re.DOTALL)
CELL = 'class="cell_input docutils container"'


@pytest.fixture(scope="module")
def pages() -> dict[str, str]:
    if not (HTML / "index.html").is_file() or not (HTML / "_static" / "python").is_dir():
        pytest.skip("the book is not built; run `make book` first")
    return {
        path.relative_to(HTML).with_suffix("").as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(HTML.rglob("*.html"))
    }


def read_data(page: str) -> dict[str, Any]:
    found = DATA.search(page)
    assert found is not None
    return json.loads(found[1])


def test_pages_with_code_load_the_scripts_in_order_and_no_other_page_does(
    pages: dict[str, str],
) -> None:
    with_code = [name for name, page in pages.items() if CELL in page]
    assert len(with_code) > 10
    for name, page in pages.items():
        if name not in with_code:
            assert "_static/python" not in page, name
            continue
        exercises = live_cells.EXERCISE_SCRIPTS if 'class="exercise"' in page else ()
        scripts = (*live_cells.SCRIPTS, *exercises, *live_cells.LAST_SCRIPTS)
        places = [page.index(f"_static/python/{script}") for script in scripts]
        assert places == sorted(places), name
        # what is large comes on a click
        assert "_static/python/vendor" not in DATA.sub("", page), name


def test_every_file_of_python_that_a_page_names_is_there(pages: dict[str, str]) -> None:
    for name, page in pages.items():
        if CELL not in page:
            continue
        data = read_data(page)
        assert data["page"] == name
        assert set(data["parts"]) == {"python", "recordings", "simulator", "widgets"}
        for asset in (asset for part in data["parts"].values() for asset in part):
            assert asset["files"]
            for file in asset["files"]:
                assert (HTML / name).parent.joinpath(data["base"], file).is_file(), file


def test_the_licenses_of_what_runs_in_the_page_are_there(pages: dict[str, str]) -> None:
    assert pages
    folder = HTML / "_static" / "python" / "licenses"
    notice = (folder / "NOTICE.txt").read_text(encoding="utf-8")
    for name in ("Pyodide", "CPython", "NumPy", "OpenCV", "MuJoCo", "ipywidgets", "CodeMirror"):
        assert name in notice
    for file in re.findall(r"[\w-]+-licenses\.txt", notice):
        assert (folder / file).stat().st_size > 500, file


def test_data_for_scripts_cannot_end_its_element() -> None:
    element = live_cells.make_json_element("x", {"text": "</script><b>"})
    assert element.count("</") == 1
    assert json.loads(element.partition(">")[2].rpartition("</")[0]) == {"text": "</script><b>"}


def test_the_start_page_names_the_simulators_that_there_are() -> None:
    text = (ROOT / "book" / "start.md").read_text(encoding="utf-8")
    package = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))
    assert f"MuJoCo {package['dependencies']['@mujoco/mujoco']}, the newest" in text
    assert f"come from MuJoCo {version('mujoco')}." in text
