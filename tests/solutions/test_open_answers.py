"""The example answers to open tasks: their numbers are true, and what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from content.open_tasks import load_open_task
from solutions._open_answers import (
    ANSWERS,
    LEVELS,
    Answer,
    OpenAnswerError,
    load_marked,
    load_marked_tasks,
)

ANSWERS_OF = [
    pytest.param(answer, id=f"{page}-{answer.kind}")
    for page, marked in load_marked_tasks().items()
    for answer in marked.answers
]
TASK = load_open_task("step4_color")


@pytest.mark.parametrize("answer", ANSWERS_OF)
def test_every_quoted_number_is_what_the_code_measures(answer: Answer) -> None:
    finding = answer.measure()
    assert set(finding.numbers) == set(answer.numbers)
    for name, quoted in answer.numbers.items():
        # each tolerance has its reason beside it, in the file of the answer
        assert finding.numbers[name] == pytest.approx(quoted.value, abs=quoted.within), (
            f"{name}: {quoted.because}"
        )
    assert min(finding.figure.size) > 100


def test_the_strong_answers_earn_nearly_everything_and_the_typical_ones_about_half() -> None:
    for marked in load_marked_tasks().values():
        most = (LEVELS - 1) * len(marked.task.criteria)
        strong, typical = (answer.total for answer in marked.answers)
        assert strong >= most - 1, marked.task.page
        assert 0.25 * most <= typical <= 0.625 * most, marked.task.page


def test_numbers_are_put_into_the_text() -> None:
    for marked in load_marked_tasks().values():
        for answer in marked.answers:
            text = answer.fill(answer.text)
            assert "{" not in text
            assert sum(character.isdigit() for character in text) > 1


def read_entry() -> dict[str, Any]:
    entry: dict[str, Any] = yaml.safe_load((ANSWERS / "step4_color.yml").read_text("utf-8"))
    return entry


def set_in(entry: dict[str, Any], path: str, value: Any) -> None:
    *folders, name = path.split("/")
    for folder in folders:
        entry = entry[folder]
    if value is None:
        del entry[name]
    else:
        entry[name] = value


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ("weak", {}, "step4_color.yml: unknown field weak; known are levels, strong, typical"),
        ("typical", None, "the field typical is missing"),
        ("levels/Figure", None, "levels: expected the criteria Case, Number, Figure, Explanation"),
        ("levels/Case", ["good", "bad"], "levels: Case: expected 3 texts"),
        ("levels/Case", ["none", "some of it", "all of it"], "Case: expected at least 10"),
        ("strong/text", "It failed.", "strong: text: expected at least 300 characters"),
        ("strong/numbers/iou", None, "strong: expected every number .* got iou in one of them"),
        ("strong/numbers/iou/within", 0, "numbers: iou: within: expected above 0, got 0.0"),
        ("strong/numbers/iou/because", "noise", "iou: because: expected at least 20 characters"),
        ("strong/numbers/iou/value", "0.98", "numbers: iou: value: expected float, got '0.98'"),
        ("typical/marks/Case", None, "typical: marks: expected the criteria Case, Number"),
        ("typical/marks/Case/mark", 3, "marks: Case: mark: expected 0 to 2, got 3"),
        ("typical/marks/Case/because", "good", "Case: because: expected at least 20 characters"),
    ],
)
def test_a_bad_answer_is_refused_with_the_place(
    tmp_path: Path, path: str, value: Any, message: str
) -> None:
    entry = read_entry()
    set_in(entry, path, value)
    (tmp_path / "step4_color.yml").write_text(yaml.safe_dump(entry, sort_keys=False), "utf-8")
    with pytest.raises(OpenAnswerError, match=message):
        load_marked(TASK, tmp_path)


def test_a_strong_answer_has_more_marks_than_a_typical_one(tmp_path: Path) -> None:
    entry = read_entry()
    entry["strong"]["marks"], entry["typical"]["marks"] = (
        {name: {"mark": mark, "because": "a reason of twenty characters"} for name in TASK.criteria}
        for mark in (1, 1)
    )
    for kind in ("strong", "typical"):
        entry[kind]["text"] += " ".join(f"{{{name}}}" for name in entry[kind]["numbers"])
    (tmp_path / "step4_color.yml").write_text(yaml.safe_dump(entry, sort_keys=False), "utf-8")
    with pytest.raises(OpenAnswerError, match="more marks for the strong answer, got 4 and 4"):
        load_marked(TASK, tmp_path)


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(OpenAnswerError, match=r"step4_color.yml: cannot be read"):
        load_marked(TASK, tmp_path)
