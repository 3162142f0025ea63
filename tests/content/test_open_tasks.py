"""The open tasks: what is read from a file, and what is refused with its place."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
import yaml

from content.chapters import list_required
from content.open_tasks import OPEN_TASKS, OpenTaskError, load_open_task, load_open_tasks
from tests.helpers.chapters import ROOT

LONG = "A sentence that is long enough to tell somebody what to do, and why."
TASK: dict[str, Any] = {
    "title": "something of your own",
    "minutes": 60,
    "objectives": ["4c"],
    "task": LONG,
    "figure": LONG,
    "number": LONG,
    "paragraph": LONG,
    "criteria": {"Case": LONG, "Number": LONG, "Figure": LONG},
}


def write(folder: Path, entry: Any) -> None:
    (folder / "step4_color.yml").write_text(
        yaml.safe_dump(entry, sort_keys=False), encoding="utf-8"
    )


def test_every_step_of_the_lab_has_one_that_fits_into_an_afternoon() -> None:
    tasks = load_open_tasks()
    assert list(tasks) == [chapter.stem for chapter in list_required()]
    for task in tasks.values():
        assert list(task.criteria) == ["Case", "Number", "Figure", "Explanation"]
        assert 45 <= task.minutes <= 90


def test_learners_find_task_and_criteria_at_the_end_of_the_exercise_page() -> None:
    for chapter in list_required():
        task = load_open_task(chapter.stem)
        page = (ROOT / chapter.exercises).with_suffix(".md").read_text(encoding="utf-8")
        _, _, section = page.partition(f"(open-task-{chapter.id})=\n")
        assert "exercise-" not in section.partition("\n## What is done?")[0].replace("-page", "")
        for text in (task.title, task.task, task.figure, task.number, task.paragraph):
            assert text in section
        for name, asks in task.criteria.items():
            assert f"| {name} | {asks} |" in section
        assert "No points" in section


def test_a_good_task_is_read(tmp_path: Path) -> None:
    write(tmp_path, TASK | {"task": f"{LONG}\n  {LONG}\n"})
    task = load_open_task("step4_color", tmp_path)
    assert task.task == f"{LONG} {LONG}"
    assert task.objectives == ("4c",)
    assert list(task.criteria) == ["Case", "Number", "Figure"]


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ([], "step4_color.yml: expected fields with names"),
        (TASK | {"points": 3}, "unknown field points"),
        ({k: v for k, v in TASK.items() if k != "figure"}, "the field figure is missing"),
        (TASK | {"task": "Do it."}, "task: expected at least 40 characters, got 'Do it.'"),
        (TASK | {"minutes": 5}, "minutes: expected 20 to 120, got 5"),
        (TASK | {"objectives": []}, r"objectives: expected names such as \[4c, 4e\]"),
        (TASK | {"criteria": {"Case": LONG}}, "criteria: expected 3 to 5, got 1"),
        (
            TASK | {"criteria": {"Case": "Good.", "Number": LONG, "Figure": LONG}},
            "criteria: Case: expected at least 40 characters",
        ),
    ],
)
def test_a_bad_task_is_refused_with_the_place(tmp_path: Path, entry: Any, message: str) -> None:
    write(tmp_path, entry)
    with pytest.raises(OpenTaskError, match=message):
        load_open_task("step4_color", tmp_path)


def test_a_missing_and_a_broken_file_are_told(tmp_path: Path) -> None:
    with pytest.raises(OpenTaskError, match=r"step4_color.yml: cannot be read: .*No such file"):
        load_open_task("step4_color", tmp_path)
    (tmp_path / "step4_color.yml").write_text("a: [", encoding="utf-8")
    with pytest.raises(OpenTaskError, match=r"step4_color.yml: cannot be read: while parsing"):
        load_open_task("step4_color", tmp_path)


def test_a_file_of_no_step_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "open_tasks"
    shutil.copytree(OPEN_TASKS, folder)
    (folder / "conventions.yml").touch()
    with pytest.raises(OpenTaskError, match=r"conventions.yml: no step of the lab has this page"):
        load_open_tasks(folder)
