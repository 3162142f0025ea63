"""Write the files of a new exercise: what ``make new-exercise`` runs.

An exercise gets its card, its heading and statement on the exercise page, and a file for right
answers that are written differently. Places to fill are marked; ``make unfilled`` names them.

Usage: ``python -m tools.scaffold.exercise --name scale_matrix --chapter two-eyes
[--kind challenge] [--args "K: np.ndarray, factor: float"]``.
"""

from __future__ import annotations

import argparse
import ast
import inspect
import keyword
import re
import sys
from typing import TYPE_CHECKING

import labutils
from content.chapters import READING, Chapter, ChapterError, get_chapter
from content.objectives import read_book
from solutions import load_exercises
from tools import ROOT
from tools.derive.exercise_cards import get_label
from tools.scaffold.plan import Plan, ScaffoldError, fill_template

if TYPE_CHECKING:
    from pathlib import Path

LAB, CHALLENGE = KINDS = ("lab", "challenge")
NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
ARGS = "values: np.ndarray"


def plan_exercise(
    name: str, chapter_id: str, kind: str = CHALLENGE, args: str = "", root: Path = ROOT
) -> Plan:
    """Return the files of an exercise, none of them written yet.

    Raises
    ------
    ScaffoldError
        If the name is no name or is taken, the chapter is unknown or has no exercises, or a lab
        exercise asks for a function that the library does not have.
    """
    if not NAME.fullmatch(name) or keyword.iskeyword(name):
        raise ScaffoldError(f"NAME: expected a function such as find_edges, got {name!r}")
    if kind not in KINDS:
        raise ScaffoldError(f"KIND: expected {' or '.join(KINDS)}, got {kind!r}")
    chapter = _get_chapter(chapter_id, root)
    if name in load_exercises():
        raise ScaffoldError(f"NAME: there is an exercise {name} already; choose another name")
    signature = _get_signature(name, kind, args)
    objective, section = _choose_objective(chapter, root)
    values = {
        "name": name,
        "title_of_chapter": chapter.name,
        "chapter": chapter.id,
        "place": str(_find_place(chapter)),
        "points": "0" if kind == CHALLENGE or chapter.is_extension else "5",
        "section": section,
        "objective": objective,
        "signature": signature,
        "names": ", ".join(_list_names(signature)),
        "parameters": "\n".join(
            f"    {one} : FILL: dtype, shape\n        FILL: what it holds, with its unit."
            for one in _list_names(signature)
        ),
        "seed": str(sum(name.encode())),
        "label": get_label(name),
    }
    plan = Plan(root)
    plan.add(f"solutions/{name}.py", fill_template(f"card_{kind}.py", **values))
    plan.add(f"tests/solutions/variants/{name}.py", fill_template("variants.py", **values))
    plan.append(f"{chapter.exercises}.md", "\n" + fill_template("statement.md", **values))
    return plan


def _get_chapter(chapter_id: str, root: Path) -> Chapter:
    try:
        chapter = get_chapter(chapter_id, root)
    except ChapterError as error:
        raise ScaffoldError(str(error)) from error
    if chapter.kind == READING:
        raise ScaffoldError(f"CHAPTER: {chapter_id} is a page for reading, without exercises")
    return chapter


def _get_signature(name: str, kind: str, args: str) -> str:
    """Return the arguments as they stand in a definition."""
    function = getattr(labutils, name, None)
    if kind == CHALLENGE:
        if function is not None:
            raise ScaffoldError(f"NAME: labutils answers {name} already; use KIND=lab")
        try:
            ast.parse(f"def f({args or ARGS}): pass")
        except SyntaxError as error:
            raise ScaffoldError(f"ARGS: expected such as {ARGS!r}, got {args!r}") from error
        return args or ARGS
    if not inspect.isfunction(function):
        raise ScaffoldError(
            f"NAME: labutils has no function {name}; write it first, or use KIND=challenge"
        )
    return ", ".join(f"{one}: Any" for one in inspect.signature(function).parameters)


def _list_names(signature: str) -> list[str]:
    function = ast.parse(f"def f({signature}): pass").body[0]
    assert isinstance(function, ast.FunctionDef)  # noqa: S101 - written one line above
    return [argument.arg for argument in function.args.args]


def _choose_objective(chapter: Chapter, root: Path) -> tuple[str, str]:
    """Return an objective that no exercise practices yet, else the first, and its section."""
    practiced = {one.name: one.objectives for one in load_exercises().values()}
    book = read_book(practiced, root)
    own = [name for name in book.objectives if name[:-1] == chapter.prefix]
    own = [name for name in own if name in book.sections]
    if not own:
        raise ScaffoldError(
            f"CHAPTER: {chapter.id} has no objective with a section in exercises/objectives.yml"
        )
    name = next((name for name in own if not book.get_exercises(name)), own[0])
    return name, book.sections[name]


def _find_place(chapter: Chapter) -> int:
    places = [one.place for one in load_exercises().values() if one.chapter == chapter.id]
    return max(places, default=0) + 1


def main(arguments: list[str] | None = None) -> int:
    """Write the files and name them; return a shell's exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--name", default="", help="the function that learners write")
    parser.add_argument("--chapter", default="", help="id of the chapter")
    parser.add_argument("--kind", default="", help=f"{CHALLENGE} (the default) or {LAB}")
    parser.add_argument("--args", default="", help=f'arguments of a challenge, such as "{ARGS}"')
    options = parser.parse_args(arguments)
    try:
        written = plan_exercise(
            options.name, options.chapter, options.kind or CHALLENGE, options.args
        ).write()
    except ScaffoldError as error:
        print(f"new-exercise: {error}", file=sys.stderr)
        return 1
    print("new-exercise: wrote", *written, sep="\n  ")
    print("next: fill what `make unfilled` names, then run `make exercises`")
    return 0


if __name__ == "__main__":
    sys.exit(main())
