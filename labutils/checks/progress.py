"""Keep what a learner has done in one small file beside the notebook.

No account, no server: ``labutils-progress.json`` in the working folder. It is written whole or not
at all, and a file that cannot be read is set aside, never overwritten.
"""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

FILE_NAME = "labutils-progress.json"
VERSION = 1

#: Hints per exercise; `hint` counts up to here.
MAX_HINTS = 3


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
class Progress:
    """All records, and what went wrong while reading them."""

    records: dict[str, Record] = field(default_factory=dict)
    notice: str = ""

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
    except (OSError, UnicodeDecodeError) as error:
        return Progress(notice=_set_aside(path, error))
    try:
        content = json.loads(text)
        return Progress({name: _read_record(item) for name, item in content["exercises"].items()})
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        return Progress(notice=_set_aside(path, error))


def _read_record(item: dict[str, Any]) -> Record:
    record = Record(
        passed=item["passed"],
        attempts=item["attempts"],
        hints=item["hints"],
        last_property=item["last_property"],
        mistakes=dict(item["mistakes"]),
        # Files of the first release have neither.
        relations=dict(item.get("relations", {})),
        probes=dict(item.get("probes", {})),
    )
    counts = [*record.mistakes.values(), *record.relations.values(), *record.probes.values()]
    kinds = (
        all(isinstance(count, int) for count in counts),
        isinstance(record.passed, bool),
        isinstance(record.attempts, int),
        isinstance(record.hints, int) and 0 <= record.hints <= MAX_HINTS,
        isinstance(record.last_property, str | None),
    )
    if not all(kinds):
        raise ValueError(f"a record holds something else than a record: {item}")
    return record


def _set_aside(path: Path, error: Exception) -> str:
    number = 1
    while (aside := path.with_name(f"{path.stem}-damaged-{number}.json")).exists():
        number += 1
    try:
        path.rename(aside)
    except OSError:
        return f"{path.name} cannot be read ({type(error).__name__}); progress starts anew."
    return f"{path.name} could not be read; it is kept as {aside.name}, progress starts anew."


def save_progress(progress: Progress, folder: Path | None = None) -> str:
    """Write the file in one step; return "" or, where it cannot be written, a notice."""
    path = (folder or Path.cwd()) / FILE_NAME
    content = {
        "version": VERSION,
        "exercises": {name: vars(record) for name, record in sorted(progress.records.items())},
    }
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
