"""Write what the book says of its own length: the two paths, and the formula behind all minutes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from content import page_minutes
from content.difficulty import LEVELS
from content.path import add_minutes, get_minimal_minutes, get_strong_minutes, say_hours

if TYPE_CHECKING:
    from collections.abc import Sequence

    from content.path import Leg


def make_path_tables(path: Sequence[Leg], note: str) -> str:
    """Return the part of a page that tells the paths and the formula."""
    required = sum(len(leg.required) for leg in path)
    lab = [leg for leg in path if not leg.chapter.is_extension]
    challenges = sum(len(leg.optional) for leg in lab)
    others = [leg.chapter.name for leg in lab if not leg.is_required]
    minimal, strong = get_minimal_minutes(path), get_strong_minutes(path)
    return f"""<!-- {note} -->

| Path | Time | What you do |
|---|---|---|
| Minimal | {say_hours(minimal)} | Start here, all steps, and the {required} required exercises |
| Strong | {say_hours(strong)} | the same, {", ".join(others)}, and the {challenges} challenges |

The minutes on all pages come from one formula:

| What | Time |
|---|---|
{make_formula()}
"""


def make_steps(path: Sequence[Leg]) -> str:
    """Return the path as a table of Markdown, with links from the pages of the book."""
    rows = [
        f"| [{leg.chapter.heading}]({leg.chapter.stem}.md) | {leg.minutes.reading} "
        f"| {leg.minutes.doing} | {add_minutes(leg.required)} | {add_minutes(leg.optional)} |"
        for leg in path
    ]
    head = "| Page | Reading, min | Doing, min | Required exercises, min | Challenges, min |"
    return "\n".join([head, "|---|---:|---:|---:|---:|", *rows]) + "\n"


def make_formula() -> str:
    """Return the rows of the formula."""
    bounds = [str(one.largest) for one in LEVELS[:-1]]
    sizes = [f"size up to {bounds[0]}", f"up to {bounds[1]}", "above that"]
    levels = "; ".join(
        f"{one.mark} {one.name} ({size}) {one.minutes} minutes"
        for one, size in zip(LEVELS, sizes, strict=True)
    )
    rows = {
        "Reading": f"{page_minutes.WORDS_PER_MINUTE} words a minute, "
        f"{page_minutes.CELL_SECONDS} seconds for a code cell with its output, "
        f"{page_minutes.FIGURE_SECONDS} seconds for a figure",
        "Doing": f"{page_minutes.RUN_SECONDS} seconds to run a cell, "
        f"{page_minutes.PREDICTION_MINUTES} minute for a prediction or a question, "
        f"{page_minutes.TASK_MINUTES} minutes for a *Try it*",
        "Exercise": f"{levels}; its statement and the twin before it are included",
    }
    return "\n".join(f"| {name} | {text} |" for name, text in rows.items())
