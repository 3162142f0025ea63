"""The code cells of a page in the hands of a reader: run, edit, fail, stop, come back, print."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import nbformat
import pytest

PAGE = "book/step2_intrinsics"


@pytest.fixture(scope="module")
def seen(use_python: Callable[..., Any]) -> dict[str, Any]:
    return use_python("cells_ui", PAGE)


def test_the_page_reports_no_problem(seen: dict[str, Any]) -> None:
    # without a network the wheels of Matplotlib cannot come, which the browser writes down
    complaints = [one for one in seen["complaints"] if "jsdelivr" not in one]
    assert [one for one in complaints if "ERR_NAME_NOT_RESOLVED" not in one] == []


def test_nothing_is_loaded_before_a_click(seen: dict[str, Any]) -> None:
    assert seen["askedBefore"] == []


def test_the_first_run_says_how_far_loading_is(seen: dict[str, Any]) -> None:
    assert seen["first"]["result"] == "ran"
    assert any(" MB" in text for text in seen["loading"])
    assert seen["loading"][-1].startswith("Ran in ")


def test_a_screen_reader_hears_each_change_of_state_once(seen: dict[str, Any]) -> None:
    words = seen["words"]
    assert words[0] == "Cell 1: running"
    assert words[1].startswith("Cell 1: ran in ")
    assert len(words) == 2


def test_the_focus_stays_on_the_button(seen: dict[str, Any]) -> None:
    assert seen["focusAfterRun"] == "Run cell 1"
    assert seen["focusAfterStop"] == "Run"


def test_a_cell_far_below_runs_after_those_above_it(seen: dict[str, Any]) -> None:
    assert seen["below"]["result"] == "ran"
    assert seen["below"]["pictures"] >= 1
    assert {cell["result"] for cell in seen["above"]} == {"ran"}
    # nobody has asked to see those, so the book's outputs stay, and the page does not move
    assert all(cell["isBuiltShown"] for cell in seen["above"] if cell["builtPictures"])
    assert abs(seen["moved"]) <= 2


def test_one_click_leads_to_the_output_of_the_book_and_back(seen: dict[str, Any]) -> None:
    assert (seen["below"]["isYoursShown"], seen["below"]["isBuiltShown"]) == (True, False)
    assert seen["switched"] == [[False, True], [True, False]]


def test_code_runs_from_the_editor(seen: dict[str, Any]) -> None:
    assert seen["edited"]["text"] == "by keyboard\n42"
    assert seen["editor"] == "Code of cell 1"
    assert seen["marked"]


def test_a_reset_brings_the_cell_of_the_book_back_and_can_be_undone(seen: dict[str, Any]) -> None:
    assert "labutils" in seen["reset"]
    assert seen["undone"] == "print('by keyboard')\n7 * 6\n"


def test_the_page_with_its_changes_is_a_notebook(seen: dict[str, Any]) -> None:
    assert seen["saved"]["name"] == "step2_intrinsics.ipynb"
    notebook = nbformat.from_dict(json.loads(seen["saved"]["text"]))
    nbformat.validate(notebook)
    code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    assert code[0] == "print('by keyboard')\n7 * 6\n"
    assert len(code) == len(seen["above"]) + 1 + (len(code) - seen["number"])
    assert notebook.cells[0].source.startswith("# ")


def test_an_error_names_its_line_and_keeps_what_was_printed(seen: dict[str, Any]) -> None:
    assert seen["wrong"]["result"] == "error"
    assert seen["wrong"]["text"] == "so far"
    assert "line 3: 1 / 0" in seen["wrong"]["error"]
    assert "ZeroDivisionError" in seen["wrong"]["error"]
    assert seen["failedLine"] == ["1 / 0"]


def test_a_cell_below_an_error_says_why_it_did_not_run(seen: dict[str, Any]) -> None:
    assert seen["notRun"]["status"] == "Did not run: Cell 1 has to run first, and stopped."


def test_matplotlib_without_a_network_is_one_sentence(seen: dict[str, Any]) -> None:
    assert "ModuleNotFoundError" in seen["matplotlib"]["error"]
    assert "Draw with labutils.figures, or run the notebook." in seen["matplotlib"]["error"]


def test_matplotlib_that_is_not_the_official_one_is_not_run(seen: dict[str, Any]) -> None:
    assert "is not the file it should be" in seen["forged"]["error"]


def test_a_lack_of_memory_in_the_code_is_an_error_of_the_code(seen: dict[str, Any]) -> None:
    assert "MemoryError: no room" in seen["memory"]["error"]


def test_code_that_never_ends_is_stopped_and_what_it_printed_stays(seen: dict[str, Any]) -> None:
    assert "Stopped after 0.7 seconds" in seen["endless"]["error"]
    assert seen["endless"]["text"] == "began"
    assert seen["stopped"]["error"].startswith("Stopped.")
    assert seen["stopped"]["text"] == "again"


def test_a_change_survives_a_reload(seen: dict[str, Any]) -> None:
    assert seen["reloaded"] == "print('kept')\n"
    assert seen["kept"]["text"] == "kept"
    assert seen["stored"] == []  # once all is reset


def test_the_cells_can_be_used_by_everybody(seen: dict[str, Any]) -> None:
    assert seen["axe"] == []
    assert seen["smallButtons"] == []
    assert seen["sideways"] <= 0


def test_paper_shows_the_cells_and_outputs_of_the_book(seen: dict[str, Any]) -> None:
    printed = seen["print"]
    assert (printed["bars"], printed["yours"]) == (0, 0)
    assert printed["code"] == printed["cells"]
    assert printed["built"] == printed["allBuilt"] > 0


def test_without_scripts_the_page_is_the_book(seen: dict[str, Any]) -> None:
    assert seen["plain"] == {"bars": 0, "code": True, "built": True}
