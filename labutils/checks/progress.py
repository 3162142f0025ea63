"""Keep what a learner has done in one small file beside the notebook.

No account, no server: ``labutils-progress.json`` in the working folder. It is written whole or not
at all, and a file that is none of ours is set aside, never overwritten.
"""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from labutils.checks.progress_rules import (
    FILE_NAME,
    MAX_CHARACTERS,
    SCHEMA,
    VERSION,
    find_fault,
)

if TYPE_CHECKING:
    from collections.abc import Mapping


@dataclass
class Record:
    """What is kept of one exercise: counts of what was recognized or seen, by its short name."""

    passed: bool = False
    attempts: int = 0
    hints: int = 0
    last_property: str | None = None
    mistakes: dict[str, int] = field(default_factory=dict)
    relations: dict[str, int] = field(default_factory=dict)
    probes: dict[str, int] = field(default_factory=dict)


@dataclass
class Prediction:
    """What was said to a question of a page before its answer; None where it was only shown."""

    said: str | None
    right: bool


@dataclass
class Progress:
    """All records, and what went wrong while reading them."""

    records: dict[str, Record] = field(default_factory=dict)
    notice: str = ""
    predictions: dict[str, Prediction] = field(default_factory=dict)

    def get(self, name: str) -> Record:
        """Return the record of an exercise, empty where there is none yet."""
        return self.records.setdefault(name, Record())


def load_progress(folder: Path | None = None) -> Progress:
    """Read the file of a folder (the working folder); set it aside where it is damaged."""
    path = (folder or Path.cwd()) / FILE_NAME
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return Progress()
    except OSError as error:
        return Progress(notice=_set_aside(path, f"it cannot be opened ({type(error).__name__})"))
    except UnicodeDecodeError:
        return Progress(notice=_set_aside(path, "it is no JSON"))
    try:
        return parse_progress(text)
    except ValueError as error:
        return Progress(notice=_set_aside(path, str(error)))


def parse_progress(text: str) -> Progress:
    """Read a file by its rules.

    Raises
    ------
    ValueError
        If it breaks one; the message says which.
    """
    if len(text) > MAX_CHARACTERS:
        raise ValueError("it is far too long")
    try:
        content = json.loads(text, parse_constant=_refuse)
    except (ValueError, RecursionError):
        raise ValueError("it is no JSON") from None
    if fault := find_fault(content, SCHEMA):
        raise ValueError(fault)
    return Progress(
        {name: _read_record(item) for name, item in content["exercises"].items()},
        predictions={
            name: Prediction(item["said"], item["right"])
            for name, item in content.get("predictions", {}).items()
        },
    )


def _refuse(name: str) -> NoReturn:
    """Refuse NaN and infinity, which are no JSON."""
    raise ValueError(name)


def _read_record(item: dict[str, Any]) -> Record:
    counts = {
        kind: {name: int(count) for name, count in item.get(kind, {}).items()}
        for kind in ("mistakes", "relations", "probes")
    }
    attempts, hints = int(item["attempts"]), int(item["hints"])
    return Record(item["passed"], attempts, hints, item["last_property"], **counts)


def _set_aside(path: Path, reason: str) -> str:
    """Give the file another name; return what there is to say of it."""
    number = 1
    while (aside := path.with_name(f"{path.stem}-damaged-{number}.json")).exists():
        number += 1
    said = f"{path.name} is no progress file: {reason}."
    try:
        path.rename(aside)
    except OSError:
        return f"{said} It cannot be moved; progress starts anew."
    return f"{said} It is kept as {aside.name}; progress starts anew."


def _write_all(items: Mapping[str, Record | Prediction]) -> dict[str, Any]:
    return {name: vars(item) for name, item in sorted(items.items())}


def save_progress(progress: Progress, folder: Path | None = None) -> str:
    """Write the file in one step; return "" or, where it cannot be written, a notice."""
    path = (folder or Path.cwd()) / FILE_NAME
    content = {"version": VERSION, "exercises": _write_all(progress.records)}
    if progress.predictions:
        content["predictions"] = _write_all(progress.predictions)
    temporary = ""
    try:
        with tempfile.NamedTemporaryFile(
            "w", encoding="utf-8", dir=path.parent, prefix=FILE_NAME, delete=False
        ) as file:
            temporary = file.name
            json.dump(content, file, indent=1)
            file.write("\n")
        os.replace(temporary, path)  # noqa: PTH105 - takes a plain name, like the one just made
    except OSError as error:
        with contextlib.suppress(OSError):
            os.unlink(temporary)  # noqa: PTH108 - likewise
        return f"Progress is not kept: {path.name} cannot be written ({type(error).__name__})."
    return ""
