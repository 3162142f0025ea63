"""The predictions: read the files in ``exercises/predictions`` and refuse what is wrong.

A box of the class ``predict`` on a page asks; its choices are a numbered list in the box. What is
right, what is said to each answer, and where the answer ends on the page stands here: one file per
page, named like it, with an item for each box. Texts are MyST markdown of one paragraph.

.. code-block:: yaml

    - id: stale               # the box has the name predict-stale; unique in the book
      until: mj_forward c     # optional: how the first part left open begins, see below
      objective: 1c           # optional: of the same page, which it practices
      right: 2                # the right choice of the box, counted from 1
      said:                   # one for each choice of the box
        - The positions are computed when ...
        - Nobody has told ...
        - Shadows are drawn ...
    - id: middle              # a box without choices asks for a number
      number: 2.5
      unit: px                # optional
      tolerance: 0.01         # how far off is still right
      said:
        right: The numbers ...
        low: ...
        high: ...

Outputs of cells and texts are covered from the box to the next heading or box, so that nobody sees
the answer first. ``until`` moves the end: it is how the first part that stays open begins, as the
page shows it, without marks.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from content import ROOT
from content.fields import check_fields

PREDICTIONS = ROOT / "exercises" / "predictions"

MIN_SAID = 40  # characters; "wrong" explains nothing
CHOICES = range(2, 5)
ITEM_ID = re.compile(r"[a-z][a-z0-9-]{1,30}")
SIDES = {"right": str, "low": str, "high": str}  # of a number


class PredictionError(ValueError):
    """A file of predictions is wrong; the message says where and what was expected."""


@dataclass(frozen=True)
class Number:
    """What a reader has to type."""

    value: float
    unit: str
    tolerance: float


@dataclass(frozen=True)
class Prediction:
    """The answer to one box: a choice, counted from 1, or a number."""

    page: str
    id: str
    said: dict[str, str]  # by the choice, "1" and so on, or by the side of the number
    right: int | None
    number: Number | None
    until: str | None
    objective: str | None = None

    @property
    def name(self) -> str:
        """The name of the box on the page."""
        return f"predict-{self.id}"


def load_page(page: str, folder: Path = PREDICTIONS) -> dict[str, Prediction]:
    """Read the predictions of one page, by their ids; a page without a file has none.

    Raises
    ------
    PredictionError
        If something in the file is missing, unknown or against the rules.
    """
    path = folder / f"{page}.yml"
    if not path.is_file():
        return {}
    try:
        entries = yaml.safe_load(path.read_text(encoding="utf-8"))
    except yaml.YAMLError as error:
        raise PredictionError(f"{path.name}: not YAML: {error}") from error
    if not isinstance(entries, list) or not entries:
        raise PredictionError(f"{path.name}: expected a list of predictions")
    items = [_read_item(page, place, entry) for place, entry in enumerate(entries, start=1)]
    return _by_id(items)


def load_all(folder: Path = PREDICTIONS) -> dict[str, dict[str, Prediction]]:
    """Read the predictions of all pages, and refuse an id that is there twice."""
    pages = {path.stem: load_page(path.stem, folder) for path in sorted(folder.glob("*.yml"))}
    _by_id([item for items in pages.values() for item in items.values()])
    return pages


def _by_id(items: list[Prediction]) -> dict[str, Prediction]:
    found: dict[str, Prediction] = {}
    for item in items:
        if item.id in found:
            raise PredictionError(
                f"{item.page}.yml, {item.id}: this id is taken in {found[item.id].page}.yml"
            )
        found[item.id] = item
    return found


def _read_item(page: str, place: int, entry: Any) -> Prediction:
    where = f"{page}.yml, prediction {place}"
    is_number = isinstance(entry, dict) and "number" in entry
    if is_number:
        entry = {k: float(v) if type(v) is int else v for k, v in entry.items()}
    fields = check_fields(
        where,
        entry,
        required=(
            {"id": str, "number": float, "tolerance": float, "said": dict}
            if is_number
            else {"id": str, "right": int, "said": list}
        ),
        optional={"until": str, "objective": str} | ({"unit": str} if is_number else {}),
        error=PredictionError,
    )
    if not ITEM_ID.fullmatch(fields["id"]):
        raise PredictionError(
            f"{where}: id: expected small letters and dashes such as stale, got {fields['id']!r}"
        )
    where = f"{page}.yml, {fields['id']}"
    said, right, number = fields["said"], None, None
    if is_number:
        check_fields(f"{where}: said", said, SIDES, {}, PredictionError)
        number = Number(fields["number"], fields.get("unit", ""), fields["tolerance"])
        if number.tolerance <= 0:
            raise PredictionError(f"{where}: tolerance: expected above 0, got {number.tolerance}")
    else:
        said, right = _read_choices(where, said, fields["right"])
    for answer, text in said.items():
        if len(text.strip()) < MIN_SAID:
            raise PredictionError(
                f"{where}, said to {answer}: expected at least {MIN_SAID} characters that "
                f"explain, got {text!r}"
            )
    if len(set(said.values())) < len(said):
        raise PredictionError(f"{where}: two answers are told the same")
    return Prediction(
        page, fields["id"], said, right, number, fields.get("until"), fields.get("objective")
    )


def _read_choices(where: str, said: list[Any], right: int) -> tuple[dict[str, str], int]:
    if len(said) not in CHOICES:
        raise PredictionError(f"{where}: said: expected 2 to 4 texts, got {len(said)}")
    if not all(isinstance(text, str) for text in said):
        raise PredictionError(f"{where}: said: expected texts; write them in quotes")
    if not 1 <= right <= len(said):
        raise PredictionError(f"{where}: right: expected 1 to {len(said)}, got {right}")
    return {str(place): text for place, text in enumerate(said, start=1)}, right
