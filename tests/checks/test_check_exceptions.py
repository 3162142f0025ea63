"""What a check says of an exception: one true and useful sentence after Python's own words."""

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from labutils.checks import judge
from labutils.checks.exceptions import MAX_LENGTH, explain
from labutils.checks.kinds import get_kind
from labutils.checks.table import Raised, load_table
from labutils.checks.verdict import MAX_LINES
from labutils.checks.writing import encode
from tests.helpers.cells import IMPORTS, add_cell, find_raised, run_cell, stop, write


class Row(NamedTuple):
    exercise: str
    kind: str
    code: str
    sentence: str


def read_catalog() -> list[Row]:
    text = Path(__file__).with_name("exceptions.txt").read_text(encoding="utf-8")
    found = re.findall(r"^(\w+): (\w+)\n((?: {4}.*\n)+)(.+)$", text, re.MULTILINE)
    rows = [
        Row(exercise, kind, re.sub(r"^ {4}", "", code, flags=re.MULTILINE), sentence)
        for exercise, kind, code, sentence in found
    ]
    lines = [line for line in text.splitlines() if line and line[0] != "#"]
    assert sum(2 + row.code.count("\n") for row in rows) == len(lines), "a row is not read"
    return rows


#: NumPy 1 stores 300 in a byte as 44, without an error, and tells a signature in full.
OF_NUMPY_2 = ("mask[0, 0] = 300", "return np.full((2, 3))")

CATALOG = [
    row
    for row in read_catalog()
    if not (np.__version__.startswith("1.") and row.code.strip() in OF_NUMPY_2)
]
CHECKED = [row for row in CATALOG if row.exercise != "cell"]
CELLS = [row for row in CATALOG if row.exercise == "cell"]


def name_row(row: Row) -> str:
    return f"{row.kind}-{row.code.splitlines()[-1].strip()[:40]}"


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("row", CHECKED, ids=name_row)
def test_exception_is_told_with_what_it_means(row: Row) -> None:
    verdict = judge(load_table(row.exercise), write(row.exercise, row.code))
    told = verdict.paragraphs[0]
    assert verdict.property == "runs", verdict.message
    assert told.startswith(f"It stops with {row.kind}"), told
    assert "in your line" in told
    assert told.endswith(row.sentence), told
    assert len(verdict.message.splitlines()) <= MAX_LINES


@pytest.mark.parametrize("row", CELLS, ids=name_row)
def test_cell_of_the_page_that_stops_is_told_likewise(row: Row) -> None:
    name = add_cell(row.code)
    error = stop(run_cell, row.code, name)
    assert type(error).__name__ == row.kind
    assert explain(error, name) == row.sentence


def test_advice_is_two_lines_at_most_and_gives_no_right_number_away() -> None:
    assert len(CHECKED) > 150
    for row in CHECKED:
        advice = find_raised(row.exercise, write(row.exercise, row.code)).advice
        assert 0 < len(advice) <= MAX_LENGTH < 190, advice
        assert "\n" not in advice
        numbers = set(re.findall(r"-?\d+(?:\.\d+)?", advice))
        table = load_table(row.exercise)
        for due in table.expected:
            for part, value in zip(
                table.parts, due if isinstance(due, tuple) else (), strict=False
            ):
                if value is not None and get_kind(part).is_few and part.dtype == "float":
                    assert not numbers & {f"{one:.{d}f}" for one in value.flat for d in (2, 3, 4)}


def test_camera_that_does_not_exist_is_the_point_of_its_case() -> None:
    body = (
        "camera = model.camera(camera_name)\n"
        "f = height / 2 / math.tan(math.radians(camera.fovy[0]) / 2)\n"
        "return np.eye(3) * f, 1.0"
    )
    raised = find_raised("get_camera_intrinsics", write("get_camera_intrinsics", body))
    assert raised.kind == "KeyError"
    assert raised.advice == (
        "The model has no tail_camera, and that is what this case is about: look whether the name "
        "exists, and raise ValueError yourself."
    )
    wrong = write("get_camera_intrinsics", "return model.camera(camera_name + 's').fovy")
    names = find_raised("get_camera_intrinsics", wrong).advice
    assert names.startswith("The model has ")
    assert "camera" in names


def test_name_of_another_function_is_to_be_handed_on() -> None:
    before = f"{IMPORTS}\ndef scale():\n    return depth_raw * 2\n"
    raised = find_raised("process_depth", write("process_depth", "return scale()", before))
    assert raised.line == "line 7: return depth_raw * 2"
    assert raised.advice == (
        "depth_raw belongs to the function process_depth: hand it on as an argument."
    )


def test_name_that_the_function_hides_is_told() -> None:
    body = "count += 1\nreturn count"
    raised = find_raised("process_depth", write("process_depth", body, "count = 0\n"))
    assert "another count than the one outside" in raised.advice


def test_branch_that_is_still_open_is_no_untouched_starter() -> None:
    body = "if np.isnan(depth_raw).any():\n    raise NotImplementedError\nreturn depth_raw"
    verdict = judge(load_table("process_depth"), write("process_depth", body))
    assert verdict.counted
    assert "This case comes to a branch that nobody has written yet" in verdict.paragraphs[0]


@pytest.mark.parametrize(
    "body",
    [
        "raise ValueError('operands could not be broadcast together with shapes (9,) (3,3)')",
        "raise KeyError('near')",
        "raise IndexError('list index out of range')",
        "class OwnError(Exception):\n    pass\nraise OwnError",
        "raise np.linalg.LinAlgError('a matrix of my own')",
        "import json\njson.loads('{')",
    ],
)
def test_exceptions_of_learners_and_unknown_ones_get_no_advice(body: str) -> None:
    assert find_raised("process_depth", write("process_depth", body)).advice == ""


def test_advice_is_no_part_of_the_answer() -> None:
    plain, told = Raised("ValueError", "text"), Raised("ValueError", "text", advice="so it is")
    assert plain == told
    assert encode(told, {}) == encode(plain, {})
