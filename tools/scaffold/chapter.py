"""Write the files of a new chapter: what ``make new-chapter`` runs.

A chapter gets its row in the registry, its place in the contents, its page with all sections, its
exercise page, its questions, its prediction, its teaching notes, and a section for each objective.
Places to fill are marked; ``make unfilled`` names them.

Usage: ``python -m tools.scaffold.chapter --id two-eyes [--title TITLE] [--kind extension]``.
"""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING

from content.chapters import EXTENSION, ID, OBJECTIVES, REQUIRED, Chapter, list_taught
from content.chapters import load_chapters as load_rows
from content.toc import list_entries, read_toc
from tools import ROOT
from tools.scaffold.plan import Plan, ScaffoldError, fill_template

if TYPE_CHECKING:
    from pathlib import Path

REGISTRY, TOC, SECTIONS = "content/chapters.yml", "_toc.yml", "exercises/objectives.yml"
TITLE = "FILL: the question of the chapter, the same on its page and in content/chapters.yml"
PART = "Beyond the lab"
LETTERS = "abcde"


def plan_chapter(id_: str, title: str = "", kind: str = EXTENSION, root: Path = ROOT) -> Plan:
    """Return the files of a chapter, none of them written yet.

    Raises
    ------
    ScaffoldError
        If the id is no name for a chapter or is taken, or the kind is none that has exercises.
    """
    if not ID.fullmatch(id_):
        raise ScaffoldError(f"ID: expected a name in small letters such as two-eyes, got {id_!r}")
    if kind not in OBJECTIVES:
        raise ScaffoldError(f"KIND: expected {' or '.join(OBJECTIVES)}, got {kind!r}")
    if '"' in title or "\n" in title:
        raise ScaffoldError("TITLE: expected one line without double quotation marks")
    chapters = load_rows(root)
    if id_ in {one.id for one in chapters}:
        raise ScaffoldError(f"ID: there is a chapter {id_} already; choose another name")
    stem = id_.replace("-", "_")
    chapter = Chapter(
        id=id_,
        kind=kind,
        page=f"book/{stem}",
        exercises=f"exercises/{stem}",
        name=id_.replace("-", " ").capitalize(),
        title=title or TITLE,
        prefix=str(max(int(one.prefix) for one in chapters if one.prefix) + 1),
    )
    plan = Plan(root)
    _add_files(plan, chapter)
    _add_row(plan, chapter, chapters)
    _add_to_contents(plan, chapter, root)
    return plan


def _add_files(plan: Plan, chapter: Chapter) -> None:
    """Plan the files that are the chapter's own."""
    names = [f"{chapter.prefix}{letter}" for letter in LETTERS[: OBJECTIVES[chapter.kind][0]]]
    ends = [";"] * (len(names) - 1) + ["."]
    values = {
        "id": chapter.id,
        "stem": chapter.stem,
        "name": chapter.name,
        "lower": chapter.lower,
        "heading": chapter.heading,
        "noun": chapter.noun,
        "objectives": "\n".join(
            f"- **{name}.** FILL: what the reader can do, beginning with a verb one can test{end}"
            for name, end in zip(names, ends, strict=True)
        ),
        "recap": "\n".join(
            f"- **{name}.** FILL: what the reader did, in the past tense." for name in names
        ),
    }
    plan.add(f"{chapter.page}.md", fill_template("page.md", **values))
    plan.add(f"{chapter.exercises}.md", fill_template("exercises.md", **values))
    plan.add(f"solutions/notes/{chapter.id}.md", fill_template("notes.md", **values))
    questions = [
        fill_template("question.yml", name=name, **_places(n), id=chapter.id)
        for n, name in enumerate(names)
    ]
    head = f"# Concept questions of {chapter.page}.md; content/quiz_items.py explains the fields.\n"
    plan.add(f"exercises/concepts/{chapter.stem}.yml", head + "".join(questions))
    head = f"# Predictions of {chapter.page}.md; content/predictions.py explains the fields.\n"
    prediction = fill_template("prediction.yml", id=chapter.id)
    plan.add(f"exercises/predictions/{chapter.stem}.yml", head + prediction)
    plan.append(SECTIONS, "".join(f"  {name}: {chapter.id}-first\n" for name in names))


def _places(number: int) -> dict[str, str]:
    """Put the right choice of every question at another place."""
    right = "\n      right: true"
    return {f"right{place}": right if place == number % 3 else "" for place in range(3)}


def _add_row(plan: Plan, chapter: Chapter, chapters: tuple[Chapter, ...]) -> None:
    """Plan the row of the registry, after the last of its kind."""
    row = fill_template(
        "row.yml",
        id=chapter.id,
        kind=chapter.kind,
        page=chapter.page,
        exercises=chapter.exercises,
        name=chapter.name,
        title=json.dumps(chapter.title, ensure_ascii=False),
        prefix=chapter.prefix,
    )
    extensions = [one.id for one in chapters if one.kind == EXTENSION]
    if chapter.kind == EXTENSION or not extensions:
        plan.append(REGISTRY, f"\n{row}")
    else:
        plan.insert(REGISTRY, f"{row}\n", before=f"- id: {extensions[0]}")


def _add_to_contents(plan: Plan, chapter: Chapter, root: Path) -> None:
    """Plan the lines of the contents: the exercises stand below their chapter."""
    taught = list_taught(root)
    before = [one for one in taught if one.kind == REQUIRED or chapter.kind == EXTENSION][-1]
    entries = list_entries(read_toc(root))
    lines = (
        f"  - file: {chapter.page}\n    sections:\n    - file: {chapter.exercises}\n"
        f"      title: Exercises of {chapter.lower}\n"
    )
    if before.kind == chapter.kind:
        plan.insert(TOC, lines, after=f"      title: Exercises of {before.lower}")
    else:  # the first extension opens a part of its own, after the whole part of the lab
        caption = next(entry.caption for entry in entries if entry.page == before.page)
        last = [entry.page for entry in entries if entry.caption == caption][-1]
        part = f"- caption: {PART}\n  chapters:\n{lines}"
        plan.insert(TOC, part, after=f"  - file: {last}")


def main(arguments: list[str] | None = None) -> int:
    """Write the files and name them; return a shell's exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--id", default="", help="name of the chapter, such as two-eyes")
    parser.add_argument("--title", default="", help="the question that it answers")
    parser.add_argument("--kind", default="", help=f"{EXTENSION} (the default) or {REQUIRED}")
    options = parser.parse_args(arguments)
    try:
        written = plan_chapter(options.id, options.title, options.kind or EXTENSION).write()
    except ScaffoldError as error:
        print(f"new-chapter: {error}", file=sys.stderr)
        return 1
    print("new-chapter: wrote", *written, sep="\n  ")
    print(
        f"next: make new-exercise NAME=... CHAPTER={options.id}, then fill what `make unfilled` "
        "names, then `make exercises`"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
