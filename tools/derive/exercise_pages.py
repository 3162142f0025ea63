"""Fill the parts of a page that follow from the cards: set-up, example, starter, check, points.

A marked part lies between two comments. Everything else on a page is written by hand. A page that
lacks a part, or has one that no card asks for, is refused.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from content.chapters import REQUIRED
from content.open_tasks import load_open_task
from content.page_minutes import fill_card
from tools.derive import completions, open_tasks
from tools.derive.exercise_cards import (
    get_label,
    make_card,
    make_chapter_part,
    make_facts,
    make_groups,
    split_exercises,
)
from tools.derive.starters import make_starter

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from content.chapters import Chapter
    from solutions import Exercise

PART = re.compile(r"<!-- begin (?P<name>[\w ]+) -->\n.*?<!-- end (?P=name) -->\n", re.DOTALL)
GROUP = re.compile(r"<!-- begin (group \w+) -->\n.*?<!-- end \1 -->\n\n", re.DOTALL)
HEADING = re.compile(r"^\((exercise-[a-z-]+)\)=\n### ", re.MULTILINE)

#: What stands above the exercises of every page: names to try a function with. The library comes
#: under one short name, so that no function that a learner writes hides what these cells call.
SET_UP = """\
Run your function before you check it: the next two cells make a picture `rgb` of the robot's head \
camera, its `depth` in meters, and the matrix `K` of that camera. Call your function below its \
definition, as the example of each exercise does, and look at the result with `show(...)`. A check \
looks at the function only.

```{code-cell} ipython3
# The tools of this page
import numpy as np
import labutils as lab
from labutils import check, hint, report, show
```

```{code-cell} ipython3
# The robot's scene, a picture of it with its depth, and the camera
model, data = lab.make_scene()
renderer = lab.make_renderer(model, 480, 640)
rgb, depth = lab.render_camera(model, data, renderer, "head_camera")
K, fov_y = lab.get_camera_intrinsics(model, "head_camera", 640, 480)
```
"""


def select(exercises: Mapping[str, Exercise], chapter: Chapter) -> list[Exercise]:
    """Return the exercises of a chapter."""
    return [one for one in exercises.values() if one.chapter == chapter.id]


def make_exercise(exercise: Exercise) -> str:
    """Write what follows the statement: facts, starter, check and the way to a hint."""
    return f"""\
{make_facts(exercise)}

```{{code-cell}} ipython3
:tags: [exercise]
{make_starter(exercise).strip()}
```

```{{code-cell}} ipython3
check("{exercise.name}", {exercise.name})
```

:::{{dropdown}} Stuck? Ask for a hint
Run `hint("{exercise.name}")` in a cell of its own. There are three, each more direct than the one \
before. They cost nothing, but `report()` counts them.
:::
"""


def make_example(exercise: Exercise) -> str:
    """Write the example call, which a notebook's reader copies below the function."""
    return f"```python\n{exercise.example}\n```\n"


def fill_page(text: str, exercises: Mapping[str, Exercise], chapter: Chapter) -> str:
    """Fill the marked parts of an exercise page."""
    chosen = _require(exercises, chapter)
    parts = {"card": make_card(chosen, chapter), "set up": SET_UP}
    groups = make_groups(chosen, chapter)
    for one in chosen:
        if one.name in groups:
            parts[f"group {one.name}"] = groups[one.name]
        if one.completion:
            parts[f"completion {one.name}"] = completions.make_part(one, one.completion)
        parts |= {
            f"example {one.name}": make_example(one),
            f"exercise {one.name}": make_exercise(one),
        }
    if chapter.kind == REQUIRED:
        task = load_open_task(chapter.stem)
        parts["open task"] = open_tasks.make_open_task(task, chapter)
    labels = HEADING.findall(text)
    due = [get_label(one.name) for one in chosen]
    if labels != due:
        raise ValueError(f"{chapter.exercises}: expected headings for {due}, got {labels}")
    return _fill(_place_groups(text, groups), parts, chapter.exercises)


def _place_groups(text: str, names: Iterable[str]) -> str:
    """Put an empty part for the heading of a group above the first exercise of each.

    Its completion, where it has one, belongs to it.
    """
    text = GROUP.sub("", text)
    for name in names:
        completion = f"<!-- begin completion {name} -->\n"
        first = completion if completion in text else f"({get_label(name)})=\n"
        mark = f"<!-- begin group {name} -->\n<!-- end group {name} -->\n\n"
        text = text.replace(first, f"{mark}{first}", 1)
    return text


def fill_chapter(text: str, exercises: Mapping[str, Exercise], chapter: Chapter) -> str:
    """Fill the marked part of a chapter, and the minutes of its card."""
    chosen = _require(exercises, chapter)
    filled = _fill(text, {"exercises": make_chapter_part(chosen, chapter)}, chapter.page)
    return fill_card(filled)


def _require(exercises: Mapping[str, Exercise], chapter: Chapter) -> list[Exercise]:
    chosen = select(exercises, chapter)
    if not chosen:
        raise ValueError(
            f"{chapter.id}: expected at least one exercise; "
            f"run make new-exercise NAME=... CHAPTER={chapter.id}"
        )
    ordered = [one for group in split_exercises(chosen) for one in group]
    if chosen != ordered:
        raise ValueError(
            f"{chapter.id}: expected challenges last, got {[one.name for one in chosen]}; "
            "change `place` on their cards"
        )
    return chosen


def _fill(text: str, parts: Mapping[str, str], where: str) -> str:
    found = [match["name"] for match in PART.finditer(text)]
    if found != list(parts):
        raise ValueError(f"{where}: expected the marked parts {list(parts)}, got {found}")
    return PART.sub(
        lambda match: (
            f"<!-- begin {match['name']} -->\n{parts[match['name']]}<!-- end {match['name']} -->\n"
        ),
        text,
    )
