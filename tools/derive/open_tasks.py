"""Write the section of an exercise page that asks for an open task."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from content.chapters import Chapter
    from content.open_tasks import OpenTask


def get_label(chapter: Chapter) -> str:
    """Return the label above the heading of an open task."""
    return f"open-task-{chapter.id}"


def make_open_task(task: OpenTask, chapter: Chapter) -> str:
    """Return the section: what to do, what to hand in, what is looked at."""
    objectives = ", ".join(f"**{name}**" for name in task.objectives)
    criteria = "\n".join(f"| {name} | {asks.strip()} |" for name, asks in task.criteria.items())
    return f"""\
({get_label(chapter)})=
## Open task: {task.title}

*No points, about {task.minutes} minutes. Practices {objectives}. No program can check this one: \
it has many good answers, and somebody has to read yours.*

{task.task}

Work in the cells of [{chapter.name.lower()}](../{chapter.page}.md), or in a notebook of your own. \
Hand in three things:

- **A figure:** {task.figure}.
- **A number:** {task.number}.
- **A paragraph:** {task.paragraph}.

| What is looked at | It is good when |
|---|---|
{criteria}
"""
