"""Write the pages that only the instructor edition has: one per chapter, from the cards.

Nothing of it is kept in the repository: reference and mistakes come from ``solutions/``,
what is said of them is measured anew, the notes are those of ``solutions/notes/``. The
table of contents and the configuration of the edition are made from the student's.

Run by ``make book EDITION=instructor``.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

from content.chapters import list_taught
from content.page_minutes import Minutes, measure_page
from content.toc import read_toc
from labutils.checks.explain import FAMILIES
from labutils.checks.kinds import KINDS
from solutions import QUALITY_POINTS, load_exercises
from solutions._open_answers import load_marked_tasks
from tools import ROOT
from tools.derive.contract import make_tables as make_contract_tables
from tools.derive.difficulty import rate_exercise
from tools.derive.path_tables import make_formula
from tools.editions.card_code import is_answered_by_library
from tools.editions.exercise_section import make_exercise
from tools.editions.mistakes import SEEDS
from tools.editions.objectives_page import make_objectives_page
from tools.editions.open_task_section import draw_figures, make_section

if TYPE_CHECKING:
    from collections.abc import Iterable

    from content.chapters import Chapter
    from solutions import Exercise

PAGES = Path("solutions", "pages")
NOTES = Path("solutions", "notes")
EDITION = Path("_build", "instructor")
MADE_BY = "<!-- Written by tools/editions/instructor_pages.py. -->"
TITLE = "Camera Image Processing for Robotics, instructor edition"
BANNER = "Instructor edition: it holds the solutions. Do not publish it."


def write_pages(root: Path = ROOT) -> str:
    """Write pages, contents and configuration; return what was done, in words."""
    toc = read_toc(root)
    files = make_pages(root)
    for old in sorted((root / PAGES).glob("*.md")):
        if PAGES / old.name not in files:
            old.unlink()
    added = [path.with_suffix("").as_posix() for path in files]
    toc["parts"].append({"caption": "Instructor", "chapters": [{"file": name} for name in added]})
    files[EDITION / "_toc.yml"] = yaml.safe_dump(toc, sort_keys=False)
    config = make_config(yaml.safe_load((root / "_config.yml").read_text(encoding="utf-8")))
    files[EDITION / "_config.yml"] = yaml.safe_dump(config, sort_keys=False)
    draw_figures(root / PAGES, {one.stem: one for one in list_taught(root)})
    written = 0
    for path, text in files.items():
        target = root / path
        # an unchanged file keeps its time, so that Sphinx does not read it again
        if not target.is_file() or target.read_text(encoding="utf-8") != text:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8", newline="\n")
            written += path.suffix == ".md"
    return f"{len(added)}, {written} of them new or changed"


def make_config(config: dict[str, Any]) -> dict[str, Any]:
    """Return the configuration of the edition: the student's, the pages let in, a banner."""
    config["title"] = TITLE
    kept = [name for name in config["exclude_patterns"] if name != "solutions"]
    hidden = [f"solutions/{name}" for name in ("notes", "_generated")]
    config["exclude_patterns"] = [*kept, *hidden]
    config["html"]["use_edit_page_button"] = False  # the added pages are in no repository
    sphinx = config["sphinx"]
    # hooks are looked for beside the configuration
    back = "/".join([".."] * len(EDITION.parts))
    sphinx["local_extensions"] = {
        name: f"{back}/{folder}" for name, folder in sphinx["local_extensions"].items()
    }
    sphinx["config"]["html_theme_options"]["announcement"] = BANNER
    return config


def make_pages(root: Path) -> dict[Path, str]:
    """Return the added pages: the overview first, then one per chapter."""
    chapters: dict[Chapter, list[Exercise]] = {one: [] for one in list_taught(root)}
    for exercise in load_exercises().values():
        chapters[exercise.home].append(exercise)
    minutes = {one.id: measure_chapter(root, one, exercises) for one, exercises in chapters.items()}
    pages = {PAGES / "index.md": make_overview(chapters, minutes)}
    for chapter, exercises in chapters.items():
        pages[PAGES / f"{chapter.id}.md"] = make_chapter(
            chapter, exercises, minutes[chapter.id], read_notes(root, chapter)
        )
    pages[PAGES / "objectives.md"] = make_objectives_page(MADE_BY)
    pages[PAGES / "checks.md"] = make_checks(root)
    pages[PAGES / "contract.md"] = make_contract_page()
    return pages


def measure_chapter(root: Path, chapter: Chapter, exercises: Iterable[Exercise]) -> Minutes:
    """Say how long a chapter takes with all of its exercises."""
    practice = sum(rate_exercise(one).minutes for one in exercises)
    return measure_page(chapter.page, root) + Minutes(doing=practice)


def make_checks(root: Path) -> str:
    """Return the page on how a check decides, with the families that each kind of answer has."""
    rows = [f"| {name} | {', '.join(kind.relations) or 'none'} |" for name, kind in KINDS.items()]
    families = [
        f"| {name} | {(family.__doc__ or '').splitlines()[0].removeprefix('Propose ')} |"
        for name, family in FAMILIES.items()
    ]
    text = (root / NOTES / "checks.md").read_text(encoding="utf-8").strip()
    return f"""(page-instructor-checks)=
# How does a check decide?

{MADE_BY}

{text}

## Which relations are there?

| Family | What it proposes |
|---|---|
{chr(10).join(families)}

| Kind of answer | Families |
|---|---|
{chr(10).join(rows)}
"""


def make_contract_page() -> str:
    """Return the page that ties every sentence of an exercise to what checks it."""
    return f"""(page-instructor-contract)=
# Which check keeps which sentence?

{MADE_BY}

A statement is a contract: the check tests all of it and nothing else. Every sentence of a
statement and of a starter's docstring has a row. It is kept by gates, visible cases or listed
mistakes, which are known to fail; or it is *given* (true of every case), or *told* (an
explanation). What a sentence leaves open may be answered either way.

{make_contract_tables(load_exercises())}"""


def read_notes(root: Path, chapter: Chapter) -> str:
    """Read the teaching notes of a chapter."""
    return (root / NOTES / f"{chapter.id}.md").read_text(encoding="utf-8").strip()


def make_overview(chapters: dict[Chapter, list[Exercise]], minutes: dict[str, Minutes]) -> str:
    """Return the page that stands before the chapters."""
    rows: list[str] = []
    extensions: list[str] = []
    for chapter, exercises in chapters.items():
        time = minutes[chapter.id]
        lab = [one for one in exercises if is_answered_by_library(one)]
        (extensions if chapter.is_extension else rows).append(
            f"| [{chapter.name}]({chapter.id}.md) | {time.reading} | {time.doing} "
            f"| {len(lab)} | {sum(one.points for one in lab)} | {len(exercises) - len(lab)} |"
        )
    required = {one: many for one, many in chapters.items() if not one.is_extension}
    total = sum((minutes[one.id] for one in required), Minutes())
    cards = [one for many in chapters.values() for one in many]
    mistakes = sum(len(one.misconceptions) for one in cards)
    pairs = sum(len(one.get_combinations()) for one in cards) - mistakes
    every = [one for many in required.values() for one in many]
    lab = [one for one in every if is_answered_by_library(one)]
    return f"""(page-instructor)=
# For instructors: what is behind the checks?

{MADE_BY}

These pages are in no student's copy. Each shows, for one step, how long it takes, what to ask and
to show, the solutions, the mistakes that the checks recognize, and the points.

| Step | Reading, min | Doing, min | Lab exercises | Points | Challenges |
|---|---:|---:|---:|---:|---:|
{chr(10).join(rows)}
| Sum | {total.reading} | {total.doing} | {len(lab)} | {sum(one.points for one in lab)} \
| {len(every) - len(lab)} |{"".join(f"{chr(10)}{row}" for row in extensions)}

{QUALITY_POINTS} points for code quality come on top of the lab's points. The minutes are counted
from the pages, a plan rather than a measurement: nobody has timed learners of this book yet.
*Doing* counts the exercises and challenges of the step too.

| What | Time |
|---|---|
{make_formula()}

The size of an exercise is the number of statements of its solution, checks of arguments left out,
plus the number of objectives that it practices. If your class is slower or faster, change the
constants in `content/page_minutes.py` and `content/difficulty.py`, and run `make exercises`.

## How were the checks tested?

The checks know {mistakes} mistakes and {pairs} pairs of two at once. Each is a function that is
run, so the tests can ask of every card what it promises:

- the reference passes the visible cases, and the hidden cases of 20 seeds;
- every mistake and every pair fails, and is named as itself;
- every mistake fails the hidden cases of 20 seeds as well;
- the untouched starter, constants, NaN and the arguments handed back earn nothing;
- an answer ten tolerances off fails, one a tenth of a tolerance off passes.

What the step pages say of a mistake is measured when the pages are built, on the visible cases and
on the hidden cases of {len(SEEDS)} seeds:

**seen by** names the first gate it fails, and the visible cases on which it is wrong;
**worst** tells how far it is off, on the case where that is most;
**closest** is the mistake that agrees with it most often, and the cases that part the two;
**keeps** is what somebody who makes this mistake only may expect to earn.

## What decides the grade?

The visible cases are on every learner's machine: they teach, and they can be copied. The hidden
cases are made from a seed that you choose when you grade, and are stored nowhere. These pages count
each hidden case of an exercise the same.
"""


def make_chapter(chapter: Chapter, exercises: list[Exercise], minutes: Minutes, notes: str) -> str:
    """Return the page of one chapter."""
    lab = [one for one in exercises if is_answered_by_library(one)]
    names = ", ".join(f"`{one.name}`" for one in exercises) or "none"
    body = "\n\n".join(make_exercise(one) for one in exercises)
    if marked := load_marked_tasks().get(chapter.stem):
        body += f"\n\n{make_section(chapter, marked)}"
    points = f"{sum(one.points for one in lab)} in the lab's rubric"
    if chapter.is_extension:
        points = "none: an extension of the lab"
    return f"""(page-instructor-{chapter.id})=
# {chapter.name} for instructors

{MADE_BY}

| | |
|---|---|
| Reading | about {minutes.reading} minutes |
| Doing | about {minutes.doing} minutes |
| Points | {points} |
| Exercises | {names} |

## Teaching notes

{notes}

{body}
"""
