"""Derive everything an exercise needs from its card in solutions/: what `make exercises` runs.

Writes the starters (signature and docstring, no body), the frozen tables a check reads, the marked
parts of the exercise pages and chapters, the rubric table of the book, the instructor's list of
hints, and the table of what keeps which sentence. With ``--check`` nothing is written: the script
fails where a file differs from what its card gives. It fails anyway where a sentence is kept by
nothing, or a check is asked for by no sentence.
"""

from __future__ import annotations

import argparse
import io
import json
import sys
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from content.chapters import list_required, list_taught
from labutils.checks.table import COMPLETIONS, WORDS, CheckTable
from labutils.checks.writing import encode, is_same_array, part_to_words
from solutions import QUALITY_POINTS, Exercise, load_exercises
from tools import ROOT
from tools.derive import completions
from tools.derive.contract import GapError, make_contract
from tools.derive.exercise_pages import (
    describe_points,
    fill_chapter,
    fill_page,
    make_link,
    select,
)
from tools.derive.starters import make_starter
from tools.scaffold.unfilled import find_unfilled
from tools.stable_zip import make_zip

TABLES = Path("labutils/checks/tables")
STARTERS = Path("exercises/_generated")
RUBRIC = Path("book/_generated/rubric.md")
HINTS = Path("solutions/_generated/hints.md")
CONTRACT = Path("solutions/_generated/contract.md")
NOTE = "Written by tools/derive/exercises.py from the cards in solutions/: run `make exercises`."


def main(arguments: list[str] | None = None) -> int:
    """Write the files, or compare them; return a shell's exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail if out of date")
    parser.add_argument("--root", type=Path, default=ROOT, help="folder to write to")
    options = parser.parse_args(arguments)
    if places := find_unfilled():
        print("exercises: fill these places first", *places, sep="\n  ", file=sys.stderr)
        return 1
    try:
        files = make_files(load_exercises())
    except GapError as error:
        print(f"exercises: {error}", file=sys.stderr)
        return 1
    stale = find_stale(files, options.root)
    if options.check:
        for path, reason in stale.items():
            print(f"exercises: {path.as_posix()} is {reason}; run `make exercises`")
        return 1 if stale else 0
    for path in stale:
        write(options.root / path, files.get(path))
    print(f"exercises: {len(files)} files, {len(stale)} of them written anew")
    return 0


def make_files(exercises: dict[str, Exercise]) -> dict[Path, bytes]:
    """Return every derived file with its content."""
    files = {}
    words = {}
    completed = {}
    for name, exercise in exercises.items():
        table = exercise.freeze()
        words[name], files[TABLES / f"{name}.npz"] = make_table(table, exercise.example)
        head = f'"""Starter of the exercise {name}.\n\n{NOTE}\n"""\n\n'
        files[STARTERS / f"{name}.py"] = (head + make_starter(exercise)).encode()
        if twin := exercise.completion:
            table = twin.freeze(exercise)
            own, files[TABLES / f"{twin.name}.npz"] = make_table(table, twin.example)
            completed[twin.name] = completions.add_words(own, table)
    files[TABLES / WORDS] = (json.dumps(words, indent=1) + "\n").encode()
    files[TABLES / COMPLETIONS] = (json.dumps(completed, indent=1) + "\n").encode()
    for chapter in list_taught():
        for page, fill in ((chapter.exercises, fill_page), (chapter.page, fill_chapter)):
            path = Path(page).with_suffix(".md")
            text = (ROOT / path).read_text(encoding="utf-8")
            files[path] = fill(text, exercises, chapter).encode()
    files[RUBRIC] = make_rubric(exercises).encode()
    files[HINTS] = make_hints(exercises).encode()
    files[CONTRACT] = make_contract(exercises, NOTE).encode()
    return files


def find_stale(files: dict[Path, bytes], root: Path) -> dict[Path, str]:
    """Return the files that are missing, different, or left over, each with the reason."""
    stale = {}
    for path, content in files.items():
        if not (root / path).is_file():
            stale[path] = "missing"
        elif not is_current((root / path).read_bytes(), content, path.suffix):
            stale[path] = "out of date"
    for folder in (TABLES, STARTERS):  # the other folders hold more than what is made here
        for found in sorted((root / folder).glob("*.*")):
            if found.is_file() and folder / found.name not in files:
                stale[folder / found.name] = "left over"
    return stale


def is_current(old: bytes, new: bytes, suffix: str) -> bool:
    """Compare two versions of a file: tables number by number, everything else byte by byte."""
    if old == new or suffix != ".npz":
        return old == new
    try:
        with np.load(io.BytesIO(old)) as before, np.load(io.BytesIO(new)) as after:
            return before.files == after.files and all(
                is_same_array(before[name], after[name]) for name in after.files
            )
    except (ValueError, OSError, zipfile.BadZipFile):
        return False  # a damaged table


def write(path: Path, content: bytes | None) -> None:
    """Write a file; None removes it."""
    if content is None:
        path.unlink()
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def make_table(table: CheckTable, example: str) -> tuple[dict[str, Any], bytes]:
    """Return the words and the arrays of one exercise."""
    arrays: dict[str, np.ndarray] = {}
    words = {
        "title": table.title,
        "chapter": table.chapter,
        "kind": table.kind,
        "points": table.points,
        "parameters": list(table.parameters),
        "section": table.section,
        "parts": [part_to_words(part) for part in table.parts],
        "hints": list(table.hints),
        "example": example,
        "misconceptions": table.misconceptions,
        "links": table.links,
        "matters": list(table.matters),
        "simpler": [
            {
                "name": one.name,
                "words": one.words,
                "of": list(one.of),
                "cases": [encode(case.args, arrays) for case in one.cases],
                "expected": [encode(outcome, arrays) for outcome in one.expected],
            }
            for one in table.simpler
        ],
        "cases": [
            {"label": case.label, "raises": case.raises, "args": encode(case.args, arrays)}
            for case in table.cases
        ],
        "expected": [encode(outcome, arrays) for outcome in table.expected],
        "wrong": [
            {"made": list(made), "answers": [encode(outcome, arrays) for outcome in outcomes]}
            for made, outcomes in table.wrong.items()
        ],
    }
    return words, pack(arrays)


def pack(arrays: dict[str, np.ndarray]) -> bytes:
    """Write an .npz whose bytes depend on its content only: little-endian numbers, no times."""
    return make_zip((f"{name}.npy", _to_npy(array)) for name, array in arrays.items())


def _to_npy(array: np.ndarray) -> bytes:
    content = io.BytesIO()
    little = array.astype(array.dtype.newbyteorder("<"))
    np.lib.format.write_array(content, little, version=(1, 0), allow_pickle=False)
    return content.getvalue()


def make_rubric(exercises: dict[str, Exercise]) -> str:
    """Return the rubric as a table; its points have to sum to 100."""
    rows = ["| Criterion | Points | What is asked | Exercises |", "|---|---:|---|---|"]
    total = QUALITY_POINTS
    for chapter in list_required():
        if not (criterion := chapter.criterion):
            continue
        chosen = [one for one in select(exercises, chapter) if one.points]
        points = sum(exercise.points for exercise in chosen)
        names = ", ".join(f"{make_link(exercise)} ({exercise.points})" for exercise in chosen)
        rows.append(f"| {criterion.name} | {points} | {criterion.asks} | {names} |")
        total += points
    rows.append(
        f"| Code quality | {QUALITY_POINTS} | Well-documented, modular functions | all of them |"
    )
    rows.append(f"| **Total** | **{total}** | | |")
    if total != 100:
        raise ValueError(f"rubric: expected 100 points, got {total}")
    return f"<!-- {NOTE} -->\n\n" + "\n".join(rows) + "\n"


def make_hints(exercises: dict[str, Exercise]) -> str:
    """Return the instructor's catalogue: mistakes, hints, tolerances with their reasons."""
    lines = ["# Mistakes the checks recognize", "", f"<!-- {NOTE} -->", ""]
    for exercise in exercises.values():
        pairs = len(exercise.get_combinations()) - len(exercise.misconceptions)
        lines += [
            f"## `{exercise.name}`: {exercise.title} ({describe_points(exercise)})",
            "",
            f"Tolerance: {exercise.tolerance_reason}.",
            "",
            "| Mistake | What the learner reads |",
            "|---|---|",
            *(f"| {one.name} | {one.text} |" for one in exercise.misconceptions),
            "",
            f"Recognized in pairs, too: {pairs} pairs."
            + (" Not told apart:" if exercise.absorbed else ""),
            "",
            *(f"- {one.first} and {one.second}: {one.reason}" for one in exercise.absorbed),
            *([""] if exercise.absorbed else []),
            "Hints a learner may ask for:",
            "",
            *(f"{number}. {text}" for number, text in enumerate(exercise.hints, 1)),
            "",
        ]
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    sys.exit(main())
