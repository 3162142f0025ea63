"""What runs the cells of a page: one session, a notebook's outputs, errors in the reader's words.

The modules run in a browser, but need nothing of one: here they run in this Python.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest

import page_cells
import page_outputs

Outputs = list[dict[str, Any]]


@pytest.fixture
def session(monkeypatch: pytest.MonkeyPatch) -> Iterator[page_cells.Session]:
    monkeypatch.setattr(page_cells, "SESSION", page_cells.Session())
    yield page_cells.SESSION
    page_outputs.current.begin()


def run(session: page_cells.Session, code: str, number: int = 1) -> Outputs:
    return list(session.run(code, f"cell {number}"))


def test_a_cell_finds_what_cells_before_it_have_made(session: page_cells.Session) -> None:
    run(session, "x = 20")
    assert run(session, "print(x + 1)", 2) == [
        {"output_type": "stream", "name": "stdout", "text": "21\n"}
    ]


def test_the_last_expression_is_the_result(session: page_cells.Session) -> None:
    (output,) = run(session, "x = 2\nx * 3")
    assert output["output_type"] == "execute_result"
    assert output["data"] == {"text/plain": "6"}


@pytest.mark.parametrize("code", ["None", "x = 3", "3;", "", "# nothing", "def f(): return 3"])
def test_what_has_no_result_shows_nothing(session: page_cells.Session, code: str) -> None:
    assert run(session, code) == []


def test_outputs_keep_their_order(session: page_cells.Session) -> None:
    code = "import sys\nprint('a')\nprint('b', file=sys.stderr)\nprint('c')\nprint('d')\n5"
    outputs = run(session, code)
    assert [one.get("text") for one in outputs] == ["a\n", "b\n", "c\nd\n", None]
    assert [one.get("name") for one in outputs] == ["stdout", "stderr", "stdout", None]


def test_what_is_published_meanwhile_stands_where_it_was_shown(
    session: page_cells.Session,
) -> None:
    session.names["show"] = lambda: page_outputs.publish({"output_type": "display_data"})
    outputs = run(session, "print('before')\nshow()\nprint('after')")
    kinds = [one["output_type"] for one in outputs]
    assert kinds == ["stream", "display_data", "stream"]


@pytest.mark.parametrize(("wait", "left"), [(False, ["b"]), (True, ["b"])])
def test_clearing_takes_away_what_stood_before(
    session: page_cells.Session, wait: bool, left: list[str]
) -> None:
    session.names["clear"] = lambda: page_outputs.publish(
        {"output_type": "clear_output", "wait": wait}
    )
    outputs = run(session, "print('a')\nclear()\nprint('b', end='')")
    assert [one["text"] for one in outputs] == left


def test_an_object_shows_every_form_it_has() -> None:
    class Rich:
        def _repr_html_(self) -> str:
            return "<b>bold</b>"

        def _repr_png_(self) -> bytes:
            return b"\x89PNG"

        def __repr__(self) -> str:
            return "plain"

    bundle = page_outputs.make_bundle(Rich())
    assert bundle == {"text/html": "<b>bold</b>", "image/png": "iVBORw==", "text/plain": "plain"}


def test_a_class_is_not_asked_for_the_forms_of_its_objects() -> None:
    class Rich:
        def _repr_html_(self) -> str:
            return "<b>bold</b>"

    assert list(page_outputs.make_bundle(Rich)) == ["text/plain"]


def test_an_error_names_the_line_and_keeps_what_was_printed(session: page_cells.Session) -> None:
    outputs = run(session, "print('until here')\n1 / 0", 4)
    assert outputs[0]["text"] == "until here\n"
    error = outputs[-1]
    assert error["output_type"] == "error"
    assert error["ename"] == "ZeroDivisionError"
    assert error["traceback"][0].startswith("In cell 4:\n  line 2: 1 / 0\n")


def test_an_error_inside_a_function_of_another_cell_names_that_cell(
    session: page_cells.Session,
) -> None:
    run(session, "def divide(a):\n    return a / 0", 1)
    (error,) = run(session, "divide(1)", 2)
    text = error["traceback"][0]
    assert "  line 1: divide(1)\n" in text
    assert "cell 1, line 2 in divide: return a / 0" in text


def test_a_cell_that_fails_leaves_the_session_usable(session: page_cells.Session) -> None:
    run(session, "x = 1\nraise SystemExit('out')")
    assert run(session, "x", 2)[0]["data"]["text/plain"] == "1"


@pytest.mark.parametrize("code", ["%matplotlib inline\nx = 1", "!pip install x"])
def test_commands_of_ipython_are_named_as_such(session: page_cells.Session, code: str) -> None:
    (error,) = run(session, code)
    assert error["ename"] == "SyntaxError"
    assert "commands of IPython" in error["traceback"][0]


def test_input_says_that_nobody_answers() -> None:
    with pytest.raises(RuntimeError, match="write the value into the cell"):
        page_cells.refuse_input("how many? ")


def test_an_endless_print_fills_no_memory_but_is_heard(session: page_cells.Session) -> None:
    heard: list[str] = []
    outputs = session.run("for i in range(5000): print('0123456789')", "cell 1", heard.append)
    text = outputs[0]["text"]
    assert len(text) == page_outputs.MAX_PRINTED + len(page_outputs.TOO_MUCH)
    assert text.endswith(page_outputs.TOO_MUCH)
    assert "".join(heard) == text


def test_code_is_not_changed_by_how_the_runner_itself_is_written(
    session: page_cells.Session,
) -> None:
    # the runner's own `from __future__ import annotations` must not reach the reader's code
    (output,) = run(session, "def f(a: int): pass\nf.__annotations__['a']")
    assert output["data"]["text/plain"] == "<class 'int'>"


def test_code_that_is_checked_finds_what_set_up_cells_made_and_no_more(
    session: page_cells.Session,
) -> None:
    json.loads(page_cells.run("given = 1", "cell 1", None, is_setup=True))
    json.loads(page_cells.run("tried = 2", "exercise", None, is_setup=False))
    assert session.given["given"] == 1
    assert "tried" not in session.given


def test_packages_that_can_be_loaded_are_listed_only_where_they_are_missing() -> None:
    optional = json.dumps({"no_such_package": [], "json": []})
    code = "import json\nfrom no_such_package.part import thing"
    assert json.loads(page_cells.list_missing(code, optional)) == ["no_such_package"]
    assert json.loads(page_cells.list_missing("import (", optional)) == []


def test_a_package_that_did_not_come_is_explained(session: page_cells.Session) -> None:
    page_cells.note_missing("no_such_package", "no network")
    (error,) = run(session, "import no_such_package")
    assert "its files did not come: no network" in error["traceback"][0]
    assert "labutils.figures" in error["traceback"][0]


def test_figures_of_matplotlib_are_shown_and_closed(session: page_cells.Session) -> None:
    code = "import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.figure()\nx = 1"
    outputs = run(session, code)
    assert [one["output_type"] for one in outputs] == ["display_data", "display_data"]
    assert all(one["data"]["image/png"].startswith("iVBOR") for one in outputs)
    assert run(session, "plt.get_fignums()", 2)[0]["data"]["text/plain"] == "[]"


def test_an_error_has_the_line_of_its_own_cell(session: page_cells.Session) -> None:
    run(session, "def fail():\n    return 1 / 0\n")
    assert run(session, "x = 1\n\nfail()", 2)[-1]["line"] == 3
    assert run(session, "x = 1\nif x\n", 3)[-1]["line"] == 2
    assert run(session, "\ndef here():\n    return fail()\nhere()", 4)[-1]["line"] == 3
