"""Every chapter as a learner runs it: as a notebook, headless, offline, in an empty folder."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import nbformat
import pytest
from jupyter_cache.base import CacheBundleIn
from jupyter_cache.cache.main import JupyterCacheBase
from nbformat import NotebookNode

from content.chapters import list_required, list_taught
from labutils import is_gl_available
from tests.helpers import notebooks
from tests.helpers.chapters import get_executable_pages
from tests.helpers.notebooks import (
    CHECKED,
    NOTICE,
    NotebookRun,
    convert,
    find_execution,
    make_clean_stamp,
    run_notebook,
    run_python,
)


@pytest.mark.parametrize("page", get_executable_pages(), ids=str)
def test_chapter_runs_as_a_notebook_and_repeats_its_checked_numbers(
    page: Path, tmp_path: Path, record_property: Callable[[str, object], None]
) -> None:
    run = run_notebook(convert(page, tmp_path))
    assert run.cells > 0, run.output
    # nbval counts one test per code cell, and has none to skip: all were executed before.
    assert run.passed == run.cells, run.output
    if is_gl_available():  # without it, the notice of the ray caster is due on every page
        assert run.noise == (), "a warning above a result that nobody explains"
    compared = f"{run.compared} compared with {run.reference}"
    record_property("notebook", f"{page.name}: {run.cells} cells, {compared}")
    assert [p.name for p in tmp_path.iterdir()] == [f"{page.name}.ipynb"], "left files behind"


def make_cell(
    source: str, *tags: str, text: str | None = None, name: str = "stdout"
) -> NotebookNode:
    """Make a cell; with a text, as one that has put it out."""
    cell = nbformat.v4.new_code_cell(source, metadata={"tags": list(tags)})
    if text is not None:
        cell.execution_count = 1
        cell.outputs = [nbformat.v4.new_output("stream", name=name, text=text)] if text else []
    return cell


def write_notebook(folder: Path, *cells: NotebookNode) -> Path:
    path = folder / "some.ipynb"
    nbformat.write(nbformat.v4.new_notebook(cells=list(cells)), path)
    return path


def test_a_checked_number_that_changes_is_noticed(tmp_path: Path) -> None:
    cell = make_cell("import time\nprint(time.time_ns())", CHECKED)
    run = run_notebook(write_notebook(tmp_path, cell))
    assert (run.cells, run.passed, run.reference) == (1, 0, "a first run")
    assert "mismatch" in run.output


@pytest.fixture(scope="module")
def rerun(tmp_path_factory: pytest.TempPathFactory) -> tuple[NotebookRun, Path]:
    """Run a notebook again, of which one number is another than before."""
    warn = "import sys; print('{}', file=sys.stderr)"
    path = write_notebook(
        tmp_path_factory.mktemp("again"),
        make_cell("print(6 * 7)", CHECKED, text="42\n"),
        make_cell("print(6 * 7)", text="unmarked\n"),
        make_cell(warn.format("new noise"), text=""),
        make_cell(warn.format("on purpose"), NOTICE, text=""),
        make_cell("pass", text="old noise\n", name="stderr"),
        make_cell("print(6 * 7)", CHECKED, text="41\n"),
    )
    return run_notebook(path), path


def test_a_number_other_than_the_builds_is_noticed(rerun: tuple[NotebookRun, Path]) -> None:
    run, _ = rerun
    assert (run.cells, run.compared, run.passed, run.reference) == (6, 2, 0, "the build")
    assert "1 failed, 5 passed" in run.output
    assert "mismatch" in run.output


def test_a_warning_is_heard_in_the_build_and_now_unless_it_is_announced(
    rerun: tuple[NotebookRun, Path],
) -> None:
    run, _ = rerun
    assert run.noise == ("old noise\n", "new noise\n")


def test_running_a_notebook_again_leaves_nothing_behind(rerun: tuple[NotebookRun, Path]) -> None:
    _, path = rerun
    assert list(path.parent.iterdir()) == [path]


def test_a_marked_cell_that_prints_nothing_is_told(tmp_path: Path) -> None:
    run = run_notebook(write_notebook(tmp_path, make_cell("silent = 1", CHECKED, text="")))
    assert run.passed == 0
    assert "prints nothing: ['silent = 1']" in run.output


@pytest.fixture
def kept(tmp_path: Path) -> tuple[Path, NotebookNode]:
    """Keep an execution the way the build does; return its folder and the cell without output."""
    cell = make_cell("print(6 * 7)", CHECKED, text="42\n")
    notebook = nbformat.v4.new_notebook(cells=[cell])
    memory = JupyterCacheBase(tmp_path / ".jupyter_cache")
    memory.cache_notebook_bundle(CacheBundleIn(notebook, "page.md"), check_validity=False)
    stamp = make_clean_stamp()
    (tmp_path / "stamps.json").write_text(json.dumps({"cells": stamp, "pages": ""}))
    notebooks.is_build_current.cache_clear()
    return tmp_path, make_cell("print(6 * 7)", CHECKED)


def find(folder: Path, *cells: NotebookNode) -> NotebookNode | None:
    return find_execution(nbformat.v4.new_notebook(cells=list(cells)), folder)


def test_what_the_build_has_run_need_not_run_before_it_is_compared(
    kept: tuple[Path, NotebookNode],
) -> None:
    folder, cell = kept
    executed = find(folder, cell)
    assert executed is not None
    (found,) = executed.cells
    assert (found.source, found.execution_count) == (cell.source, 1)
    assert found.outputs[0].text == "42\n"


def test_a_page_that_has_changed_since_the_build_runs_first(
    kept: tuple[Path, NotebookNode],
) -> None:
    folder, cell = kept
    assert find(folder, make_cell("print(6 * 9)", CHECKED)) is None
    assert find(folder, make_cell(cell.source)) is None  # no longer marked
    assert find(folder, cell, make_cell("one_more = 1")) is None


def test_with_another_library_or_without_a_build_pages_run_first(
    kept: tuple[Path, NotebookNode],
) -> None:
    folder, cell = kept
    (folder / "stamps.json").write_text(json.dumps({"cells": "another", "pages": ""}))
    notebooks.is_build_current.cache_clear()
    assert find(folder, cell) is None
    assert find(folder / "nowhere", cell) is None


def test_a_chapter_that_reaches_for_the_network_is_told(tmp_path: Path) -> None:
    code = "import socket; socket.create_connection(('192.0.2.1', 80), timeout=1)"
    (tmp_path / "probe.py").write_text(code, encoding="ascii")
    done = run_python(tmp_path, "probe.py")
    assert "a chapter must run without it, but connects to 192.0.2.1" in done.stderr


def test_there_are_chapters_to_run() -> None:
    names = [page.name for page in get_executable_pages()]
    assert len(list_required()) == 6
    assert {chapter.stem for chapter in list_taught()} <= set(names)
