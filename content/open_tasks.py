"""The open tasks: one for each step of the lab, without points and without a check.

An open task has no right answer: learners choose a case of their own, measure it against the
simulator's truth, and explain what they found. Each stands in ``exercises/open_tasks``, in a file
named like the page of its chapter. Texts are MyST markdown.

.. code-block:: yaml

    title: a mask that is right, and useless   # follows "Open task:"
    minutes: 60
    objectives: [4c, 4e]
    task: Find a scene in which ...            # what to do
    figure: The picture with ...               # what to hand in: a figure,
    number: The overlap ... in pixels          # a number against the truth,
    paragraph: Why ...                         # and a paragraph
    criteria:                                  # what is looked at, and what it asks
      Case: The scene fails for one reason ...

How the criteria are marked, and what answers look like, is for instructors: it stands in
``solutions/open_tasks``, which no learner gets.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from content import ROOT
from content.chapters import list_required
from content.fields import check_fields, read_yaml

if TYPE_CHECKING:
    from pathlib import Path

OPEN_TASKS = ROOT / "exercises" / "open_tasks"

MIN_TEXT = 40  # characters; less tells nobody what to do
CRITERIA = range(3, 6)
MINUTES = range(20, 121)

TEXTS = ("title", "task", "figure", "number", "paragraph")


class OpenTaskError(ValueError):
    """A file of an open task is wrong; the message says where and what was expected."""


@dataclass(frozen=True)
class OpenTask:
    """What learners read of one open task."""

    page: str
    title: str
    minutes: int
    objectives: tuple[str, ...]
    task: str
    figure: str
    number: str
    paragraph: str
    criteria: dict[str, str]  # name to what it asks


def load_open_task(page: str, folder: Path = OPEN_TASKS) -> OpenTask:
    """Read the open task of one page.

    Raises
    ------
    OpenTaskError
        If the file is missing, or something in it is missing, unknown or against the rules.
    """
    where = f"{page}.yml"
    entry = read_yaml(folder / where, OpenTaskError)
    fields = check_fields(
        where,
        entry,
        required={
            **dict.fromkeys(TEXTS, str),
            "minutes": int,
            "objectives": list,
            "criteria": dict,
        },
        optional={},
        error=OpenTaskError,
    )
    texts = {name: " ".join(fields[name].split()) for name in TEXTS}
    for name in TEXTS[1:]:
        check_length(f"{where}: {name}", texts[name], MIN_TEXT, OpenTaskError)
    if fields["minutes"] not in MINUTES:
        raise OpenTaskError(
            f"{where}: minutes: expected {MINUTES[0]} to {MINUTES[-1]}, got {fields['minutes']}"
        )
    return OpenTask(
        page=page,
        minutes=fields["minutes"],
        objectives=_read_objectives(where, fields["objectives"]),
        criteria=_read_criteria(where, fields["criteria"]),
        **texts,
    )


def load_open_tasks(folder: Path = OPEN_TASKS) -> dict[str, OpenTask]:
    """Read the open tasks of all steps, by the names of their pages.

    Raises
    ------
    OpenTaskError
        If a step has none, or a file belongs to no step.
    """
    due = [chapter.stem for chapter in list_required()]
    if strangers := sorted({path.stem for path in folder.glob("*.yml")} - set(due)):
        raise OpenTaskError(f"{strangers[0]}.yml: no step of the lab has this page")
    return {page: load_open_task(page, folder) for page in due}


def check_length(where: str, text: str, least: int, error: type[ValueError]) -> None:
    """Refuse a text that is too short to say anything."""
    if len(text) < least:
        raise error(f"{where}: expected at least {least} characters, got {text!r}")


def _read_objectives(where: str, names: list[Any]) -> tuple[str, ...]:
    if not names or not all(isinstance(name, str) for name in names):
        raise OpenTaskError(f"{where}: objectives: expected names such as [4c, 4e], got {names!r}")
    return tuple(names)


def _read_criteria(where: str, entry: dict[Any, Any]) -> dict[str, str]:
    if len(entry) not in CRITERIA:
        raise OpenTaskError(
            f"{where}: criteria: expected {CRITERIA[0]} to {CRITERIA[-1]}, got {len(entry)}"
        )
    fields = check_fields(f"{where}: criteria", entry, dict.fromkeys(entry, str), {}, OpenTaskError)
    for name, text in fields.items():
        check_length(f"{where}: criteria: {name}", text, MIN_TEXT, OpenTaskError)
    return fields
