"""No right answer that a stranger wrote is refused in the page, whose OpenCV is another."""

from __future__ import annotations

import base64
import io
import json
import re
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from content.chapters import get_chapter
from solutions import load_exercises
from tests.helpers.answers import FOLDER, RIGHT, load_answers

CHAPTERS = sorted({load_exercises()[name].chapter for _, name in RIGHT})

#: A run in the page ends after 20 s, so each has some answers only: fewer where one takes long.
MANY, FEW = 12, 2
SLOW = ("level_cloud", "segment_by_color")

SETUP = """
import base64, io, sys, zipfile
zipfile.ZipFile(io.BytesIO(base64.b64decode("{answers}"))).extractall("/tmp/answers")
sys.path.insert(0, "/tmp/answers")
print("ready")
"""
# what names the simulator makes the page load it
JUDGE = """
import contextlib, io, mujoco
from importlib import import_module
from labutils.checks import judge
from labutils.checks.table import load_table

refused, count = [], 0
for function in import_module("{folder}.{name}").ANSWERS[{first}:{last}]:
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        verdict = judge(load_table("{name}"), function)
    count += 1
    refused += [] if verdict.passed else [function.__name__]
print("judged", count, "refused", refused)
"""


def pack_answers() -> str:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for folder, name in RIGHT:
            archive.write(FOLDER / folder / f"{name}.py", f"{folder}/{name}.py")
    return base64.b64encode(buffer.getvalue()).decode()


def list_runs(chapter: str) -> list[tuple[str, str, int]]:
    """List what to run: the set, the exercise and the first answer."""
    return [
        (folder, name, first)
        for folder, name in RIGHT
        if load_exercises()[name].chapter == chapter
        for first in range(0, len(load_answers(folder, name).ANSWERS), step(name))
    ]


def step(name: str) -> int:
    return FEW if name in SLOW else MANY


@pytest.mark.slow
@pytest.mark.parametrize("chapter", CHAPTERS)
def test_no_right_answer_of_a_stranger_is_refused_in_the_page(
    chapter: str,
    chromium: Callable[..., Any],
    file_site: str,
    page_python: dict[str, Any],  # noqa: ARG001 - needed to run
    tmp_path: Path,
) -> None:
    runs = list_runs(chapter)
    # In its own editor: an exercise brings its table when it is checked.
    planned = [
        {
            "exercise": name,
            "code": JUDGE.format(folder=folder, name=name, first=first, last=first + step(name)),
        }
        for folder, name, first in runs
    ]
    plan = {"setup": SETUP.format(answers=pack_answers()), "runs": planned}
    path = tmp_path / "plan.json"
    path.write_text(json.dumps(plan))
    done = chromium("answers.mjs", file_site, get_chapter(chapter).exercises, path)
    assert done["complaints"] == []
    assert "ready" in done["setup"]
    for run, said in zip(runs, done["said"], strict=True):
        assert re.search(r"judged [1-9]\d* refused \[\]", said), (run, said)
