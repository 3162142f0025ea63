"""Every chapter as a learner runs it: as a notebook, headless, offline, in an empty folder."""

from __future__ import annotations

import nbformat
import pytest

from content.chapters import list_required, list_taught
from labutils import is_gl_available
from tests.helpers.chapters import convert, get_executable_pages, run_notebook, run_tool


@pytest.mark.slow
@pytest.mark.parametrize("page", get_executable_pages(), ids=str)
def test_chapter_runs_as_a_notebook_and_repeats_its_checked_numbers(
    page, tmp_path, record_property
):
    run = run_notebook(convert(page, tmp_path))
    assert run.cells > 0, run.output
    # nbval counts one test per code cell, and has none to skip: all were executed before.
    assert run.passed == run.cells, run.output
    if is_gl_available():  # without it, the notice of the ray caster is due on every page
        assert run.noise == (), "a warning above a result that nobody explains"
    record_property("notebook", f"{page.name}: {run.cells} cells, {run.compared} compared")
    assert [p.name for p in tmp_path.iterdir()] == [f"{page.name}.ipynb"], "left files behind"


@pytest.mark.slow
def test_a_checked_number_that_changes_is_noticed(tmp_path):
    notebook = nbformat.v4.new_notebook()
    source = "import time\nprint(time.time_ns())"
    cell = nbformat.v4.new_code_cell(source, metadata={"tags": ["nbval-check-output"]})
    notebook.cells = [cell]
    nbformat.write(notebook, tmp_path / "clock.ipynb")
    run = run_notebook(tmp_path / "clock.ipynb")
    assert (run.cells, run.passed) == (1, 0)
    assert "mismatch" in run.output


@pytest.mark.slow
def test_a_chapter_that_reaches_for_the_network_is_told(tmp_path):
    code = "import socket; socket.create_connection(('192.0.2.1', 80), timeout=1)"
    (tmp_path / "probe.py").write_text(code, encoding="ascii")
    done = run_tool(tmp_path, "probe")
    assert "a chapter must run without it, but connects to 192.0.2.1" in done.stderr


def test_there_are_chapters_to_run():
    names = [page.name for page in get_executable_pages()]
    assert len(list_required()) == 6
    assert {chapter.stem for chapter in list_taught()} <= set(names)
