"""The answers of strangers in ``tests/solutions/answers``: what `test_answers.py` there tells."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parents[1] / "solutions" / "answers"

#: Folder and exercise of every file; a new exercise has none yet.
ANSWERED = sorted((path.parent.name, path.stem) for path in FOLDER.glob("*/*.py"))
RIGHT = [pair for pair in ANSWERED if pair[0] != "wrong"]
WRONG = [name for folder, name in ANSWERED if folder == "wrong"]


def load_answers(folder: str, name: str) -> Any:
    return import_module(f"tests.solutions.answers.{folder}.{name}")
