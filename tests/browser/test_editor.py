"""The editor of an exercise: what it folds, offers, indents, marks and keeps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

PAGE = "exercises/step3_depth"


@pytest.fixture(scope="module")
def used(use_python: Callable[..., Any]) -> dict[str, Any]:
    return use_python("editor", PAGE)


def test_nothing_goes_wrong_in_the_editor(used: dict[str, Any]) -> None:
    assert used["complaints"] == []


def test_a_docstring_is_folded_to_its_first_line_and_opened_by_keyboard(
    used: dict[str, Any],
) -> None:
    folded, opened, again, reset = used["docstring"]["looks"]
    assert folded == again == reset
    assert folded["button"] == "Show the whole docstring"
    assert folded["expanded"] == "false"
    assert folded["summary"].startswith('    """Turn window-space depth into meters.')
    assert opened["expanded"] == "true"
    assert opened["button"] == "Fold the docstring"
    assert opened["lines"] > 3 * folded["lines"]
    assert used["docstring"]["height"] < 250  # the first writable line is in view
    assert used["docstring"]["hidden"]  # where there is no docstring


def test_folding_changes_neither_the_text_nor_the_check(used: dict[str, Any]) -> None:
    starter = used["docstring"]["starter"].rstrip("\n")
    assert used["docstring"]["texts"] == [starter] * 4
    assert "Not started yet." in used["docstring"]["said"]["text"]


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("dept", "depth_raw"),
        ("rati", "ratio"),
        ("prin", "print"),
        ("retu", "return"),
        ("np.arct", "arctan2"),
        ("np.linalg.in", "inv"),
        ("cv2.inR", "inRange"),
    ],
)
def test_names_are_offered_while_one_types(used: dict[str, Any], typed: str, name: str) -> None:
    assert name in used["completion"][typed]


@pytest.mark.parametrize("place", ["comment", "text"])
def test_nothing_is_offered_in_comments_and_texts(used: dict[str, Any], place: str) -> None:
    assert used["completion"][place] == []


def test_a_list_of_names_traps_no_key(used: dict[str, Any]) -> None:
    taking = used["taking"]
    head = "import numpy as np\n"
    assert taking["Enter"]["code"] == f"{head}np.arctan\n"
    assert taking["ArrowDown Enter"]["code"] == f"{head}np.arctan"
    assert taking["Tab"]["code"] == f"{head}np.arctan"
    assert taking["Escape Tab"]["code"] == f"{head}np.arctan"
    assert taking["Escape Tab"]["focus"] == "Run"
    assert taking["Tab"]["focus"] != "Run"


def test_a_line_after_one_that_leaves_its_block_is_dedented(used: dict[str, Any]) -> None:
    dedent = used["dedent"]
    for statement in ("return 1", "pass", "raise ValueError", "break", "continue"):
        assert dedent[statement] == 4, statement
    for statement in ("return (1,", "return [", "returned = 1", "x = 'return'", "return 1 + \\"):
        assert dedent[statement] >= 8, statement
    assert dedent["function"] == 0


def test_mixed_tabs_are_told_and_replaced(used: dict[str, Any]) -> None:
    tabs = used["tabs"]
    assert (tabs["before"], tabs["after"], tabs["inText"]) == (0, 0, 0)
    assert tabs["said"].startswith("Lines 3, 4 begin with tabs, others with spaces")
    assert tabs["marked"] == ["\treturn 1", "\t# so"]
    assert tabs["code"] == "def f(x):\n    if x:\n    return 1\n    # so\n    return 2\n"


def test_the_failing_line_is_marked_until_the_next_edit(used: dict[str, Any]) -> None:
    failed = used["failed"]
    assert failed["check"] == {
        "status": "Your code stops with an error in line 2.",
        "marked": ["y = x +"],
        "gutter": ["2"],
    }
    assert failed["written"] == "x = 1\n1y = x +\n"  # where the button has put the caret
    assert failed["edited"] == failed["reset"] == []
    assert failed["called"]["marked"] == ["    return a.nothing"]
    assert failed["called"]["status"] == "Checked: not yet. It stopped in line 3."
    assert failed["run"]["marked"] == ["    return 1 / 0"]
    assert failed["run"]["status"] == "Your code stops with an error in line 2."


def test_a_stopped_check_shows_what_was_printed(used: dict[str, Any]) -> None:
    printed = used["printed"]
    assert "Stopped." in printed["stopped"]["text"]
    assert "kept" in printed["stopped"]["text"]
    assert "Stopped after 1.5 seconds" in printed["late"]["text"]
    assert "late" in printed["late"]["text"]


def test_everybody_can_use_the_editor(used: dict[str, Any]) -> None:
    assert used["axe"] == []
    assert used["phone"] == {"sideways": 0, "small": []}


def test_two_tabs_on_one_exercise_notice_each_other_and_lose_nothing(
    used: dict[str, Any],
) -> None:
    tabs = used["twoTabs"]
    assert tabs["quiet"]
    assert (
        tabs["said"] == tabs["status"] == "Another tab has changed this code. Here it is as it was."
    )
    assert "NotImplementedError" in tabs["untouched"]
    assert tabs["reloaded"] == {"code": "b = 2\n", "isOffered": True}
    assert tabs["taken"] == "a = 1\n"
    assert tabs["back"] == "b = 2\n"
    assert tabs["isGone"]
    assert tabs["agreed"] == ["c = 3\n", True]
