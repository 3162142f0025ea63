"""What runs the reader's code on the page: fresh namespaces, short tracebacks, the progress file.

The module runs in a browser, but needs nothing of one: here it runs in this Python.
"""

import json
import warnings
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

import pytest

from labutils.checks.progress import Progress, Record, load_progress, save_progress
from tests.helpers.scripts import load_script

NAME = "find_object_centroid"
WRONG = f"def {NAME}(mask):\n    print('looking')\n    return (0, 0)\n"

Run: TypeAlias = Callable[..., dict[str, Any]]


@pytest.fixture(scope="module")
def runner() -> ModuleType:
    return load_script("book/_page_python/page_runner.py")


@pytest.fixture
def run(runner: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    return lambda code, name=NAME, progress="": json.loads(runner.run(code, name, progress))


def make_progress(folder: Path, **records: Record) -> str:
    save_progress(Progress(dict(records)), folder)
    return (folder / "labutils-progress.json").read_text()


def test_a_wrong_answer_gets_the_verdict_of_the_notebook(run: Run) -> None:
    said = run(WRONG)
    assert said["result"] == "failed"
    assert said["headline"] == f"{NAME}: not yet (type)"
    assert said["headline"] in said["html"]
    assert "Case" in said["html"]
    assert said["printed"].splitlines()[0] == "looking"
    assert said["error"] == ""


def test_the_progress_file_before_is_counted_on(run: Run, tmp_path: Path) -> None:
    before = make_progress(tmp_path, **{NAME: Record(attempts=4, hints=2, passed=True)})
    said = run(WRONG, progress=before)
    (tmp_path / "labutils-progress.json").write_text(said["progress"])
    record = load_progress(tmp_path).records[NAME]
    assert (record.attempts, record.hints, record.passed) == (5, 2, True)


def test_without_a_progress_file_an_older_one_is_not_taken(run: Run, tmp_path: Path) -> None:
    make_progress(tmp_path, **{NAME: Record(attempts=4)})
    assert json.loads(run(WRONG)["progress"])["exercises"][NAME]["attempts"] == 1


def test_a_starter_leaves_no_trace_in_the_progress(run: Run) -> None:
    said = run(f"def {NAME}(mask):\n    raise NotImplementedError\n")
    assert said["result"] == "failed"
    assert "Not started yet." in said["html"]
    assert said["progress"] == ""


def test_every_check_has_a_namespace_of_its_own(run: Run) -> None:
    assert run(f"seen = 1\n{WRONG}")["result"] == "failed"
    said = run(f"print('seen' in globals())\n{WRONG}")
    assert said["printed"].startswith("False\n")


def test_the_names_of_the_first_cell_are_there_as_in_the_notebook(run: Run) -> None:
    said = run(f"assert check and hint and report\n{WRONG}")
    assert said["error"] == ""


def test_a_traceback_names_only_the_lines_of_the_reader(run: Run) -> None:
    said = run("import json\n\ndef load(text):\n    return json.loads(text)\n\nload('{')\n")
    assert said["result"] == "error"
    lines = said["error"].splitlines()
    assert lines[:3] == [
        "In your code:",
        "  line 6: load('{')",
        "  line 4 in load: return json.loads(text)",
    ]
    assert lines[3].startswith("json.decoder.JSONDecodeError: Expecting property name")
    assert len(lines) == 4


def test_a_slip_of_the_pen_names_its_line(run: Run) -> None:
    said = run("x = 1\nif x\n    y = 2\n")
    assert said["result"] == "error"
    assert said["error"].splitlines()[0].strip() == "line 2"
    assert "SyntaxError: expected ':'" in said["error"]
    assert said["error"].splitlines()[-1].startswith("A line that begins a block")


def test_a_cell_that_stops_is_told_what_helps(run: Run) -> None:
    said = run(f"K = np.eye(3)\n{WRONG}")
    assert said["error"].splitlines() == [
        "In your code:",
        "  line 1: K = np.eye(3)",
        "NameError: name 'np' is not defined",
        'It is not imported: put "import numpy as np" at the top of your code.',
    ]


def test_a_check_that_stops_is_told_what_helps(run: Run) -> None:
    said = run(f"import cv2\ndef {NAME}(mask):\n    return cv2.moment(mask)\n")
    assert "What exists instead: cv2.moments." in said["html"]


def test_an_exception_in_a_check_names_the_line_of_the_reader(run: Run) -> None:
    said = run(f"def {NAME}(mask):\n    return mask.nothing\n")
    assert said["result"] == "failed"
    assert "in your line 2: return mask.nothing" in said["html"]


def test_a_function_of_another_name_is_asked_back(run: Run) -> None:
    said = run("def find_center(mask):\n    return None\n")
    assert said["error"] == f"Your code has no function {NAME}: keep its name as it was."


@pytest.mark.parametrize("ending", ["raise SystemExit('enough')", "raise KeyboardInterrupt"])
def test_nothing_the_reader_raises_ends_python(run: Run, ending: str) -> None:
    said = run(f"print('before')\n{ending}\n")
    assert said["result"] == "error"
    assert said["printed"] == "before\n"
    assert ending.split()[1].partition("(")[0] in said["error"]


def test_what_a_loop_prints_is_cut(run: Run, runner: ModuleType) -> None:
    said = run("for n in range(100_000):\n    print(n)\n" + WRONG)
    assert len(said["printed"]) < runner.MAX_PRINTED + 100
    assert said["printed"].count("(more was printed than can be shown)") == 1


def test_a_filter_for_warnings_ends_with_its_check(run: Run) -> None:
    before = list(warnings.filters)
    run(f"import warnings\nwarnings.simplefilter('ignore')\n{WRONG}")
    assert list(warnings.filters) == before


@pytest.mark.parametrize(
    ("code", "line"),
    [
        ("x = 1\nif x\n", 2),
        ("def f():\n    return 1 / 0\n\nf()\n", 2),
        ("import json\njson.loads('{')\n", 2),
        (f"def {NAME}(mask):\n    total = mask\n    return total.nothing\n", 3),
        (f"def {NAME}(mask):\n    total = mask\n    raise NotImplementedError\n", 3),
    ],
)
def test_the_line_that_stopped_is_told(run: Run, code: str, line: int) -> None:
    assert run(code)["line"] == line


@pytest.mark.parametrize(
    "code", [WRONG, "def other(): pass\n", f"def {NAME}(mask):\n    raise NotImplementedError\n"]
)
def test_what_does_not_stop_has_no_line(run: Run, code: str) -> None:
    assert run(code)["line"] is None


def test_what_is_printed_is_told_at_once(
    runner: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    told: list[str] = []
    code = "print('first')\nprint(told[:])\n" + WRONG
    runner.page_cells.SESSION.given["told"] = told
    try:
        said = json.loads(runner.run(code, NAME, "", told.append))
    finally:
        del runner.page_cells.SESSION.given["told"]
    assert "['first', '\\n']" in said["printed"]
    assert "".join(told) == said["printed"]


def test_a_package_that_did_not_come_is_named(
    run: Run, runner: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(runner.page_cells.SESSION.missing, "nowhere", "no network")
    assert (
        "nowhere is no part of this page, and its files did not come"
        in run("import nowhere\n")["error"]
    )
