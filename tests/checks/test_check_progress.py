"""The file beside the notebook and the report made from it."""

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
import pytest

import labutils
from labutils.__main__ import main
from labutils.checks import check, hint, report
from labutils.checks.links import find_link, name_link
from labutils.checks.progress import load_progress, save_progress
from labutils.checks.progress_rules import FILE_NAME
from labutils.checks.report import Report
from labutils.checks.table import read_words


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def right(points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray) -> np.ndarray:
    return labutils.camera_to_world(points, cam_xpos, cam_xmat)


def wrong(points: np.ndarray, cam_xpos: np.ndarray, cam_xmat: np.ndarray) -> np.ndarray:
    return labutils.camera_to_world(points, cam_xpos * 0, cam_xmat)


def test_checks_are_kept(folder: Path) -> None:
    check("camera_to_world", wrong)
    check("camera_to_world", wrong)
    check("camera_to_world", right)
    check("camera_to_world", lambda *case: 2 * right(*case))
    check("camera_to_world", lambda *case: right(*case) + case[1].prod())
    check("camera_to_world", lambda *_: 1 / 0)
    check("camera_to_world", lambda *_: None)  # not started: nothing was tried
    kept = json.loads((folder / FILE_NAME).read_text())
    assert kept["version"] == 1
    assert kept["exercises"]["camera_to_world"] == {
        "passed": True,  # once passed stays passed
        "attempts": 6,
        "hints": 0,
        "last_property": "runs",
        "mistakes": {"no-position": 2},
        "relations": {"scaled:2": 1},
        "probes": {"simpler:at-the-origin": 1},
    }
    assert [path.name for path in folder.iterdir()] == [FILE_NAME]


def test_a_check_and_a_hint_keep_the_predictions_of_the_pages(folder: Path) -> None:
    made = {"stale": {"said": "1", "right": False}, "pan": {"said": None, "right": False}}
    content = {"version": 1, "exercises": {}, "predictions": made}
    (folder / FILE_NAME).write_text(json.dumps(content))
    check("camera_to_world", wrong)
    hint("camera_to_world")
    kept = json.loads((folder / FILE_NAME).read_text())
    assert kept["predictions"] == made
    assert kept["exercises"]["camera_to_world"]["hints"] == 1


def test_hints_are_given_in_order_and_counted_up_to_three() -> None:
    hints = read_words()["camera_to_world"]["hints"]
    given = [hint("camera_to_world") for _ in range(4)]
    assert given == [f"Hint {number} of 3: {hints[number - 1]}" for number in (1, 2, 3, 3)]
    assert repr(given[0]) == given[0]
    assert load_progress().get("camera_to_world").hints == 3


@pytest.mark.parametrize(
    "content",
    [
        b"{ not json",
        b"\xff\xfe\x00",
        b"[]",
        b'{"version": 1}',
        b'{"version": 1, "exercises": {"camera_to_world": {"passed": true}}}',
        (
            b'{"version": 1, "exercises": {"camera_to_world": {"passed": "yes", "attempts": 1,'
            b' "hints": 0, "last_property": null, "mistakes": {}}}}'
        ),
        (
            b'{"version": 1, "exercises": {"camera_to_world": {"passed": true, "attempts": 1,'
            b' "hints": 9, "last_property": null, "mistakes": {}}}}'
        ),
        (
            b'{"version": 1, "exercises": {"camera_to_world": {"passed": true, "attempts": 1,'
            b' "hints": 0, "last_property": null, "mistakes": {}, "probes": {"state": "2"}}}}'
        ),
    ],
)
def test_damaged_file_is_set_aside_and_reported(folder: Path, content: bytes) -> None:
    (folder / FILE_NAME).write_bytes(content)
    verdict = check("camera_to_world", right)
    assert verdict.passed
    assert "is kept as labutils-progress-damaged-1.json" in " ".join(verdict.message.split("\n"))
    assert verdict.message.endswith("hidden cases decide the grade.")
    assert (folder / "labutils-progress-damaged-1.json").read_bytes() == content
    assert load_progress().get("camera_to_world").passed
    # A second damaged file does not overwrite the first.
    (folder / FILE_NAME).write_bytes(content)
    assert "damaged-2" in report().notice


def test_damaged_file_that_cannot_be_moved_is_reported(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / FILE_NAME).write_text("{")

    def refuse(*_: object) -> NoReturn:
        raise OSError("read-only")

    monkeypatch.setattr("pathlib.Path.rename", refuse)
    said = "is no progress file: it is no JSON. It cannot be moved; progress starts anew"
    assert said in load_progress().notice


def test_folder_that_cannot_be_written_is_reported(
    monkeypatch: pytest.MonkeyPatch, folder: Path
) -> None:
    def refuse(*_: object) -> NoReturn:
        raise PermissionError("no")

    monkeypatch.setattr("os.replace", refuse)
    verdict = check("camera_to_world", right)
    assert "Progress is not kept" in verdict.message
    assert "PermissionError" in verdict.message
    assert not list(folder.iterdir())  # no half-written file either
    assert "Progress is not kept" in hint("camera_to_world")


def test_folder_that_does_not_exist_is_reported(folder: Path) -> None:
    assert "FileNotFoundError" in save_progress(load_progress(), folder / "gone")


def test_report_shows_what_is_done_and_what_is_next() -> None:
    empty = report()
    assert empty.points == 0
    assert empty.next_row is not None
    assert empty.next_row.name == "render_camera"
    assert "0 of 9 exercises, 0 of 90 points" in repr(empty)
    check("camera_to_world", right)
    check("intrinsics_matrix", lambda *_: 1 / 0)
    hint("intrinsics_matrix")
    text = repr(report())
    assert "1 of 9 exercises, 6 of 90 points in reach so far, and 10 more for code quality" in text
    assert "hidden cases decide the grade" in text
    assert "started, 1 check" in text
    assert "1/3" in text
    assert "Next: render_camera" in text


def test_report_in_jupyter_and_as_a_page_says_the_same() -> None:
    check("camera_to_world", right)
    found = report()
    for text in (found._repr_html_(), found.to_page()):
        for row in found.rows:
            assert row.name in text
        assert "6 of 90 points" in text
    assert found.to_page().startswith("<!doctype html>")


def make_lab() -> Report:
    """The report without the extensions that the book may have."""
    found = report()
    return replace(found, rows=found.lab)


def make_extended(**changes: Any) -> Report:
    """The report of the lab with two rows of an extension."""
    lab = make_lab()
    row = replace(lab.rows[0], chapter="Two eyes", points=0, extension=True)
    rows = (replace(row, name="match_rows"), replace(row, name="find_shift", **changes))
    return replace(lab, rows=(*rows, *lab.rows))


def test_extensions_have_a_table_of_their_own_and_no_points() -> None:
    lab, found = make_lab(), make_extended(passed=True, state="done")
    assert found.points == lab.points
    own, _, rest = repr(found).partition("\n\nextension")
    table, _, sentences = rest.partition("\n\n")
    assert own == repr(lab).partition("\n\n")[0]
    assert [line.split("  ")[0] for line in table.splitlines()[1:]] == ["Two eyes", "Two eyes"]
    assert "points" not in table
    assert "Extensions: 1 of 2. They are no part of the lab" in sentences
    assert "Extensions" not in repr(lab)
    assert found.summary[:2] == lab.summary[:2]


def test_extensions_have_a_table_of_their_own_in_jupyter_too() -> None:
    html = make_extended()._repr_html_()
    first, second = html.split("</table>")[:2]
    assert first + "</table>" in make_lab()._repr_html_()
    assert "match_rows" in second
    assert second.count('<th scope="col"') == 4
    assert "points</th>" not in second


def test_the_lab_comes_before_its_extensions() -> None:
    found = make_extended()
    assert found.next_row is not None
    assert found.next_row.name == "render_camera"
    assert not found.next_row.extension
    done = replace(found, rows=tuple(replace(r, passed=not r.extension) for r in found.rows))
    assert done.next_row is not None
    assert done.next_row.name == "match_rows"


def test_report_when_everything_is_done(folder: Path) -> None:
    record: dict[str, Any] = {
        "passed": True,
        "attempts": 1,
        "hints": 0,
        "last_property": None,
        "mistakes": {},
    }
    content = {"version": 1, "exercises": dict.fromkeys(read_words(), record)}
    (folder / FILE_NAME).write_text(json.dumps(content))
    found = report(folder)
    assert found.next_row is None
    assert found.points == 90
    assert "nothing is left" in repr(found)


def test_command_line_prints_the_report_and_writes_a_page(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["report", "--html", str(folder / "report.html")]) == 0
    assert "0 of 9 exercises" in capsys.readouterr().out
    assert "<table>" in (folder / "report.html").read_text(encoding="utf-8")
    assert main(["report", "--html", str(folder / "no" / "report.html")]) == 1
    assert "no" in capsys.readouterr().err


def test_command_line_reports_another_folder(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    check("camera_to_world", right)
    other = folder / "elsewhere"
    other.mkdir()
    monkeypatch.chdir(other)
    monkeypatch.setattr(sys, "argv", ["labutils", "report", "--in", str(folder)])
    assert main() == 0
    assert "1 of 9 exercises" in capsys.readouterr().out


def test_links_lead_to_the_notebook_where_there_is_one(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = read_words()["camera_to_world"]["section"].partition("#")[0]
    (folder / "exercises").mkdir()
    monkeypatch.chdir(folder / "exercises")
    assert check("camera_to_world", wrong).link.startswith(f"{page}#")
    notebook = page.replace(".html", ".ipynb")
    (folder / "book").mkdir()
    (folder / "exercises" / notebook).touch()
    assert check("camera_to_world", wrong).link == notebook
    assert {row.section for row in report().rows if row.name == "camera_to_world"} == {notebook}
    assert notebook in report().to_page()


def test_links_lead_to_the_source_of_a_chapter_and_name_its_heading(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "exercises").mkdir()
    (folder / "book").mkdir()
    chapter = folder / "book" / "step3_depth.md"
    chapter.write_text("# Step 3\n\n(step3-raw)=\n## What is in it?\n", encoding="utf-8")
    monkeypatch.chdir(folder / "exercises")
    link = find_link("../book/step3_depth.html#step3-raw")
    assert link == "../book/step3_depth.md#step3-raw"
    assert name_link(link) == "step 3: What is in it?"


@pytest.mark.parametrize(
    ("link", "name"),
    [
        ("../book/step3_depth.html#step3-raw", "step 3, raw"),
        ("../book/step3_depth.ipynb", "step 3"),
        ("../book/background.html#background-imu", "background, imu"),
        ("../book/step3_depth.md#step3-raw", "step 3, raw"),  # a file that is not here
    ],
)
def test_links_have_a_name_without_the_chapter_too(link: str, name: str) -> None:
    assert name_link(link) == name
