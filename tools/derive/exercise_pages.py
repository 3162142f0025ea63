"""Write the parts of a page that follow from the cards: set-up, example, starter, check, points.

A marked part lies between two comments. Everything else on a page is written by hand. A page that
lacks a part, or has one that no card asks for, is refused.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from content.chapters import REQUIRED
from content.open_tasks import load_open_task
from tools.derive import completions, open_tasks
from tools.derive.starters import make_starter

if TYPE_CHECKING:
    from collections.abc import Mapping

    from content.chapters import Chapter
    from solutions import Exercise

PART = re.compile(r"<!-- begin (?P<name>[\w ]+) -->\n.*?<!-- end (?P=name) -->\n", re.DOTALL)
HEADING = re.compile(r"^\(exercise-([a-z-]+)\)=\n## ", re.MULTILINE)

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

#: Minutes, a rough guess for planning: an exercise of the lab, and a challenge.
LAB_MINUTES, CHALLENGE_MINUTES = 20, 30


def select(exercises: Mapping[str, Exercise], chapter: Chapter) -> list[Exercise]:
    """Return the exercises of a chapter."""
    return [one for one in exercises.values() if one.chapter == chapter.id]


def describe_points(exercise: Exercise) -> str:
    """Say what an exercise earns."""
    if exercise.is_challenge:
        return "challenge"
    return f"{exercise.points} points" if exercise.points else "exercise without points"


def _add_points(exercise: Exercise, form: str) -> str:
    """Return a link to an exercise, with its points where it has some."""
    return make_link(exercise) + (form.format(exercise.points) if exercise.points else "")


def get_label(name: str) -> str:
    """Return the label above the heading of an exercise."""
    return f"exercise-{name.replace('_', '-')}"


def make_link(exercise: Exercise) -> str:
    """Return a link to an exercise, from any page."""
    return f"{{ref}}`{exercise.name} <{get_label(exercise.name)}>`"


def make_exercise(exercise: Exercise) -> str:
    """Write what follows the statement: facts, starter, check and the way to a hint."""
    label = exercise.section
    objectives = ", ".join(f"**{name}**" for name in exercise.objectives)
    return f"""\
*{describe_points(exercise).capitalize()}. Practices {objectives}; taught in {{ref}}`{label}`.*

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


def make_card(exercises: list[Exercise], chapter: Chapter) -> str:
    """Write the table at the top of an exercise page."""
    lab = [one for one in exercises if not one.is_challenge]
    challenges = [one for one in exercises if one.is_challenge]
    minutes = LAB_MINUTES * len(lab) + CHALLENGE_MINUTES * len(challenges)
    links = ", ".join(_add_points(one, " {}") for one in lab)
    if chapter.is_extension:
        rows = ["| Points | none: an extension of the lab |"]
        rows += [f"| Exercises | {links} |"] if lab else []
    elif lab:
        rows = [f"| Points | {sum(one.points for one in lab)}: {links} |"]
    else:
        rows = [f"| Points | none: this {chapter.noun} has challenges only |"]
    if challenges:
        rows.append(f"| Challenges | {', '.join(map(make_link, challenges))} |")
    rows += [
        f"| Time | about {minutes} minutes |",
        f"| Needed before | [{chapter.name}](../{chapter.page}.md) |",
    ]
    return "\n".join(["| | |", "|---|---|", *rows]) + "\n"


def make_chapter_part(exercises: list[Exercise], chapter: Chapter) -> str:
    """Write the sentences of a chapter that lead to its exercises."""
    lab = [one for one in exercises if not one.is_challenge]
    challenges = ", ".join(make_link(one) for one in exercises if one.is_challenge)
    links = ", ".join(_add_points(one, " ({} points)") for one in lab)
    own = (
        f"write the functions of this {chapter.noun} yourself: {links}"
        if lab
        else "go beyond the lab"
    )
    whose = "" if lab else f" of this {chapter.noun}"
    more = f" The challenges{whose} ask for what the library does not have: {challenges}."
    return (
        f"On the [exercise page](../{chapter.exercises}.md) you {own}."
        f"{more if challenges else ''}\n"
    )


def fill_page(text: str, exercises: Mapping[str, Exercise], chapter: Chapter) -> str:
    """Fill the marked parts of an exercise page."""
    chosen = _require(exercises, chapter)
    parts = {"card": make_card(chosen, chapter), "set up": SET_UP}
    for one in chosen:
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
    due = [get_label(one.name).removeprefix("exercise-") for one in chosen]
    if labels != due:
        raise ValueError(f"{chapter.exercises}: expected headings for {due}, got {labels}")
    return _fill(text, parts, chapter.exercises)


def fill_chapter(text: str, exercises: Mapping[str, Exercise], chapter: Chapter) -> str:
    """Fill the marked part of a chapter."""
    chosen = _require(exercises, chapter)
    return _fill(text, {"exercises": make_chapter_part(chosen, chapter)}, chapter.page)


def _require(exercises: Mapping[str, Exercise], chapter: Chapter) -> list[Exercise]:
    chosen = select(exercises, chapter)
    if not chosen:
        raise ValueError(
            f"{chapter.id}: expected at least one exercise; "
            f"run make new-exercise NAME=... CHAPTER={chapter.id}"
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
