"""What instructors get of the open tasks: levels of each criterion, and two example answers.

The texts stand in ``solutions/open_tasks``, in a file named like the page of the chapter; a module
of the same name beside it holds the code that measured them.

.. code-block:: yaml

    levels:                     # what earns 0, 1 and 2, for each criterion of the task
      Case: [no scene, ..., ...]
    strong:
      text: The masks touch at {gap_px} px ...
      numbers:                  # every number that text and marks quote, and no other
        gap_px: {value: 4.0, within: 0.5, because: a pixel more or less of outline}
      alt: Two red objects ...  # of its figure
      caption: Left ...
      marks:
        Case: {mark: 2, because: One thing changes ...}
    typical: ...                # likewise, with gaps

A quoted number is measured again by the tests, and may be off by ``within``: what differs between
graphics drivers and versions, and no more.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from content.fields import check_fields, read_yaml
from content.open_tasks import OpenTask, check_length, load_open_tasks

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from labutils.figures import Picture

ANSWERS = Path(__file__).parent / "open_tasks"
KINDS = ("strong", "typical")
LEVELS = 3  # 0, 1 and 2
MOST = LEVELS - 1
MIN_ANSWER, MIN_REASON, MIN_LEVEL = 300, 20, 10  # characters
QUOTED = re.compile(r"\{(\w+)\}")


class OpenAnswerError(ValueError):
    """A file of example answers is wrong; the message says where and what was expected."""


@dataclass(frozen=True)
class Finding:
    """What the code of an example answer has measured, and drawn."""

    numbers: Mapping[str, float]
    figure: Picture


@dataclass(frozen=True)
class Quoted:
    """A number of an answer, how far it may be off, and why so far."""

    value: float
    within: float
    because: str


@dataclass(frozen=True)
class Mark:
    """What a criterion earns, and the reason."""

    mark: int
    because: str


@dataclass(frozen=True)
class Answer:
    """One example answer."""

    kind: str
    text: str  # with names of numbers in braces, see fill
    numbers: dict[str, Quoted]
    alt: str
    caption: str
    marks: dict[str, Mark]
    measure: Callable[[], Finding]

    def fill(self, text: str) -> str:
        """Put the numbers of the answer into a text that quotes them."""
        return QUOTED.sub(lambda name: f"{self.numbers[name[1]].value:g}", text)

    @property
    def total(self) -> int:
        """What all criteria earn together."""
        return sum(one.mark for one in self.marks.values())


@dataclass(frozen=True)
class Marked:
    """An open task with everything that learners do not get."""

    task: OpenTask
    levels: dict[str, tuple[str, ...]]  # of a criterion, from 0 on
    answers: tuple[Answer, ...]


def load_marked_tasks(folder: Path = ANSWERS) -> dict[str, Marked]:
    """Read levels and answers of all open tasks, by the names of their pages."""
    return {page: load_marked(task, folder) for page, task in load_open_tasks().items()}


def load_marked(task: OpenTask, folder: Path = ANSWERS) -> Marked:
    """Read levels and answers of one open task.

    Raises
    ------
    OpenAnswerError
        If the file is missing, or something in it is missing, unknown or against the rules.
    """
    where = f"{task.page}.yml"
    entry = read_yaml(folder / where, OpenAnswerError)
    due = {"levels": dict, **dict.fromkeys(KINDS, dict)}
    fields = check_fields(where, entry, due, {}, OpenAnswerError)
    levels = _read_levels(f"{where}: levels", fields["levels"], task)
    answers = tuple(_read_answer(f"{where}: {kind}", fields[kind], kind, task) for kind in KINDS)
    strong, typical = answers
    if strong.total <= typical.total:
        raise OpenAnswerError(
            f"{where}: expected more marks for the strong answer, "
            f"got {strong.total} and {typical.total}"
        )
    return Marked(task, levels, answers)


def _read_levels(where: str, entry: Any, task: OpenTask) -> dict[str, tuple[str, ...]]:
    _check_names(where, entry, task)
    fields = check_fields(where, entry, dict.fromkeys(task.criteria, list), {}, OpenAnswerError)
    for name, texts in fields.items():
        if len(texts) != LEVELS or len(set(map(str, texts))) != LEVELS:
            raise OpenAnswerError(f"{where}: {name}: expected {LEVELS} texts, got {texts!r}")
        for text in texts:
            check_length(f"{where}: {name}", str(text), MIN_LEVEL, OpenAnswerError)
    return {name: tuple(map(str, texts)) for name, texts in fields.items()}


def _read_answer(where: str, entry: Any, kind: str, task: OpenTask) -> Answer:
    due = {**dict.fromkeys(("text", "alt", "caption"), str), "numbers": dict, "marks": dict}
    fields = check_fields(where, entry, due, {}, OpenAnswerError)
    check_length(f"{where}: text", fields["text"], MIN_ANSWER, OpenAnswerError)
    numbers = {
        name: _read_number(f"{where}: numbers: {name}", one)
        for name, one in fields["numbers"].items()
    }
    _check_names(f"{where}: marks", fields["marks"], task)
    marks = {
        name: _read_mark(f"{where}: marks: {name}", fields["marks"][name]) for name in task.criteria
    }
    texts = (fields["text"], *(one.because for one in marks.values()))
    if odd := set(QUOTED.findall(" ".join(texts))) ^ set(numbers):
        raise OpenAnswerError(
            f"{where}: expected every number in numbers and in a text, "
            f"got {', '.join(sorted(odd))} in one of them only"
        )
    return Answer(
        kind,
        fields["text"].strip(),
        numbers,
        fields["alt"],
        fields["caption"],
        marks,
        getattr(import_module(f"solutions.open_tasks.{task.page}"), f"measure_{kind}"),
    )


def _check_names(where: str, entry: Any, task: OpenTask) -> None:
    if list(entry) != list(task.criteria):
        raise OpenAnswerError(
            f"{where}: expected the criteria {', '.join(task.criteria)}, got {', '.join(entry)}"
        )


def _read_number(where: str, entry: Any) -> Quoted:
    if isinstance(entry, dict):
        entry = {k: float(v) if type(v) is int else v for k, v in entry.items()}
    due = {"value": float, "within": float, "because": str}
    quoted = Quoted(**check_fields(where, entry, due, {}, OpenAnswerError))
    if quoted.within <= 0:
        raise OpenAnswerError(f"{where}: within: expected above 0, got {quoted.within}")
    check_length(f"{where}: because", quoted.because, MIN_REASON, OpenAnswerError)
    return quoted


def _read_mark(where: str, entry: Any) -> Mark:
    mark = Mark(**check_fields(where, entry, {"mark": int, "because": str}, {}, OpenAnswerError))
    if not 0 <= mark.mark <= MOST:
        raise OpenAnswerError(f"{where}: mark: expected 0 to {MOST}, got {mark.mark}")
    check_length(f"{where}: because", mark.because, MIN_REASON, OpenAnswerError)
    return mark
