"""The concept questions: read the files in ``exercises/concepts`` and refuse what is wrong.

One file per page, named like it: a list of items as below. Texts are MyST markdown.

.. code-block:: yaml

    - id: 2a                  # unique in the book
      objective: 2a           # of the same page; left out where a page has none
      section: step2-focal    # label above the heading to read again
      check: test_...         # optional: the test that computes the answer
      question: How many ...?
      choices:                # 3 or 4
        - text: 240 px
          right: true         # exactly one
          feedback: Half the height ...
        - text: 480 px
          feedback: This puts the whole height ...
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from content import ROOT
from content.fields import check_fields

CONCEPTS = ROOT / "exercises" / "concepts"

MIN_FEEDBACK = 40  # characters; "wrong" explains nothing
ITEMS_PER_PAGE = range(2, 6)
CHOICES = range(3, 5)
ITEM_ID = re.compile(r"[0-9a-z]{2,8}")


class QuizError(ValueError):
    """A file of questions is wrong; the message says where and what was expected."""


@dataclass(frozen=True)
class Choice:
    """One answer to choose, and what to say to the reader who chose it."""

    text: str
    feedback: str
    right: bool


@dataclass(frozen=True)
class Item:
    """One question."""

    page: str
    id: str
    section: str
    question: str
    choices: tuple[Choice, ...]
    objective: str | None
    check: str | None

    @property
    def right_index(self) -> int:
        """The place of the right choice, counted from 0."""
        return next(i for i, choice in enumerate(self.choices) if choice.right)

    @property
    def right_text(self) -> str:
        """What the right choice says."""
        return self.choices[self.right_index].text


def load_page(page: str, folder: Path = CONCEPTS) -> tuple[Item, ...]:
    """Read the questions of one page.

    Raises
    ------
    QuizError
        If there is no such file, or something in it is missing, unknown or against the rules.
    """
    path = folder / f"{page}.yml"
    if not path.is_file():
        known = ", ".join(list_pages(folder)) or "none"
        raise QuizError(f"{page}: no questions for this page; there are some for: {known}")
    try:
        entries = yaml.safe_load(path.read_text(encoding="utf-8"))
    except yaml.YAMLError as error:
        raise QuizError(f"{path.name}: not YAML: {error}") from error
    if not isinstance(entries, list) or len(entries) not in ITEMS_PER_PAGE:
        low, high = ITEMS_PER_PAGE[0], ITEMS_PER_PAGE[-1]
        raise QuizError(f"{path.name}: expected a list of {low} to {high} questions")
    return tuple(_read_item(page, place, entry) for place, entry in enumerate(entries, start=1))


def load_all(folder: Path = CONCEPTS) -> dict[str, tuple[Item, ...]]:
    """Read the questions of all pages, and refuse an id that is there twice."""
    pages = {page: load_page(page, folder) for page in list_pages(folder)}
    seen: dict[str, str] = {}
    for page, items in pages.items():
        for item in items:
            if item.id in seen:
                raise QuizError(f"{page}.yml, {item.id}: this id is taken in {seen[item.id]}.yml")
            seen[item.id] = page
    return pages


def list_pages(folder: Path = CONCEPTS) -> list[str]:
    """Name the pages that have questions."""
    return sorted(path.stem for path in folder.glob("*.yml"))


def _read_item(page: str, place: int, entry: Any) -> Item:
    where = f"{page}.yml, question {place}"
    fields = check_fields(
        where,
        entry,
        required={"id": str, "section": str, "question": str, "choices": list},
        optional={"objective": str, "check": str},
        error=QuizError,
    )
    if not ITEM_ID.fullmatch(fields["id"]):
        raise QuizError(
            f"{where}: id: expected letters and digits such as 2a, got {fields['id']!r}"
        )
    where = f"{page}.yml, {fields['id']}"
    if len(fields["choices"]) not in CHOICES:
        raise QuizError(f"{where}: expected 3 or 4 choices, got {len(fields['choices'])}")
    choices = tuple(
        _read_choice(f"{where}, choice {number}", choice)
        for number, choice in enumerate(fields["choices"], start=1)
    )
    rights = sum(choice.right for choice in choices)
    if rights != 1:
        raise QuizError(f"{where}: expected one choice with right: true, got {rights}")
    for name in ("text", "feedback"):
        if len({getattr(choice, name) for choice in choices}) < len(choices):
            raise QuizError(f"{where}: two choices have the same {name}")
    return Item(
        page=page,
        id=fields["id"],
        section=fields["section"],
        question=fields["question"].strip(),
        choices=choices,
        objective=fields.get("objective"),
        check=fields.get("check"),
    )


def _read_choice(where: str, entry: Any) -> Choice:
    texts = {"text": str, "feedback": str}
    fields = check_fields(where, entry, texts, {"right": bool}, QuizError)
    feedback = fields["feedback"].strip()
    if len(feedback) < MIN_FEEDBACK:
        raise QuizError(
            f"{where}: feedback: expected at least {MIN_FEEDBACK} characters that explain, "
            f"got {feedback!r}"
        )
    return Choice(fields["text"].strip(), feedback, fields.get("right", False))
